#include "verify/sites.hpp"

#include <algorithm>
#include <climits>

#include "verify/grid.hpp"

namespace unsliver::verifier {
namespace {

/// The coarsest power of two that divides every coordinate, if all are small multiples of it.
std::optional<int> common_exponent(const std::vector<Vec3>& points) {
  int low = INT_MAX, high = INT_MIN;
  for (const Vec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] == 0) continue;
      const Dyadic d = decompose(p[axis]);
      low = std::min(low, d.exponent);
      high = std::max(high, std::ilogb(p[axis]) + 1);
      if (high - low > 60) return std::nullopt;
    }
  }
  return low == INT_MAX ? 0 : low;
}

}  // namespace

FramePlaces place_on_frame(const TetMesh& mesh) {
  const auto& [unit, origin] = *mesh.frame;
  const std::array<GridAxis, 3> axes{GridAxis(unit, origin.x), GridAxis(unit, origin.y),
                                     GridAxis(unit, origin.z)};
  FramePlaces places;
  places.q.resize(mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    bool exact = true;
    for (int axis = 0; axis < 3; ++axis) {
      const GridPlace place = axes[axis].place(mesh.points[v][axis]);
      places.in_range &= place.in_range;
      places.q[v][axis] = place.q;
      places.worst_offset = std::max(places.worst_offset, place.offset);
      exact &= place.exact;
    }
    if (!exact) places.off_grid.push_back(static_cast<VertexId>(v));
  }
  return places;
}

Sites::Sites(const std::vector<Vec3>& points) : points_(&points) {
  const std::optional<int> exponent = common_exponent(points);
  if (!exponent) return;
  unit_ = std::ldexp(1.0, *exponent);
  q_.reserve(points.size());
  const auto integer = [&](double x) { return static_cast<std::int64_t>(std::ldexp(x, -*exponent)); };
  for (const Vec3& p : points) q_.push_back({integer(p.x), integer(p.y), integer(p.z)});
}

std::vector<Row<std::int64_t>> Sites::integer_differences(const VertexId* v, std::size_t n) const {
  std::vector<Row<std::int64_t>> d(n - 1);
  std::uint64_t spread = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      d[i][axis] = q_[v[i + 1]][axis] - q_[v[0]][axis];
      spread |= static_cast<std::uint64_t>(d[i][axis]);
    }
  }
  const int shift = spread == 0 ? 0 : std::countr_zero(spread);
  for (auto& row : d) {
    for (auto& x : row) x >>= shift;
  }
  return d;
}

void Sites::exact_differences(const VertexId* v, std::size_t n, Row<Int128>* out) const {
  const auto d = integer_differences(v, n);
  for (std::size_t i = 0; i < d.size(); ++i) out[i] = {d[i][0], d[i][1], d[i][2]};
}

void Sites::exact_differences(const VertexId* v, std::size_t n, Row<BigInt>* out) const {
  if (integral()) {
    const auto d = integer_differences(v, n);
    for (std::size_t i = 0; i < d.size(); ++i) out[i] = {BigInt(d[i][0]), BigInt(d[i][1]), BigInt(d[i][2])};
    return;
  }
  int exponent = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      exponent = std::min(exponent, decompose((*points_)[v[i]][axis]).exponent);
    }
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      out[i][axis] = scaled((*points_)[v[i + 1]][axis], exponent) - scaled((*points_)[v[0]][axis], exponent);
    }
  }
}

}  // namespace unsliver::verifier
