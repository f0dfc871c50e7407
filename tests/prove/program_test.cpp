// What was proved is what the program does: its constants against the proofs' enclosures, its templates
// against the tetrahedra that the enumeration of neighbourhoods allows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "lattice/forbidden_region.hpp"
#include "octree/template.hpp"
#include "prove/cells.hpp"
#include "prove/constants.hpp"
#include "refine/guarantees.hpp"

namespace unsliver::prover {
namespace {

double lower(const Enclosure& x) { return std::ldexp(double(x.lo()), -Enclosure::kBits); }
double upper(const Enclosure& x) { return std::ldexp(double(x.hi()), -Enclosure::kBits); }

void expect_is(const Enclosure& x, double value) {
  EXPECT_GE(value, lower(x));
  EXPECT_LE(value, upper(x));
}

TEST(Program, ItsLatticesHaveTheLengthsOfProposition4) {
  expect_is(square_root(Fraction{3, 4}), lattice::covering_radius(1));
  expect_is(square_root(Fraction{5, 4}), lattice::covering_radius(2));
  expect_is(1, lattice::shortest_distance(1));
  expect_is(square_root(3), lattice::shortest_distance(2));
}

TEST(Program, ItsForbiddenRegionIsThatOfTheorem8) {
  const Roots r;
  expect_is(r.sigma, lattice::kSigma);
  expect_is(r.rho, lattice::kRho);
}

TEST(Program, ItsGradingConstantsAreOnTheSafeSide) {
  const Roots r;
  const Figure8Constants k(r);
  expect_is(Enclosure(2) * r.root3 + r.root5, refine::kFigure5A);
  expect_is(r.root3 + r.root5, refine::kFigure5B);
  expect_is(r.root3 + r.root2, refine::kClosureA);
  expect_is(r.root3 / Enclosure(2) + r.root2, refine::kClosureB);
  // Smaller budgets promise more. b may be anything from (a + sqrt 5)/2 to alpha - sqrt 3.
  EXPECT_LE(refine::kFigure8Alpha, lower(k.alpha));
  EXPECT_LE(refine::kFigure8A, lower(k.a));
  EXPECT_GE(refine::kFigure8B, (refine::kFigure8A + upper(r.root5)) / 2);
  EXPECT_LE(refine::kFigure8B, refine::kFigure8Alpha - upper(r.root3));
  EXPECT_LE(refine::kFigure8Grading, 1 / (1 + refine::kFigure8A));
  EXPECT_LE(refine::kFigure8Grading, 1 / (1 + 2 * refine::kFigure8B / lower(r.sigma)));
  EXPECT_LE(refine::kFigure5LiteralC, 2.791);
  EXPECT_LE(refine::kFigure5ThriftyC, 3.936);
  EXPECT_LE(refine::kClosureC, 1.987);
  EXPECT_LE(refine::kFigure8LiteralC, 15.634);
}

/// A key as random forests might have them, and others: any that the rules allow.
octree::Key random_key(std::mt19937_64& random) {
  std::uint64_t bits = 0, edges = random() & random() & 0xfff;
  for (int face = 0; face < 6; ++face) {
    const std::uint64_t state = random() % 4;
    bits |= octree::Key::face_bits(face, state, state == octree::kHalved ? random() & 15 : 0);
    if (state != octree::kHalved) continue;
    for (int e = 0; e < 12; ++e) {
      const auto at = octree::slot_position(octree::kEdgeSlots[std::size_t(e)], false);
      if (at[std::size_t(face >> 1)] == 4 * (face & 1)) edges |= octree::Key::edge_bit(e);
    }
  }
  const bool has_center = edges != 0 || random() % 2 == 0;
  return octree::Key(bits | edges | (has_center ? octree::Key::center_bit() : 0));
}

TEST(Program, ItsTemplatesAreAmongTheTetrahedraThatWereProved) {
  const std::set<Tetrahedron> proved = cell_tetrahedra({.may_end = true});
  std::mt19937_64 random(7);
  std::set<Tetrahedron> met;
  for (int i = 0; i < 1000; ++i) {
    const octree::Key key = random_key(random);
    for (const auto& slots : octree::solve_template(key).tets) {
      Tetrahedron t;
      for (std::size_t c = 0; c < 4; ++c) {
        const auto at = octree::slot_position(slots[c], octree::is_halved_slot(key, slots[c]));
        t[c] = {at[0], at[1], at[2]};
      }
      std::sort(t.begin(), t.end());
      EXPECT_TRUE(proved.contains(t)) << "key " << key.bits() << ": " << text(t);
      met.insert(t);
    }
  }
  EXPECT_GT(met.size(), proved.size() / 3);
}

}  // namespace
}  // namespace unsliver::prover
