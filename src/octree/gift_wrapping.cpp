#include "octree/gift_wrapping.hpp"

#include <algorithm>
#include <stdexcept>

namespace unsliver::octree {
namespace {

constexpr int kNone = -1;

/// The same for each order of a facet's corners.
std::size_t facet_number(std::uint8_t a, std::uint8_t b, std::uint8_t c) {
  const auto [low, high] = std::minmax({a, b, c});
  const std::size_t middle = std::size_t(a ^ b ^ c ^ low ^ high);
  return (low * GiftWrapping::kMaxPoints + middle) * GiftWrapping::kMaxPoints + high;
}

std::size_t nearest_to_first(std::span<const Vec3> points) {
  std::size_t nearest = 1;
  for (std::size_t i = 2; i < points.size(); ++i)
    if (dist_sq(points[0], points[i]) < dist_sq(points[0], points[nearest])) nearest = i;
  return nearest;
}

}  // namespace

GiftWrapping::GiftWrapping(std::span<const Vec3> points) : points_(points) {
  add(first_tet());
  while (!waiting_.empty()) {
    const Facet f = waiting_.back();
    waiting_.pop_back();
    if (!open_[facet_number(f.a, f.b, f.c)]) continue;
    const int d = apex(f);
    if (d != kNone) add({f.a, f.b, f.c, std::uint8_t(d)});
  }
}

/// A point and its nearest neighbour are joined by an edge: on the sphere about both lies no third point.
GiftWrapping::Corners GiftWrapping::first_tet() {
  const auto b = std::uint8_t(nearest_to_first(points_));
  for (std::size_t c = 1; c < points_.size(); ++c) {
    if (c == b) continue;
    const Facet facet{0, b, std::uint8_t(c)};
    const int d = apex(facet);
    if (d == kNone) continue;
    const Corners t{0, b, std::uint8_t(c), std::uint8_t(d)};
    if (is_empty(t)) return t;
  }
  throw std::logic_error("the points lie in a plane");
}

bool GiftWrapping::is_empty(const Corners& t) {
  for (int e = 0; e < int(points_.size()); ++e) {
    const bool is_corner = std::find(t.begin(), t.end(), e) != t.end();
    if (!is_corner && in_conflict({t[0], t[1], t[2]}, t[3], e)) return false;
  }
  return true;
}

bool GiftWrapping::in_conflict(const Facet& f, int d, int e) {
  return exact::insphere_perturbed(points_[f.a], points_[f.b], points_[f.c], points_[std::size_t(d)],
                                   points_[std::size_t(e)], counts_) > 0;
}

/// Of the points on the positive side, the one whose ball holds no other of them.
int GiftWrapping::apex(const Facet& f) {
  int best = kNone;
  for (int e = 0; e < int(points_.size()); ++e) {
    if (exact::orient3d(points_[f.a], points_[f.b], points_[f.c], points_[std::size_t(e)], counts_) <= 0)
      continue;
    if (best == kNone || in_conflict(f, best, e)) best = e;
  }
  return best;
}

void GiftWrapping::add(const Corners& t) {
  tets_.push_back(t);
  toggle({t[1], t[2], t[3]});
  toggle({t[0], t[3], t[2]});
  toggle({t[0], t[1], t[3]});
  toggle({t[0], t[2], t[1]});
}

void GiftWrapping::toggle(const Facet& f) {
  const std::size_t number = facet_number(f.a, f.b, f.c);
  open_.flip(number);
  if (open_[number]) waiting_.push_back(f);
}

}  // namespace unsliver::octree
