/// \file
/// The space that a tetrahedralization lives in: all of R^3, or a torus. The topological policies of the one
/// kernel.
///
/// A *corner* of a tetrahedron is a vertex, and on a torus which of its copies. The *frame* of a tetrahedron
/// is where its corners say it is: seen from the frame of a neighbour it may be some whole periods away, and
/// so is every point. A *shift* says by how much. In R^3 there is one frame: shifts are empty, and all that
/// is done with them compiles to nothing.
#pragma once

#include <array>
#include <cassert>

#include "base/pod_vector.hpp"
#include "delaunay/store.hpp"

namespace unsliver::delaunay {

/// R^3: corners are vertices.
struct Bounded {
  template <class Point>
  using Seen = const Point&;  ///< what is returned where a point is asked for
  struct Shift {};
  /// One shift for each tetrahedron of a cavity.
  struct Shifts {
    void clear() {}
    void push_back(Shift) {}
    void push_back_if(bool, Shift) {}
    Shift operator[](std::size_t) const { return {}; }
  };

  static VertexId vertex_of(VertexId corner) { return corner; }
  template <class Point>
  static const Point& place(const Point& p, VertexId) {
    return p;
  }
  static Shift across(const TetRecord&, int, const TetRecord&) { return {}; }
  static Shift sum(Shift, Shift) { return {}; }
  template <class Point>
  static const Point& seen_from(const Point& p, Shift) {
    return p;
  }
  static const Vec3& seen_back(const Vec3& p, Shift) { return p; }
  template <class Point>
  static const Point& home_of(const Point& p) {
    return p;
  }
  template <class Point>
  static Shift shift_from_home(const Point&) {
    return {};
  }
  template <class Point>
  static void approach(Point&, const Vec3&) {}
  static void place_apex(VertexId (&)[4], Shift, Shift) {}
};

/// The torus R^3 / (period.x Z x period.y Z x period.z Z), in one sheet: every vertex once, at its copy in
/// [0, period), its *home*. A corner is a vertex in the lower 29 bits and above them, one bit an axis,
/// whether it is the copy one period further along it.
///
/// Why one bit is enough: requires at all times that every empty ball has a diameter below half the shortest
/// period. Tetrahedra are then narrower than that. Along each axis the least corner can be put into
/// [0, period), and no corner is a whole period beyond it; and tetrahedra, facets and edges are told by their
/// vertices alone, so that the tetrahedralization is a simplicial complex. No insertion enlarges an empty
/// ball. The conflict region of a point, and what surrounds it, holds no tetrahedron twice: two copies of a
/// vertex, both nearer to the point than half a period, would be less than a period apart.
class Torus {
 public:
  template <class Point>
  using Seen = Point;
  /// In periods.
  struct Shift {
    std::int8_t x = 0, y = 0, z = 0;
  };
  using Shifts = PodVector<Shift>;

  /// Requires: positive integers, at most 2^46.
  explicit Torus(const Vec3& period = {1, 1, 1}) : period_(period) {
    for (unsigned bits = 0; bits < 8; ++bits)
      copies_[bits] = {bits & 1 ? period.x : 0, bits & 2 ? period.y : 0, bits & 4 ? period.z : 0};
  }

  const Vec3& period() const { return period_; }

  static VertexId vertex_of(VertexId corner) { return corner & kVertexMask; }
  static Shift shift_of(VertexId corner) {
    const auto bit = [corner](unsigned axis) { return std::int8_t(corner >> (kVertexBits + axis) & 1); };
    return {bit(0), bit(1), bit(2)};
  }
  /// Where the corner is, given its vertex's home.
  Vec3 place(const Vec3& home, VertexId corner) const { return home + copies_[corner >> kVertexBits]; }

  /// The frame of `to` as seen from that of `from`, its neighbour across the facet at `slot`.
  static Shift across(const TetRecord& from, int slot, const TetRecord& to) {
    const VertexId all =
        from.v[0] | from.v[1] | from.v[2] | from.v[3] | to.v[0] | to.v[1] | to.v[2] | to.v[3];
    if (all <= kVertexMask) [[likely]]
      return {};
    const VertexId shared = from.v[(slot + 1) & 3];
    int there = 0;
    while (vertex_of(to.v[there]) != vertex_of(shared)) ++there;
    return difference(shift_of(shared), shift_of(to.v[there]));
  }
  static Shift sum(Shift a, Shift b) {
    return {std::int8_t(a.x + b.x), std::int8_t(a.y + b.y), std::int8_t(a.z + b.z)};
  }
  /// p as seen from a frame that is `shift` away.
  Vec3 seen_from(const Vec3& p, Shift shift) const {
    return {p.x - shift.x * period_.x, p.y - shift.y * period_.y, p.z - shift.z * period_.z};
  }

  /// What is seen as p from a frame that is `shift` away, as it is seen from here.
  Vec3 seen_back(const Vec3& p, Shift shift) const { return seen_from(p, difference({}, shift)); }

  /// The copy of p in [0, period).
  Vec3 home_of(const Vec3& p) const { return seen_from(p, shift_from_home(p)); }
  /// How far p is from its home.
  Shift shift_from_home(const Vec3& p) const {
    return {whole(p.x, period_.x), whole(p.y, period_.y), whole(p.z, period_.z)};
  }
  /// Puts p at its copy nearest to q along each axis.
  void approach(Vec3& p, const Vec3& q) const {
    const Vec3 d = p - q + 0.5 * period_;
    p = seen_from(p, {whole(d.x, period_.x), whole(d.y, period_.y), whole(d.z, period_.z)});
  }

  /// Completes the corners of a tetrahedron whose first three are a facet in its own frame, which is `frame`
  /// away, and whose apex, given as its vertex, is `from_home` away from its home.
  static void place_apex(VertexId (&v)[4], Shift frame, Shift from_home) {
    const Shift at = difference(from_home, frame);
    if ((at.x | at.y | at.z) == 0 && v[3] <= kVertexMask && (v[0] & v[1] & v[2]) <= kVertexMask) [[likely]]
      return;
    std::array<Shift, 4> shifts{shift_of(v[0]), shift_of(v[1]), shift_of(v[2]), at};
    pack(v, shifts);
  }
  /// Corners of these vertices from their shifts, in the frame where the least shift along each axis is 0.
  static void pack(VertexId (&v)[4], const std::array<Shift, 4>& shifts) {
    Shift least = shifts[0];
    for (const Shift& s : shifts)
      least = {std::min(least.x, s.x), std::min(least.y, s.y), std::min(least.z, s.z)};
    for (std::size_t i = 0; i < 4; ++i) {
      const Shift s = difference(shifts[i], least);
      assert((s.x | s.y | s.z) <= 1);
      v[i] = vertex_of(v[i]) | VertexId(s.x | s.y << 1 | s.z << 2) << kVertexBits;
    }
  }

 private:
  static constexpr unsigned kVertexBits = 29;  // 2^30 tetrahedra, the store's limit, have fewer vertices
  static constexpr VertexId kVertexMask = (VertexId{1} << kVertexBits) - 1;

  static Shift difference(Shift a, Shift b) {
    return {std::int8_t(a.x - b.x), std::int8_t(a.y - b.y), std::int8_t(a.z - b.z)};
  }
  static std::int8_t whole(double x, double period) { return std::int8_t(std::floor(x / period)); }

  Vec3 period_;
  std::array<Vec3, 8> copies_;  ///< by the bits above the vertex
};

}  // namespace unsliver::delaunay
