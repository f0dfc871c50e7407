/// \file
/// The stages of the quality signs: filter, exact doubles, 128 bits, 512 bits. Notation: see shape.hpp; L =
/// the largest squared edge, D the largest coordinate of e_0, e_1, e_2, g the power of two common to these,
/// u = 2^-53.
///
/// Error bounds in doubles, to first order, in units of u (|n_i|^2 <= L^2, |X|^2 <= 9 L^4, det^2 <= L^3):
///   e_i . e_j: 3 L;   the other squared edges: 15 L;   G_ij for i, j < 3: (7 + 7 + 1) L^2 = 15 L^2;
///   G_i3: (3 * 15 + 3) L^2 = 48 L^2;   G_33: (3 * 48 + 3) L^2 = 147 L^2;
///   G_ii G_jj: (15 + 147 + 1) L^4 = 163 L^4;   G_ij |G_ij|: (2 * 48 + 1) L^4 = 97 L^4;
///   the angle's expression, with its own 3 roundings: less than 166 (num + den) L^4;
///   a sum of 3 products of G_ij and e_i . e_j: (3 * 19 + 5) L^3 = 62 L^3, its value at most 3 L^3;
///   |X|^2: (3 (62 + 9 + 3) + 15) L^4 = 237 L^4;   det^2 l_min: (62 + 15 + 1) L^4 = 78 L^4;
///   the ratio's expression: (237 + 18) den L^4 + 4 (78 + 2) num L^4 <= 320 (num + den) L^4.
/// kAngleError and kRatioError leave 6 percent for higher orders and for rounding in the bound itself.
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
#include <span>

#include "exact/integer_rows.hpp"
#include "exact/shape.hpp"

namespace unsliver::exact {
namespace {

constexpr double kAngleError = 176 * 0x1p-53, kRatioError = 340 * 0x1p-53;
constexpr double kExactLimit = 0.99 * 0x1p53 / 9;
constexpr int kCoordinateBits = 49;  ///< of a difference
constexpr int kBoundBits = 20;       ///< of a bound's num and den
constexpr int kMediumBits = 14;      ///< of a difference over g in MediumShape

/// Both expressions are below this power of 2. e_i . e_j is at most 3 D^2, G_ij 9 D^4 for i, j < 3, G_i3 27
/// D^4 and G_33 81 D^4: so G_ii G_jj and G_ij^2 are at most 729 D^8, |X|^2 too, 4 det^2 l_min at most 972
/// D^8.
constexpr int expression_bits(int coordinate_bits, int bound_bits) {
  return bit_budget(729 + 972, 8, coordinate_bits) + bound_bits;
}
static_assert(bit_budget(81, 4, kMediumBits) < 64);
static_assert(bit_budget(12, 2, kCoordinateBits) < 128);
static_assert(bit_budget(81, 4, kCoordinateBits) < Int256::kBits);
static_assert(expression_bits(kCoordinateBits, kBoundBits) < Int512::kBits);

Edges<double> edges_of(const Tet& t) {
  return {detail::row(t[0], t[3]), detail::row(t[1], t[3]), detail::row(t[2], t[3])};
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
template <class Real>
Real scale_of(const Shape<Real, Real, Real>& shape) {
  const Real l = shape.longest();
  return (l * l) * (l * l);
}

/// What the stages behind the filter need, for all signs asked of one tetrahedron.
struct Undecided {
  Edges<double> edges;
  double scale;       ///< L^4
  double bound_size;  ///< the largest num + den
  int bound_bits;
};

/// Decides with the cheapest exact shape. `decide(shape)` must work for all three kinds. Kept out of line, so
/// that the filter before it keeps its numbers in registers.
template <class Decide>
[[gnu::noinline]] auto decide_exactly(const Undecided& u, StageCounts& counts, Decide decide) {
  IntegerRows<3> integers(u.edges);
  if (u.bound_size * u.scale < kExactLimit * power_of_g(integers.scale, 8)) {
    ++counts.small;
    return decide(DoubleShape(u.edges));
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
  const DoubleShape shape(edges);
  const double value = excess(shape), scale = scale_of(shape);
  if (std::abs(value) > relative_error * size_of(bound) * scale) {
    ++counts.filter;
    return sign_of(value);
  }
  return decide_exactly({edges, scale, size_of(bound), bits_of(bound)}, counts,
                        [&excess](const auto& exact) { return sign_of(excess(exact)); });
}

/// Coefficients in the number type of a shape.
template <class Two, class Four, class Eight, class Bound>
Coefficients<Eight> coefficients(const Shape<Two, Four, Eight>&, const Bound& bound) {
  return Coefficients<Eight>(bound);
}

template <class AnyShape>
bool is_bad_shape(const AnyShape& shape, const QualityBounds& bounds) {
  const auto min = coefficients(shape, bounds.min_dihedral), max = coefficients(shape, bounds.max_dihedral);
  bool bad = false;
  shape.for_each_pair(
      [&](const auto& pair) { bad = bad || sign_of(pair.excess(min)) < 0 || sign_of(pair.excess(max)) > 0; });
  return bad || sign_of(shape.ratio_excess(coefficients(shape, bounds.max_radius_edge))) > 0;
}

/// Is the tetrahedron bad, as far as doubles can tell?
enum class Verdict { kGood, kBad, kUnknown };

/// What the filter computes: how far the worst of each kind is beyond its bound.
template <class Real>
struct Excesses {
  Real scale, radius_sq, ratio, below, above;
};

template <class Real>
Excesses<Real> excesses(const Shape<Real, Real, Real>& shape, const QualityBounds& bounds) {
  using std::max;
  const Coefficients<Real> least(bounds.min_dihedral), most(bounds.max_dihedral);
  Real below(-std::numeric_limits<double>::infinity()), above = below;
  shape.for_each_pair([&](const FacePair<Real>& pair) {
    below = max(below, -pair.excess(least));
    above = max(above, pair.excess(most));
  });
  return {scale_of(shape), Real(0.25) * shape.center_sq() / shape.det_sq(),
          shape.ratio_excess(Coefficients<Real>(bounds.max_radius_edge)), below, above};
}

Verdict filtered_verdict(const Excesses<double>& x, const QualityBounds& bounds) {
  const double ratio_error = kRatioError * size_of(bounds.max_radius_edge) * x.scale;
  const double below_error = kAngleError * size_of(bounds.min_dihedral) * x.scale;
  const double above_error = kAngleError * size_of(bounds.max_dihedral) * x.scale;
  if (x.below < -below_error && x.above < -above_error && x.ratio < -ratio_error) return Verdict::kGood;
  if (x.ratio > ratio_error || x.below > below_error || x.above > above_error) return Verdict::kBad;
  return Verdict::kUnknown;
}

/// Edge vector e_i of each.
Row<Lanes> edge(std::span<const Tet, 4> t, std::size_t i) {
  const auto lanes = [t, i](double Vec3::*x) {
    return Lanes(t[0][i].*x - t[0][3].*x, t[1][i].*x - t[1][3].*x, t[2][i].*x - t[2][3].*x,
                 t[3][i].*x - t[3][3].*x);
  };
  return {lanes(&Vec3::x), lanes(&Vec3::y), lanes(&Vec3::z)};
}

UNSLIVER_WIDEST_LANES void excesses_of_four(std::span<const Tet, 4> t, const QualityBounds& bounds,
                                            Excesses<Lanes>& result) {
  result = excesses(LanesShape(Edges<Lanes>{edge(t, 0), edge(t, 1), edge(t, 2)}), bounds);
}

Judgement judgement(const Tet& t, const Excesses<double>& x, const QualityBounds& bounds,
                    StageCounts& counts) {
  const Verdict verdict = filtered_verdict(x, bounds);
  if (verdict != Verdict::kUnknown) {
    ++counts.filter;
    return {verdict == Verdict::kBad, x.radius_sq};
  }
  const auto& [min, max, ratio] = bounds;
  const bool bad =
      decide_exactly({edges_of(t), x.scale, std::max({size_of(min), size_of(max), size_of(ratio)}),
                      std::max({bits_of(min), bits_of(max), bits_of(ratio)})},
                     counts, [&bounds](const auto& exact) { return is_bad_shape(exact, bounds); });
  return {bad, x.radius_sq};
}

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

Judgement judge(const Tet& t, const QualityBounds& bounds, StageCounts& counts) {
  return judgement(t, excesses(DoubleShape(edges_of(t)), bounds), bounds, counts);
}

void judge(std::span<const Tet> tets, const QualityBounds& bounds, StageCounts& counts,
           std::span<Judgement> judgements) {
  assert(tets.size() == judgements.size());
  std::size_t t = 0;
  for (; t + Lanes::kCount <= tets.size(); t += Lanes::kCount) {
    Excesses<Lanes> x;
    excesses_of_four(tets.subspan(t).first<Lanes::kCount>(), bounds, x);
    for (std::size_t i = 0; i < Lanes::kCount; ++i)
      judgements[t + i] = judgement(
          tets[t + i], {x.scale[i], x.radius_sq[i], x.ratio[i], x.below[i], x.above[i]}, bounds, counts);
  }
  for (; t < tets.size(); ++t) judgements[t] = judge(tets[t], bounds, counts);
}

}  // namespace unsliver::exact
