/// \file
/// Where the judge sees the vertices: integers of the frame, integers of a binary grid, or plain doubles.
#pragma once

#include <optional>
#include <vector>

#include "unsliver/mesh.hpp"
#include "verify/numbers.hpp"

namespace unsliver::verifier {

/// Integer places of all points relative to a mesh's frame.
struct FramePlaces {
  std::vector<Row<std::int64_t>> q;  ///< one per point, nearest
  std::vector<VertexId> off_grid;    ///< points that are not exactly origin + unit * q
  double worst_offset = 0;           ///< of those, in units, along an axis
  bool in_range = true;              ///< false: the frame does not fit the points, q is incomplete
};

/// Requires: mesh.frame with unit > 0, all coordinates finite.
FramePlaces place_on_frame(const TetMesh& mesh);

/// Judged positions. They are similar to the positions in the mesh (moved and scaled, which no sign here
/// can see), exactly so unless input vertices are off the grid of the frame: those are judged rounded.
class Sites {
 public:
  /// `q` is the caller's to give away: integer positions, each `unit` long in the caller's units.
  Sites(std::vector<Row<std::int64_t>> q, double unit) : q_(std::move(q)), unit_(unit) {}
  /// Positions as given; integers if one binary grid holds them all. Keeps a reference to `points`.
  explicit Sites(const std::vector<Vec3>& points);

  bool integral() const { return !q_.empty(); }
  /// Length of one judged unit in the caller's units.
  double unit() const { return unit_; }

  /// v - origin, each component rounded once. The components, as integers, are or-ed into `spread`, which
  /// becomes all ones where positions are not integers.
  Row<double> difference(VertexId v, VertexId origin, std::uint64_t& spread) const {
    Row<double> d;
    if (!integral()) {
      spread = ~std::uint64_t{0};
      const Vec3 w = (*points_)[v] - (*points_)[origin];
      return {w.x, w.y, w.z};
    }
    const auto &head = q_[v], &tail = q_[origin];
    for (int i = 0; i < 3; ++i) {
      const std::int64_t w = head[i] - tail[i];
      spread |= static_cast<std::uint64_t>(w < 0 ? -w : w);
      d[i] = static_cast<double>(w);
    }
    return d;
  }

  /// v[i] - v[0] for i > 0, all scaled by one power of two to integers. T = Int128 requires integral().
  template <class T, std::size_t N>
  std::array<Row<T>, N - 1> exact_differences(const std::array<VertexId, N>& v) const {
    std::array<Row<T>, N - 1> d;
    std::vector<Row<T>> rows(N - 1);
    exact_differences(v.data(), N, rows.data());
    std::copy(rows.begin(), rows.end(), d.begin());
    return d;
  }

 private:
  void exact_differences(const VertexId* v, std::size_t n, Row<Int128>* out) const;
  void exact_differences(const VertexId* v, std::size_t n, Row<BigInt>* out) const;
  std::vector<Row<std::int64_t>> integer_differences(const VertexId* v, std::size_t n) const;

  std::vector<Row<std::int64_t>> q_;
  const std::vector<Vec3>* points_ = nullptr;
  double unit_ = 1;
};

/// Bits of the or-ed integers once the power of two that divides them all is taken out.
inline int significant_bits(std::uint64_t spread) {
  return spread == 0 ? 0 : static_cast<int>(std::bit_width(spread)) - std::countr_zero(spread);
}

}  // namespace unsliver::verifier
