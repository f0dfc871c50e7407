// One template against the kernel on the same few points.
#include "octree/template.hpp"

#include <gtest/gtest.h>

#include <set>

#include "delaunay/triangulation.hpp"
#include "octree/random_forest.hpp"

namespace unsliver::octree {
namespace {

/// Keys that occur in random balanced forests.
std::set<std::uint64_t> keys_of_forests() {
  std::set<std::uint64_t> keys;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    Forest forest = test::random_forest(test::plan_of(seed), seed);
    const auto collect = [&](const auto& self, const Block& block, int place, const Cell& cell) -> void {
      if (forest[cell.node].is_leaf()) {
        keys.insert(key_of({forest, block, place, cell}).bits());
        return;
      }
      const Block inner = child_block(forest, block, place);
      for (int i = 0; i < 8; ++i) self(self, inner, place_of_child(i), forest.child(cell, i));
    };
    const auto n = forest.brick().count;
    for (int i = 0; i < n[0] * n[1] * n[2]; ++i) {
      const int x = i % n[0], y = i / n[0] % n[1], z = i / n[0] / n[1];
      collect(collect, root_block(forest, x, y, z), kFirstPlace, forest.root_cell(x, y, z));
    }
  }
  return keys;
}

Vec3 position(Key key, int slot) {
  const auto at = slot_position(slot, is_halved_slot(key, slot));
  return {double(at[0]), double(at[1]), double(at[2])};
}

Vec3 circumcenter(const Tet& t) {
  const Vec3 b = t[1] - t[0], c = t[2] - t[0], d = t[3] - t[0];
  const Vec3 n = norm_sq(b) * cross(c, d) + norm_sq(c) * cross(d, b) + norm_sq(d) * cross(b, c);
  return t[0] + (0.5 / dot(b, cross(c, d))) * n;
}

/// The kernel's tetrahedra with circumcentres in the leaf, [0, 4)^3; beyond it at the ends of the brick. The
/// coordinates are small integers: a circumcentre on a face of the leaf comes out exact or within 1e-12.
std::vector<Tet> expected_tets(Key key) {
  std::vector<Vec3> points;
  for (const int slot : occupied_slots(key)) points.push_back(position(key, slot));
  delaunay::Triangulation dt;
  dt.insert_all(points);
  std::vector<Tet> tets;
  for (delaunay::TetId t = 0; t < dt.slot_count(); ++t) {
    if (!dt.is_finite(t)) continue;
    const Vec3 center = circumcenter(dt.corners(t));
    bool owned = true;
    for (int axis = 0; axis < 3; ++axis) {
      owned = owned && (center[axis] > -1e-12 || key.face(2 * axis) == kBrickEnd);
      owned = owned && (center[axis] < 4 - 1e-12 || key.face(2 * axis + 1) == kBrickEnd);
    }
    if (owned) tets.push_back(dt.corners(t));
  }
  return test::sorted(tets);
}

TEST(Template, IsTheLocalDelaunayTetrahedralization) {
  const std::set<std::uint64_t> keys = keys_of_forests();
  EXPECT_GT(keys.size(), 1000u);
  for (const std::uint64_t bits : keys) {
    SCOPED_TRACE("key " + std::to_string(bits));
    const Key key(bits);
    std::vector<Tet> tets;
    for (const auto& t : solve_template(key).tets)
      tets.push_back({position(key, t[0]), position(key, t[1]), position(key, t[2]), position(key, t[3])});
    EXPECT_EQ(test::sorted(tets), expected_tets(key));
  }
}

TEST(Template, OfAUniformNeighbourhoodIsTheBodyCentredTetrahedralization) {
  std::uint64_t bits = Key::center_bit();
  for (int f = 0; f < 6; ++f) bits |= Key::face_bits(f, kCentered, 0);
  const Template made = solve_template(Key(bits));
  EXPECT_EQ(made.tets.size(), 12u);  // circumcentres on faces: those of the three lower ones are its own
  EXPECT_EQ(made.slots.size(), 7u + 1 + 3);
}

TEST(Slots, TheTablesAgreeWithThePositions) {
  for (int face = 0; face < 6; ++face) {
    const auto at = slot_position(face_slot(face), false);
    EXPECT_EQ(at[std::size_t(face / 2)], face % 2 == 0 ? 0 : 4);
    EXPECT_EQ(middle_count(face_slot(face)), 2);
    for (int j = 0; j < 4; ++j) {
      // The child's centre, from the neighbour's lower corner and the child's number.
      const int child = child_at_face(face, j);
      const auto center = slot_position(beyond_slot(face, j), true);
      for (int axis = 0; axis < 3; ++axis) {
        const int shift = axis != face / 2 ? 0 : face % 2 == 0 ? -4 : 4;
        EXPECT_EQ(center[std::size_t(axis)], shift + 1 + 2 * (child >> axis & 1));
      }
    }
  }
}

}  // namespace
}  // namespace unsliver::octree
