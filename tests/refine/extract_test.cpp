// What a size proof rests on is in the result.
#include "refine/extract.hpp"

#include <gtest/gtest.h>

#include "refine/closure.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::refine {
namespace {

bool has_point(const TetMesh& mesh, const Vec3& p) {
  return std::find(mesh.points.begin(), mesh.points.end(), p) != mesh.points.end();
}

TEST(Extract, KeepsTheVerticesOfProofs) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const SizingPtr size = constant_size(0.3);
  MeshOptions options;
  options.strategy = Strategy::kClosure;
  const Control control;
  Refinement r(*ball, *size, {}, options, control);
  closure(r);
  while (want_dropped_proofs(r, Extraction(r))) continue;
  const TetMesh before = extract_superset(r, Extraction(r));
  VertexId dropped = kNoVertex;
  for (VertexId v = 9; v <= r.mesh().vertex_count() && dropped == kNoVertex; ++v)
    if (!has_point(before, r.output_position(v))) dropped = v;
  ASSERT_NE(dropped, kNoVertex);
  EXPECT_FALSE(want_dropped_proofs(r, Extraction(r)));
  r.rely_on(dropped);
  EXPECT_TRUE(want_dropped_proofs(r, Extraction(r)));
  EXPECT_FALSE(want_dropped_proofs(r, Extraction(r)));
  const TetMesh after = extract_superset(r, Extraction(r));
  EXPECT_TRUE(has_point(after, r.output_position(dropped)));
  EXPECT_GT(after.tets.size(), before.tets.size());
}

/// Each phase is timed once in a row, also where it is entered again.
TEST(Extract, IsTheLastPhaseOfEveryStrategy) {
  for (const Strategy strategy : {Strategy::kLiteral, Strategy::kThrifty, Strategy::kClosure}) {
    SCOPED_TRACE(to_string(strategy));
    MeshOptions options;
    options.strategy = strategy;
    const MeshResult result = mesh_domain(*make_ball({0, 0, 0}, 1), *constant_size(0.3), options);
    const auto& phases = result.stats.phases;
    ASSERT_FALSE(phases.empty());
    EXPECT_EQ(phases.back().name, "extract");
    for (std::size_t i = 1; i < phases.size(); ++i) EXPECT_NE(phases[i].name, phases[i - 1].name);
  }
}

}  // namespace
}  // namespace unsliver::refine
