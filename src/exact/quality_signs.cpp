/// \file
/// The stages of the quality signs: filter, exact doubles, 128 bits, 512 bits. Notation: see shape.hpp; L =
/// the largest squared edge, D the largest difference, g the power of two common to all, u = 2^-53.
///
/// Error bounds in doubles, to first order, in units of u (|n_i| <= L, |X| <= 3 L^2, det^2 <= L^3):
///   n_i: 2 sqrt(2) L;   G, N_i: (4 sqrt(2) + 3) L^2 < 8.7 L^2;   G |G| and N_i N_j: 18.4 L^4;
///   the angle's expression: (18.4 + 2) (num + den) L^4;
///   X: 3 (3 + 2 sqrt(2) + 3) L^2 < 26.5 L^2;   |X|^2: (2 * 3 * 26.5 + 3 * 9) L^4 = 186 L^4;
///   4 det^2 l_min: 4 (2 (2 sqrt(2) + 3) + 5) L^4 < 67 L^4;   the ratio's: less than 204 (num + den) L^4.
/// kAngleError and kRatioError leave 7 percent for higher orders and for rounding in the bound itself.
///
/// Exact doubles. In units of powers of g all intermediates are integers of at most 9 (num + den) L^4: while
/// these are below 2^53, nothing is rounded.
#include "exact/quality_signs.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

#include "exact/integer_rows.hpp"
#include "exact/shape.hpp"

namespace unsliver::exact {
namespace {

constexpr double kAngleError = 22 * 0x1p-53, kRatioError = 220 * 0x1p-53;
constexpr double kExactLimit = 0.99 * 0x1p53 / 9;
constexpr int kCoordinateBits = 49;  ///< of a difference
constexpr int kBoundBits = 20;       ///< of a bound's num and den
constexpr int kMediumBits = 14;      ///< of a difference over g in MediumShape

/// Both expressions are below this power of 2: a component of X is at most 18 D^4, so |X|^2 at most 972 D^8;
/// 4 det^2 l_min at most 432 D^8; N_i N_j and G^2 at most 144 D^8 each.
constexpr int expression_bits(int coordinate_bits, int bound_bits) {
  return bit_budget(972 + 432, 8, coordinate_bits) + bound_bits;
}
static_assert(bit_budget(18, 4, kMediumBits) < 64);
static_assert(bit_budget(3, 2, kCoordinateBits) < 128);
static_assert(bit_budget(18, 4, kCoordinateBits) < Int256::kBits);
static_assert(expression_bits(kCoordinateBits, kBoundBits) < Int512::kBits);

using Pair = std::array<std::size_t, 2>;
constexpr std::array<Pair, 6> kPairs = {Pair{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

Edges<double> edges_of(const Tet& t) {
  const auto edge = [&t](std::size_t from, std::size_t to) {
    return Row<double>{t[to].x - t[from].x, t[to].y - t[from].y, t[to].z - t[from].z};
  };
  return {edge(3, 0), edge(3, 1), edge(3, 2), edge(0, 1), edge(0, 2), edge(1, 2)};
}

template <class Bound>
double size_of(const Bound& b) {
  return static_cast<double>(b.num + b.den);
}

template <class Bound>
int bits_of(const Bound& b) {
  const int bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::max(b.num, b.den))));
  assert(0 <= b.num && 0 < b.den && bits <= kBoundBits);
  return bits;
}

/// L^4.
double scale_of(const DoubleShape& shape) {
  const double l = shape.longest();
  return (l * l) * (l * l);
}

/// What the filter knows when it gives up, for all signs asked of one tetrahedron.
struct Undecided {
  Edges<double> edges;
  double scale;       ///< L^4
  double bound_size;  ///< the largest num + den
  int bound_bits;
};

/// Decides with the cheapest exact shape. `decide(shape)` must work for all three kinds.
template <class Decide>
auto decide_exactly(const DoubleShape& doubles, const Undecided& u, StageCounts& counts, Decide decide) {
  IntegerRows<6> integers(u.edges);
  if (u.bound_size * u.scale < kExactLimit * power_of_g(integers.scale, 8)) {
    ++counts.small;
    return decide(doubles);
  }
  integers.reduce();
  const int bits = integers.scale.bits;
  if (bits <= kMediumBits && expression_bits(bits, u.bound_bits) < 128) {
    ++counts.small;
    return decide(MediumShape(integers.rows));
  }
  ++counts.wide;
  return decide(WideShape(integers.rows));
}

/// The sign of one expression: `excess(shape)`.
template <class Bound, class Excess>
int staged_sign(const Tet& t, const Bound& bound, double relative_error, StageCounts& counts, Excess excess) {
  const Edges<double> edges = edges_of(t);
  const DoubleShape doubles(edges);
  const double value = excess(doubles), scale = scale_of(doubles);
  if (std::abs(value) > relative_error * size_of(bound) * scale) {
    ++counts.filter;
    return sign_of(value);
  }
  return decide_exactly(doubles, {edges, scale, size_of(bound), bits_of(bound)}, counts,
                        [&excess](const auto& shape) { return sign_of(excess(shape)); });
}

/// Coefficients in the number type of a shape.
template <class One, class Two, class Four, class Eight, class Bound>
Coefficients<Eight> coefficients(const Shape<One, Two, Four, Eight>&, const Bound& bound) {
  return Coefficients<Eight>(bound);
}

template <class AnyShape>
bool is_bad_shape(const AnyShape& shape, const QualityBounds& bounds) {
  const auto low = coefficients(shape, bounds.min_dihedral), high = coefficients(shape, bounds.max_dihedral);
  for (const auto& [i, j] : kPairs) {
    const auto pair = shape.pair(i, j);
    if (sign_of(pair.excess(low)) < 0 || sign_of(pair.excess(high)) > 0) return true;
  }
  return sign_of(shape.ratio_excess(coefficients(shape, bounds.max_radius_edge))) > 0;
}

/// By how much a tetrahedron exceeds its bounds: positive where it is bad.
struct Excess {
  double low = -std::numeric_limits<double>::infinity(), high = low, ratio = 0;

  Excess(const DoubleShape& shape, const QualityBounds& bounds) {
    const Coefficients<double> min(bounds.min_dihedral), max(bounds.max_dihedral);
    for (const auto& [i, j] : kPairs) {
      const FacePair<double> pair = shape.pair(i, j);
      low = std::max(low, -pair.excess(min));
      high = std::max(high, pair.excess(max));
    }
    ratio = shape.ratio_excess(Coefficients<double>(bounds.max_radius_edge));
  }
};

}  // namespace

int compare_dihedral(const Tet& t, int i, int j, const CosBound& bound, StageCounts& counts) {
  assert(i != j && 0 <= i && i < 4 && 0 <= j && j < 4);
  const auto face = static_cast<std::size_t>(i), other = static_cast<std::size_t>(j);
  return staged_sign(t, bound, kAngleError, counts, [&](const auto& shape) {
    return shape.pair(face, other).excess(coefficients(shape, bound));
  });
}

int compare_radius_edge(const Tet& t, const RatioBound& bound, StageCounts& counts) {
  return staged_sign(t, bound, kRatioError, counts,
                     [&](const auto& shape) { return shape.ratio_excess(coefficients(shape, bound)); });
}

bool is_bad(const Tet& t, const QualityBounds& bounds, StageCounts& counts) {
  const Edges<double> edges = edges_of(t);
  const DoubleShape doubles(edges);
  const Excess excess(doubles, bounds);
  const double scale = scale_of(doubles);
  const double low_size = size_of(bounds.min_dihedral), high_size = size_of(bounds.max_dihedral),
               ratio_size = size_of(bounds.max_radius_edge);
  const double low_error = kAngleError * low_size * scale, high_error = kAngleError * high_size * scale,
               ratio_error = kRatioError * ratio_size * scale;
  const bool bad = excess.low > low_error || excess.high > high_error || excess.ratio > ratio_error;
  const bool good = excess.low < -low_error && excess.high < -high_error && excess.ratio < -ratio_error;
  if (bad || good) {
    ++counts.filter;
    return bad;
  }
  const Undecided undecided = {edges, scale, std::max({low_size, high_size, ratio_size}),
                               std::max({bits_of(bounds.min_dihedral), bits_of(bounds.max_dihedral),
                                         bits_of(bounds.max_radius_edge)})};
  return decide_exactly(doubles, undecided, counts,
                        [&bounds](const auto& shape) { return is_bad_shape(shape, bounds); });
}

}  // namespace unsliver::exact
