// The deep test. With L the Lipschitz constant of s, (A) follows from s at few points q: s(p) >= s(q) - L
// |pq|, so that s(q) >= max over p of (distance from p to the vertices) + L |pq| is enough. Both terms are
// convex in p as long as the nearest vertex is the same: the maximum is attained at a corner of a polytope.
// - Without centre, q = the centre, p in a cube of side h/2 at the nearest corner. Its corners at distance d
//   from the vertex and e from q, in units of h: (sqrt 3/2, 0), (sqrt 2/2, 1/2), (1/2, sqrt 2/2), (0, sqrt
//   3/2).
// - With centre, the deepest holes are the 24 points at distance h/4 from a face's centre along an axis. By
//   symmetry p is in the polytope 0 <= z <= y <= x <= 1/2, x + y + z <= 3/4 with the vertex at 0, q the hole
//   (1/2, 1/4, 0). Its corners: 0, (1/2,0,0), (1/2,1/4,0), (3/8,3/8,0), (1/2,1/8,1/8), (1/4,1/4,1/4).
#include "octree/leaf_test.hpp"

#include <algorithm>
#include <cmath>

namespace unsliver::octree {
namespace {

using lattice::kHalfSqrt3;
using lattice::kQuarterSqrt5;

constexpr double kRounding = 1e-12;
/// Above this Lipschitz constant the deep test asks for too much.
constexpr double kGentle = 1.1;
/// See the header: sqrt(1.5^2 + 0.5^2 + 0.5^2) + 2, rounded up.
constexpr double kDeepReach = 3.67;
/// Boxes are halved this often before a leaf counts as too large.
constexpr int kBoxDepth = 3;

/// max of d + L e over the corners of the polytopes above.
double plain_share(double lipschitz) {
  return std::max({kHalfSqrt3, std::sqrt(0.5) + 0.5 * lipschitz, 0.5 + std::sqrt(0.5) * lipschitz,
                   kHalfSqrt3 * lipschitz});
}
double hole_share(double lipschitz) {
  const double bevel = std::sqrt(9.0 / 32), to_bevel = std::sqrt(1.0 / 32);
  return std::max({kQuarterSqrt5, bevel + to_bevel * lipschitz, 0.5 + 0.25 * lipschitz,
                   std::sqrt(3.0) / 4 + std::sqrt(1.0 / 8) * lipschitz, kQuarterSqrt5 * lipschitz});
}

double square(double x) { return x * x; }

/// Does the box meet D(C)? D(C) is where the two largest of |x|, |y|, |z| add up to at most h.
bool meets_dodecahedron(const Vec3& center, double half) {
  double least[3];
  for (int axis = 0; axis < 3; ++axis) least[axis] = std::max(0.0, std::abs(center[axis]) - half);
  return least[0] + least[1] + least[2] - std::min({least[0], least[1], least[2]}) < 1;
}

/// The least squared distance from a point of the box to C, in units of h.
double distance_to_leaf_sq(const Vec3& center, double half) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += square(std::max(0.0, std::abs(center[axis]) - half - 0.5));
  return sum;
}

}  // namespace

LeafTest::LeafTest(const Domain& domain, const Sizing& sizing, const lattice::World& world,
                   const geom::PointTree* guests)
    : domain_(domain),
      sizing_(sizing),
      world_(world),
      guests_(guests),
      bounds_(domain.bounds()),
      unit_(world.unit()),
      lipschitz_(sizing.lipschitz()),
      least_(kSizeShare * sizing.lower_bound(bounds_)),
      plain_share_(plain_share(lipschitz_)),
      hole_share_(hole_share(lipschitz_)) {}

std::uint8_t LeafTest::flags(const Cell& cell, std::uint8_t parent_flags) {
  std::uint8_t flags = parent_flags & (kInside | kOutside | kDeep);
  if ((flags & (kOutside | kDeep)) != 0) return flags;
  const Vec3 center = world_.to_caller(cell.center());
  const double h = double(cell.side()) * unit_;
  if (flags == 0) {
    const int side = side_of_ball(center, h);
    flags = side < 0 ? kInside : side > 0 ? kOutside : 0;
  }
  const bool may_be_deep = flags == kInside && lipschitz_ != 0;  // without effect where s is constant
  if (may_be_deep && is_remote(cell) && side_of_ball(center, kDeepReach * h) < 0) flags |= kDeep;
  return flags;
}

bool LeafTest::is_remote(const Cell& cell) const {
  return guests_ == nullptr || !guests_->has_within(cell.center(), kDeepReach * double(cell.side()), 1);
}

Verdict LeafTest::judge(const Cell& cell, std::uint8_t flags) {
  const double h = double(cell.side()) * unit_;
  if ((flags & kOutside) != 0 || kHalfSqrt3 * h <= least_) return Verdict::kPlain;
  if (lipschitz_ == 0) return kQuarterSqrt5 * h <= least_ ? Verdict::kWithCenter : Verdict::kSplit;
  if ((flags & kDeep) != 0 && lipschitz_ <= kGentle) return judge_deep(cell);
  if (!satisfies_e(cell, flags, kQuarterSqrt5 * h)) return Verdict::kSplit;
  return satisfies_e(cell, flags, kHalfSqrt3 * h) ? Verdict::kPlain : Verdict::kWithCenter;
}

Verdict LeafTest::judge_deep(const Cell& cell) {
  const Vec3 center = world_.to_caller(cell.center());
  const double h = double(cell.side()) * unit_, size = size_at(center);
  if (size >= plain_share_ * h) return Verdict::kPlain;
  if (size - lipschitz_ * kQuarterSqrt5 * h >= hole_share_ * h) return Verdict::kWithCenter;
  if (size + lipschitz_ * kQuarterSqrt5 * h < hole_share_ * h) return Verdict::kSplit;
  const Vec3 half{0.5 * h, 0.5 * h, 0.5 * h};
  const bool covered =
      size_over({center - half, center + half}) >= kQuarterSqrt5 * h || holes_covered(center, h);
  return covered ? Verdict::kWithCenter : Verdict::kSplit;
}

bool LeafTest::holes_covered(const Vec3& center, double h) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5}) {
      Vec3 face = center;
      face[axis] += side * h;
      if (!face_covered(face, axis, h)) return false;
    }
  return true;
}

/// The four holes on a face.
bool LeafTest::face_covered(const Vec3& face_center, int axis, double h) {
  const double size = size_at(face_center), step = 0.25 * h;
  if (size - lipschitz_ * step >= hole_share_ * h) return true;
  if (size + lipschitz_ * step < hole_share_ * h) return false;
  for (const int along : {(axis + 1) % 3, (axis + 2) % 3})
    for (const double side : {-1.0, 1.0}) {
      Vec3 hole = face_center;
      hole[along] += side * step;
      if (size_at(hole) < hole_share_ * h) return false;
    }
  return true;
}

/// Condition (E), by halving boxes. Yes is certain.
bool LeafTest::satisfies_e(const Cell& cell, std::uint8_t flags, double radius) {
  if (radius <= least_) return true;
  const Vec3 leaf_center = world_.to_caller(cell.center());
  const double h = double(cell.side()) * unit_;
  std::vector<Box> open{{{0, 0, 0}, 1}};
  while (!open.empty()) {
    const Box box = open.back();
    open.pop_back();
    if (!meets_dodecahedron(box.center, box.half)) continue;
    const Vec3 x = leaf_center + h * box.center;
    const double half = h * box.half * (1 + kRounding);
    const double demand_sq = radius * radius - h * h * distance_to_leaf_sq(box.center, box.half);
    const double size = size_over({x - Vec3{half, half, half}, x + Vec3{half, half, half}});
    if (size >= 0 && size * size >= demand_sq) continue;
    const int side = (flags & kInside) != 0 ? -1 : side_of_ball(x, std::sqrt(3.0) * half);
    if (side > 0) continue;
    if (refuted_by_center(box, side, x, h, radius)) return false;
    if (box.half < std::ldexp(1.0, -kBoxDepth) * 1.5) return false;
    for (int i = 0; i < 8; ++i) {
      const double q = 0.5 * box.half;
      open.push_back({box.center + Vec3{i & 1 ? q : -q, i & 2 ? q : -q, i & 4 ? q : -q}, q});
    }
  }
  return true;
}

/// Is the box's centre a point of the domain where (E) fails?
bool LeafTest::refuted_by_center(const Box& box, int side, const Vec3& x, double h, double radius) {
  if (!meets_dodecahedron(box.center, 0) || !bounds_.contains(x)) return false;
  if (side == 0 && !domain_.contains(x)) return false;
  const double size = size_at(x);
  return size * size < radius * radius - h * h * distance_to_leaf_sq(box.center, 0);
}

double LeafTest::size_at(const Vec3& x) {
  ++counts_.size_evaluations;
  return kSizeShare * sizing_.at(x);
}

/// A lower bound over the part of the box in the domain's bounds; infinite if there is none.
double LeafTest::size_over(const Box3& box) {
  Box3 part;
  for (int axis = 0; axis < 3; ++axis) {
    part.lo[axis] = std::max(box.lo[axis], bounds_.lo[axis]);
    part.hi[axis] = std::min(box.hi[axis], bounds_.hi[axis]);
  }
  if (part.empty()) return std::numeric_limits<double>::infinity();
  ++counts_.size_evaluations;
  return kSizeShare * sizing_.lower_bound(part);
}

int LeafTest::side_of_ball(const Vec3& x, double radius) {
  ++counts_.domain_tests;
  return domain_.side_of_ball(x, radius * (1 + kRounding));
}

}  // namespace unsliver::octree
