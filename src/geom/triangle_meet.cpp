#include <array>
#include <cmath>

#include "geom/triangle_orient.hpp"
#include "geom/triangle_shape.hpp"

namespace unsliver::geom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// The face opposite to corner i, so that corner i is on its positive side in a positively oriented
/// tetrahedron.
constexpr int kFace[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
constexpr int kEdge[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

double one_norm(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// Bounds of dot(axis, p) over some points.
template <std::size_t N>
std::array<double, 2> shadow(const Vec3& axis, const std::array<Vec3, N>& points) {
  double low = dot(axis, points[0]), high = low;
  for (std::size_t i = 1; i < N; ++i) {
    const double at = dot(axis, points[i]);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return {low, high};
}

template <std::size_t N>
std::array<Vec3, N> seen_from(const Vec3& origin, const std::array<Vec3, N>& points) {
  std::array<Vec3, N> seen;
  for (std::size_t i = 0; i < N; ++i) seen[i] = points[i] - origin;
  return seen;
}

/// The sides of the plane of t that the corners of s are on.
struct Sides {
  std::array<int, 3> of;
  bool all_off_one_side() const {
    return (of[0] > 0 && of[1] > 0 && of[2] > 0) || (of[0] < 0 && of[1] < 0 && of[2] < 0);
  }
  bool all_on() const { return of[0] == 0 && of[1] == 0 && of[2] == 0; }
};

Sides sides(const Triangle& t, const Triangle& s) {
  Sides result{};
  for (int i = 0; i < 3; ++i) result.of[i] = exact_orient3d(t[0], t[1], t[2], s[i]);
  return result;
}

/// Signs x, y, z (one may be 0) agree.
bool same_side(int x, int y, int z) { return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0); }

/// Closed segment against closed triangle, when p and q are not both in the triangle's plane.
bool segment_meets(const Vec3& p, const Vec3& q, const Triangle& t, int side_p, int side_q) {
  if (side_p * side_q > 0 || (side_p == 0 && side_q == 0)) return false;
  return same_side(exact_orient3d(p, q, t[0], t[1]), exact_orient3d(p, q, t[1], t[2]),
                   exact_orient3d(p, q, t[2], t[0]));
}

bool some_edge_meets(const Triangle& s, const Sides& sides_of_s, const Triangle& t) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (segment_meets(s[i], s[j], t, sides_of_s.of[i], sides_of_s.of[j])) return true;
  }
  return false;
}

/// A pair of axes on which the triangle's projection has area, or none when it is degenerate.
bool projection_axes(const Triangle& t, int& u, int& v) {
  const Vec3 n = area_vector(t);
  const Vec3 size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
  const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  u = (drop + 1) % 3, v = (drop + 2) % 3;
  return exact_orient2d(t[0], t[1], t[2], u, v) != 0;
}

/// In the plane of t: some edge of t has all of s on or beyond it (beyond strictly, if `strict`).
bool edge_of_separates(const Triangle& t, const Triangle& s, int u, int v, bool strict) {
  const int turn = exact_orient2d(t[0], t[1], t[2], u, v);
  for (int i = 0; i < 3; ++i) {
    bool separates = true;
    for (const Vec3& p : s) {
      const int side = turn * exact_orient2d(t[i], t[(i + 1) % 3], p, u, v);
      separates = separates && (strict ? side < 0 : side <= 0);
    }
    if (separates) return true;
  }
  return false;
}

bool coplanar_meet(const Triangle& s, const Triangle& t, bool touching_counts) {
  int u = 0, v = 0;
  if (!projection_axes(t, u, v)) return false;
  return !edge_of_separates(t, s, u, v, touching_counts) && !edge_of_separates(s, t, u, v, touching_counts);
}

}  // namespace

TetProbe::TetProbe(const Tet& tet, Extent extent)
    : tet_(tet),
      extent_(extent),
      box_(bounding_box(tet)),
      orientation_(exact_orient3d(tet[0], tet[1], tet[2], tet[3])) {
  for (int i = 0; i < 4; ++i) {
    const Vec3& a = tet[kFace[i][0]];
    outward_[i] = -orientation_ * cross(tet[kFace[i][1]] - a, tet[kFace[i][2]] - a);
  }
}

/// Is a gap from `low` up to `high` enough to part the extent from something closed? Exact values only.
bool TetProbe::apart(double low, double high) const {
  return extent_ == Extent::kInterior ? low <= high : low < high;
}

bool TetProbe::may_meet(const Box3& box) const {
  for (int axis = 0; axis < 3; ++axis)
    if (apart(box.hi[axis], box_.lo[axis]) || apart(box_.hi[axis], box.lo[axis])) return false;
  const Vec3 half = 0.5 * box.size(), center = box.center();
  for (int i = 0; i < 4; ++i) {
    const Vec3& n = outward_[i];
    const Vec3 offset = center - tet_[kFace[i][0]];
    const double reach = std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
    // The box's centre is rounded at the magnitude of its coordinates, all else at that of differences.
    const double size = std::abs(center.x) + std::abs(center.y) + std::abs(center.z) + one_norm(offset);
    if (dot(n, offset) - reach > 16 * kEpsilon * (reach + one_norm(n) * size)) return false;
  }
  return true;
}

bool TetProbe::may_meet(const Triangle& triangle) const {
  if (extent_ == Extent::kInterior && orientation_ == 0) return false;
  const Box3 box = bounding_box(triangle);
  for (int axis = 0; axis < 3; ++axis)
    if (apart(box.hi[axis], box_.lo[axis]) || apart(box_.hi[axis], box.lo[axis])) return false;
  return !face_separates(triangle) && !plane_separates(triangle) && !edges_separate(triangle);
}

/// A face's plane has all of the triangle outside.
bool TetProbe::face_separates(const Triangle& triangle) const {
  if (orientation_ == 0) return false;
  for (const auto& f : kFace) {
    bool separates = true;
    for (int i = 0; separates && i < 3; ++i) {
      const int side = orientation_ * exact_orient3d(tet_[f[0]], tet_[f[1]], tet_[f[2]], triangle[i]);
      separates = apart(side, 0);
    }
    if (separates) return true;
  }
  return false;
}

/// The triangle's plane has all of the tetrahedron on one side.
bool TetProbe::plane_separates(const Triangle& triangle) const {
  bool above = true, below = true, on = true;
  for (const Vec3& p : tet_) {
    const int side = exact_orient3d(triangle[0], triangle[1], triangle[2], p);
    above = above && apart(0, side);
    below = below && apart(side, 0);
    on = on && side == 0;
  }
  return !on && (above || below);
}

/// Some plane parallel to an edge of each separates. First by their rounded cross product: any axis may
/// separate.
bool TetProbe::edges_separate(const Triangle& triangle) const {
  const Tet t = seen_from(triangle[0], tet_);
  const Triangle s = seen_from(triangle[0], triangle);
  double size = 0;
  for (const Vec3& p : t) size = std::max(size, one_norm(p));
  for (const Vec3& p : s) size = std::max(size, one_norm(p));
  for (const auto& e : kEdge) {
    const Vec3 along = t[e[1]] - t[e[0]];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Vec3 axis = cross(along, s[j] - s[i]);
      const auto [t_low, t_high] = shadow(axis, t);
      const auto [s_low, s_high] = shadow(axis, s);
      const double rounding = 8 * kEpsilon * one_norm(axis) * size;
      const double gap = std::max(t_low - s_high, s_low - t_high);
      if (gap > rounding) return true;
      if (gap >= -rounding && extent_ == Extent::kInterior &&
          touch_separates({tet_[e[0]], tet_[e[1]]}, {triangle[i], triangle[j]}, triangle))
        return true;
    }
  }
  return false;
}

/// The plane parallel to both edges has the tetrahedron on one side, the triangle on the other, each perhaps
/// on it.
bool TetProbe::touch_separates(const ExactStep& e, const ExactStep& f, const Triangle& triangle) const {
  bool above = false, below = false;
  for (const Vec3& p : tet_)
    for (const Vec3& q : triangle) {
      const int side = exact_det(e, f, {q, p});
      above = above || side > 0;
      below = below || side < 0;
    }
  return above != below;
}

std::optional<int> winding_gain(const Triangle& t, const Vec3& p, const Vec3& q) {
  const int from = exact_orient3d(t[0], t[1], t[2], p), to = exact_orient3d(t[0], t[1], t[2], q);
  if (from * to > 0) return 0;
  const int x = exact_orient3d(p, q, t[0], t[1]), y = exact_orient3d(p, q, t[1], t[2]),
            z = exact_orient3d(p, q, t[2], t[0]);
  if (!same_side(x, y, z)) return 0;
  if (from == 0 || to == 0 || x == 0 || y == 0 || z == 0) return std::nullopt;
  return from;
}

bool triangles_cross(const Triangle& s, const Triangle& t, int shared) {
  const Sides of_s = sides(t, s);
  if (of_s.all_off_one_side()) return false;
  if (of_s.all_on()) return coplanar_meet(s, t, shared == 0);
  if (shared == 2) return false;
  const Sides of_t = sides(s, t);
  if (shared == 0) return some_edge_meets(s, of_s, t) || some_edge_meets(t, of_t, s);
  // From the common corner the intersection runs along a line of both planes; it ends on an opposite edge.
  return segment_meets(s[1], s[2], t, of_s.of[1], of_s.of[2]) ||
         segment_meets(t[1], t[2], s, of_t.of[1], of_t.of[2]);
}

}  // namespace unsliver::geom
