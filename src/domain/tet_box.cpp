#include "domain/tet_box.hpp"

#include "geom/triangle_bvh.hpp"
#include "geom/triangle_orient.hpp"

namespace unsliver::domain {
namespace {

using geom::exact_orient2d;
using geom::exact_orient3d;

constexpr double kRoundDown = 1 - 4 * std::numeric_limits<double>::epsilon();

/// Corner i in 0..7, its bits choosing lo or hi along x, y, z.
Vec3 corner(const Box3& box, int i) {
  return {(i & 1) ? box.hi.x : box.lo.x, (i & 2) ? box.hi.y : box.lo.y, (i & 4) ? box.hi.z : box.lo.z};
}

bool holds_inside(const Box3& box, const Vec3& p) {
  return box.lo.x < p.x && p.x < box.hi.x && box.lo.y < p.y && p.y < box.hi.y && box.lo.z < p.z &&
         p.z < box.hi.z;
}

/// Which sides of something a set of points is on.
struct SidesSeen {
  bool negative = false, positive = false;
  void see(int side) {
    negative = negative || side < 0;
    positive = positive || side > 0;
  }
};

/// The closed half-spaces that hold the two sets are opposite ones (and not the plane itself twice).
bool opposite(const SidesSeen& a, const SidesSeen& b) {
  if (!b.negative && !b.positive) return false;
  return (!a.negative && !b.positive) || (!a.positive && !b.negative);
}

/// The plane of the face opposite to corner i.
bool face_separates(const Tet& t, int i, const Box3& box) {
  const Vec3 &a = t[(i + 1) % 4], &b = t[(i + 2) % 4], &c = t[(i + 3) % 4];
  SidesSeen of_tet, of_box;
  of_tet.see(exact_orient3d(a, b, c, t[i]));
  for (int k = 0; k < 8; ++k) {
    of_box.see(exact_orient3d(a, b, c, corner(box, k)));
    if (of_box.negative && of_box.positive) return false;
  }
  return opposite(of_tet, of_box);
}

/// The plane through edge (i, j) parallel to an axis; (u, v) are the other two.
bool edge_separates(const Tet& t, int i, int j, const Box3& box, int u, int v) {
  SidesSeen of_tet, of_box;
  for (const Vec3& p : t) of_tet.see(exact_orient2d(t[i], t[j], p, u, v));
  if (of_tet.negative && of_tet.positive) return false;
  for (int k = 0; k < 4; ++k)
    of_box.see(exact_orient2d(t[i], t[j], corner(box, (k & 1) << u | (k >> 1) << v), u, v));
  return opposite(of_tet, of_box);
}

}  // namespace

bool interior_meets_box(const Tet& t, const Box3& box) {
  const Box3 around = bounding_box(t);
  for (int axis = 0; axis < 3; ++axis)
    if (around.hi[axis] <= box.lo[axis] || box.hi[axis] <= around.lo[axis]) return false;
  if (exact_orient3d(t[0], t[1], t[2], t[3]) == 0) return false;
  for (const Vec3& p : t)
    if (holds_inside(box, p)) return true;
  for (int i = 0; i < 4; ++i)
    if (face_separates(t, i, box)) return false;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        if (edge_separates(t, i, j, box, (axis + 1) % 3, (axis + 2) % 3)) return false;
  return true;
}

double distance_to_box(const Vec3& p, const Box3& box) {
  return kRoundDown * std::sqrt(geom::dist_sq(p, box));
}

double depth_in_box(const Vec3& p, const Box3& box) {
  double depth = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    depth = std::min({depth, p[axis] - box.lo[axis], box.hi[axis] - p[axis]});
  return std::max(0.0, kRoundDown * depth);
}

}  // namespace unsliver::domain
