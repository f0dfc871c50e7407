/// \file
/// Is a leaf small enough, and where does it lie? The sound tests behind the size and coverage guarantees.
///
/// Notation. C is a leaf of side h and R a radius: h sqrt(5)/4 if C has its centre as a vertex, h sqrt(3)/2
/// if not. Every point of C is within R of a vertex of C, and every tetrahedron that C owns has a
/// circumradius of at most R. D(C) is the rhombic dodecahedron made of C and the pyramids of height h/2 on
/// its faces: the hull of C's slots, it holds all tetrahedra that C owns. It lies in the ball of radius h
/// about C's centre.
///
/// For each p in the domain some vertex of the kept tetrahedra must be within s(p). Let p lie in leaf C.
/// - Ball(center of C, h) inside the domain (kInside): all vertices of C are kept, and own points decide.
/// - Else p is in a kept tetrahedron t, owned by C or by a face neighbour C', and a corner of t is within
///   sqrt(R'^2 - |p - c|^2) of p, c in C' being its circumcentre. So each leaf with such a neighbour must
///   satisfy (E): s(p)^2 >= R^2 - dist(p, C)^2 for all p of the domain in D(C).
/// A leaf whose ball of radius 3.67 h lies inside the domain (kDeep) has no such neighbour: the neighbour's
/// side is at most 2h, its centre at most 1.67 h away. It needs less: (A) s(p) >= the distance from p to the
/// vertices of C, for p in C.
///
/// Beside guests (octree/guest.hpp), who may leave vertices out, a leaf counts as deep only if no guest is
/// within 3.67 h of its centre either.
///
/// Where the domain is the forest's brick itself, all tetrahedra are kept: all nodes are kWholeInside.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geom/point_tree.hpp"
#include "lattice/world.hpp"
#include "octree/forest.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver::octree {

/// The flags of all nodes of a brick that is its own domain.
inline constexpr std::uint8_t kWholeInside = kInside | kDeep;

enum class Verdict { kSplit, kWithCenter, kPlain };

struct LeafTestCounts {
  std::uint64_t domain_tests = 0, size_evaluations = 0;

  void operator+=(const LeafTestCounts& other) {
    domain_tests += other.domain_tests;
    size_evaluations += other.size_evaluations;
  }
};

/// Counts, so that threads need copies of their own.
class LeafTest {
 public:
  /// The guarantee is enforced for this share of s, so that no rounding can break it for s.
  static constexpr double kSizeShare = 1 - 1e-6;

  /// The arguments must outlive the test. `guests`: their places (world), or nullptr.
  LeafTest(const Domain& domain, const Sizing& sizing, const lattice::World& world,
           const geom::PointTree* guests = nullptr);

  /// Flags of a node, given its parent's (0 for roots).
  std::uint8_t flags(const Cell& cell, std::uint8_t parent_flags);
  /// May the node be a leaf, and does it then need its centre?
  Verdict judge(const Cell& cell, std::uint8_t flags);

  const lattice::World& world() const { return world_; }
  const LeafTestCounts& counts() const { return counts_; }

 private:
  struct Box {
    Vec3 center;  ///< relative to the leaf's centre, in units of h
    double half;
  };

  Verdict judge_deep(const Cell& cell);
  bool holes_covered(const Vec3& center, double h);
  bool face_covered(const Vec3& face_center, int axis, double h);
  bool satisfies_e(const Cell& cell, std::uint8_t flags, double radius);
  bool refuted_by_center(const Box& box, int side, const Vec3& x, double h, double radius);
  double size_at(const Vec3& x);
  double size_over(const Box3& box);
  int side_of_ball(const Vec3& x, double radius);
  bool is_remote(const Cell& cell) const;

  const Domain& domain_;
  const Sizing& sizing_;
  const lattice::World& world_;
  const geom::PointTree* guests_;
  Box3 bounds_;
  double unit_, lipschitz_, least_;
  double plain_share_, hole_share_;
  LeafTestCounts counts_;
};

}  // namespace unsliver::octree
