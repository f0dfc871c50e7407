// What a size proof rests on is in the result.
#include "refine/extract.hpp"

#include <gtest/gtest.h>

#include "refine/closure.hpp"

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
  while (want_dropped_proofs(r)) continue;
  const TetMesh before = extract_superset(r);
  VertexId dropped = kNoVertex;
  for (VertexId v = 9; v <= r.mesh().vertex_count() && dropped == kNoVertex; ++v)
    if (!has_point(before, r.output_position(v))) dropped = v;
  ASSERT_NE(dropped, kNoVertex);
  EXPECT_FALSE(want_dropped_proofs(r));
  r.rely_on(dropped);
  EXPECT_TRUE(want_dropped_proofs(r));
  EXPECT_FALSE(want_dropped_proofs(r));
  const TetMesh after = extract_superset(r);
  EXPECT_TRUE(has_point(after, r.output_position(dropped)));
  EXPECT_GT(after.tets.size(), before.tets.size());
}

}  // namespace
}  // namespace unsliver::refine
