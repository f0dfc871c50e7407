// The kernel's set of vertices under the closure strategy: closed under parents, graded, and small.
#include "refine/closure.hpp"

#include <gtest/gtest.h>

#include "lattice/parents.hpp"
#include "refine/guarantees.hpp"
#include "refine/refinement.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {
namespace {

SizingPtr shell(double least, double gradation, const Domain& domain) {
  return expression_size(
      std::to_string(least) + " + " + std::to_string(gradation) + " * abs(sqrt(x^2 + y^2 + z^2) - 0.6)",
      domain.bounds());
}

MeshOptions with(Strategy strategy) {
  MeshOptions options;
  options.strategy = strategy;
  return options;
}

bool is_vertex(const Refinement& r, const Vec3& p) {
  return r.mesh().corner_at(r.mesh().locate(p), p) != kNoVertex;
}

TEST(Closure, TheParentsOfEveryVertexAreVertices) {
  const DomainPtr ball = make_ball({0.1, 0, 0}, 1);
  const MeshOptions options = with(Strategy::kClosure);
  for (const double gradation : {0.0, 0.1, 0.7}) {
    SCOPED_TRACE(gradation);
    const SizingPtr size = shell(0.05, gradation, *ball);
    const Control control;
    Refinement r(*ball, *size, {}, options, control);
    closure(r);
    std::size_t parents = 0;
    for (VertexId v = 1; v <= r.mesh().vertex_count(); ++v) {
      const Vec3 p = r.mesh().point(v);
      EXPECT_EQ(r.label(v), lattice::canonical_level(p));
      if (r.label(v) >= kTopLevel) continue;
      EXPECT_LE(r.lfs_bound(v), closure_budget(r.label(v)) * (1 + 1e-6));
      for (const Vec3& parent : lattice::Parents(p)) {
        EXPECT_TRUE(is_vertex(r, parent));
        ++parents;
      }
    }
    EXPECT_GT(parents, 1000U);
  }
}

TEST(Closure, TakesNoMoreVerticesThanFigure5Thrifty) {
  const DomainPtr ball = make_ball({0.1, 0, 0}, 1);
  for (const double gradation : {0.05, 0.2, 0.5}) {
    SCOPED_TRACE(gradation);
    const SizingPtr size = shell(0.03, gradation, *ball);
    const auto inside = [&](Strategy strategy) {
      const TetMesh mesh = mesh_domain(*ball, *size, with(strategy)).mesh;
      return std::count_if(mesh.points.begin(), mesh.points.end(),
                           [&](const Vec3& p) { return ball->contains(p); });
    };
    EXPECT_LE(double(inside(Strategy::kClosure)), 1.01 * double(inside(Strategy::kThrifty)));
  }
}

TEST(Closure, KnowsNoInputVertices) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const std::vector<Vec3> inputs{{0, 0, 0.1}};
  EXPECT_THROW(mesh_domain(*ball, *constant_size(1), inputs, with(Strategy::kClosure)), Error);
}

}  // namespace
}  // namespace unsliver::refine
