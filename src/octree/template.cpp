#include "octree/template.hpp"

#include "octree/gift_wrapping.hpp"

namespace unsliver::octree {
namespace {

using Vector = std::array<std::int64_t, 3>;

Vector position(Key key, int slot) {
  const auto at = slot_position(slot, is_halved_slot(key, slot));
  return {at[0], at[1], at[2]};
}

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
std::int64_t inner(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector outer(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A circumcentre as a fraction, denominator > 0 (the tetrahedron is positively oriented).
struct Circumcenter {
  Vector numerator;
  std::int64_t denominator;

  explicit Circumcenter(const std::array<Vector, 4>& t) {
    const Vector b = minus(t[1], t[0]), c = minus(t[2], t[0]), d = minus(t[3], t[0]);
    const Vector cd = outer(c, d), db = outer(d, b), bc = outer(b, c);
    denominator = 2 * inner(b, cd);
    for (std::size_t i = 0; i < 3; ++i)
      numerator[i] = t[0][i] * denominator + inner(b, b) * cd[i] + inner(c, c) * db[i] + inner(d, d) * bc[i];
  }
};

bool owns(Key key, const Circumcenter& center) {
  constexpr std::int64_t kSide = 4;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t at = center.numerator[std::size_t(axis)];
    if (at < 0 && key.face(2 * axis) != kBrickEnd) return false;
    if (at >= kSide * center.denominator && key.face(2 * axis + 1) != kBrickEnd) return false;
  }
  return true;
}

}  // namespace

std::vector<std::uint8_t> occupied_slots(Key key) {
  std::array<bool, kSlotCount> occupied{};
  for (int corner = 0; corner < 8; ++corner) occupied[std::size_t(corner_slot(corner))] = true;
  for (std::size_t e = 0; e < 12; ++e) occupied[kEdgeSlots[e]] = key.has_hanging_edge(int(e));
  occupied[kCenterSlot] = key.has_center();
  for (int f = 0; f < 6; ++f) {
    const bool halved = key.face(f) == kHalved;
    occupied[std::size_t(face_slot(f))] = halved;
    for (int j = 0; j < 4; ++j) {
      const int slot = beyond_slot(f, j);
      occupied[std::size_t(slot)] = halved ? key.half_has_center(f, j) : j == 0 && key.face(f) == kCentered;
    }
  }
  std::vector<std::uint8_t> slots;
  for (std::size_t s = 0; s < kSlotCount; ++s)
    if (occupied[s]) slots.push_back(std::uint8_t(s));
  return slots;
}

Template solve_template(Key key) {
  const std::vector<std::uint8_t> slots = occupied_slots(key);
  std::vector<Vector> at;
  std::vector<Vec3> points;
  for (const int slot : slots) {
    at.push_back(position(key, slot));
    points.push_back({double(at.back()[0]), double(at.back()[1]), double(at.back()[2])});
  }
  Template result;
  std::vector<bool> used(slots.size(), false);
  const GiftWrapping delaunay(points);
  for (const auto& t : delaunay.tets()) {
    if (!owns(key, Circumcenter({at[t[0]], at[t[1]], at[t[2]], at[t[3]]}))) continue;
    result.tets.push_back({slots[t[0]], slots[t[1]], slots[t[2]], slots[t[3]]});
    for (const std::size_t i : t) used[i] = true;
  }
  for (std::size_t i = 0; i < slots.size(); ++i)
    if (used[i]) result.slots.push_back(slots[i]);
  return result;
}

}  // namespace unsliver::octree
