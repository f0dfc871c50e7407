/// \file
/// The stages behind the filters.
///
/// Exact doubles. All intermediates are integers in units of a power of g. If they are below 2^53 units every
/// operation was exact. For orient3d they are at most sqrt(2) n1 n2 n3 (see predicates.hpp), so it suffices
/// that 2 l1 l2 l3 < 2^106 g^6, that is error_sq < 26 g^6; for insphere at most (prod n)(sum n), so 4 (prod
/// l)(sum l) < 2^106 g^10, that is error_sq < 250 g^10. (A row that is 0 makes all terms 0, exactly; other
/// rows have n >= g, so intermediates of lower degree are smaller.) 25 and 240 leave room for rounding.
#include "exact/predicates.hpp"

#include <array>
#include <cassert>
#include <cmath>

#include "exact/integer_rows.hpp"
#include "exact/wide_int.hpp"

namespace unsliver::exact {
namespace {

constexpr double kOrientExactLimit = 25, kInsphereExactLimit = 240;
constexpr int kCoordinateBits = 49;  ///< of a difference

/// Largest D/g, in bits, for 128-bit integers. Minors of degree 2 are then 64-bit in the in-sphere test.
constexpr int kOrientMediumBits = 41, kInsphereMediumBits = 24;

static_assert(bit_budget(6, 3, kOrientMediumBits) < 128);
static_assert(bit_budget(6, 3, kCoordinateBits) < Int256::kBits);
static_assert(bit_budget(2, 2, kInsphereMediumBits) < 64 && bit_budget(3, 2, kInsphereMediumBits) < 64);
static_assert(bit_budget(72, 5, kInsphereMediumBits) < 128);
static_assert(bit_budget(3, 2, kCoordinateBits) < 128);
static_assert(bit_budget(72, 5, kCoordinateBits) < Int256::kBits);

/// A weighted height is below 3 D^2 + 2^97 < 4 * 2^98: the power test's determinant is below 4 * 4 * 6 D^5.
static_assert(2 * kCoordinateBits == 98 && bit_budget(4, 2, kCoordinateBits) < 128);
static_assert(bit_budget(96, 5, kCoordinateBits) < Int256::kBits);

/// Largest D/g, in bits, for 64-bit lexicographic keys: three digits in base 2^(bits + 1) and one in base 4.
constexpr int kNarrowKeyBits = 19;
static_assert(3 * (kNarrowKeyBits + 1) + 2 < 64 && 3 * (kCoordinateBits + 1) + 2 < Int256::kBits);

using Rows4 = IntegerRows<4>;

/// The signs of the in-sphere determinant and of its cofactors.
struct LiftedSigns {
  int value;
  std::array<int, 4> cofactors;
};

template <class Three, class Five>
LiftedSigns signs(const Cofactors<Three>& m, const Five& value) {
  return {sign_of(value), {sign_of(m.a), sign_of(m.b), sign_of(m.c), sign_of(m.d)}};
}

template <class Two, class Three, class Five>
LiftedSigns integer_signs(const std::array<Row<std::int64_t>, 4>& r) {
  const auto m = cofactors<Two, Three>(r[0], r[1], r[2], r[3]);
  return signs(m, combine<Five>(m, lift<Two>(r[0]), lift<Two>(r[1]), lift<Two>(r[2]), lift<Two>(r[3])));
}

Rows4 rows_from(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  return Rows4({detail::row(a, e), detail::row(b, e), detail::row(c, e), detail::row(d, e)});
}

/// Divides the rows by g.
LiftedSigns exact_signs(Rows4& rows, const detail::LiftedDeterminant& filter, StageCounts& counts) {
  rows.reduce();
  if (filter.error_sq < kInsphereExactLimit * power_of_g(rows.scale, 10)) {
    ++counts.small;
    return signs(filter.cofactors, filter.value);
  }
  if (rows.scale.bits <= kInsphereMediumBits) {
    ++counts.small;
    return integer_signs<std::int64_t, Int128, Int128>(rows.rows);
  }
  ++counts.wide;
  return integer_signs<Int128, Int256, Int256>(rows.rows);
}

/// Orders rows of at most kBits bits as lex_less does their points, and carries a sign in its last digit.
template <class Key, int kBits>
Key lexicographic_key(const Row<std::int64_t>& r, int sign) {
  const Key base(std::int64_t{1} << (kBits + 1));
  return ((Key(r.x) * base + Key(r.y)) * base + Key(r.z)) * Key(4) + Key(sign + 1);
}

/// The sign that the perturbation gives to a determinant that is 0: the largest point's epsilon dominates,
/// its coefficient is its cofactor, for e minus the (positive) orientation of a, b, c, d. At most one
/// cofactor is 0: two would put e on the line through two of the points, where only these two are on the
/// sphere. So the two largest points decide. The rows are relative to e: its key is that of 0.
template <class Key, int kBits>
int perturbation_sign(const std::array<Row<std::int64_t>, 4>& rows, const std::array<int, 4>& cofactors) {
  const Key e = lexicographic_key<Key, kBits>({0, 0, 0}, -1);
  Key largest = e;
  int sign = -1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Key key = lexicographic_key<Key, kBits>(rows[i], cofactors[i]);
    const bool greater = sign_of(key - largest) > 0;
    largest = greater ? key : largest;
    sign = greater ? cofactors[i] : sign;
  }
  if (sign != 0) return sign;
  Key second = e;
  sign = -1;
  for (std::size_t i = 0; i < 4; ++i) {
    const Key key = lexicographic_key<Key, kBits>(rows[i], cofactors[i]);
    if (sign_of(key - second) > 0 && sign_of(largest - key) > 0) second = key, sign = cofactors[i];
  }
  return sign;
}

/// The power test's determinant in doubles. Heights h = l + (w(e) - w) pass 4 roundings of terms whose
/// absolute values add up to s = l + |w(e) - w|, so as for insphere, now with s in place of one l each,
///   |error| <= gamma_12 sqrt(2) sum_i s_i prod_{j != i} n_j,
///   error^2 <= 1152 u^2 sum_i s_i^2 prod_{j != i} l_j.
struct WeightedDeterminant {
  double value, error_sq;

  WeightedDeterminant(const std::array<Row<double>, 4>& r, const double (&w)[5]) {
    double l[4], h[4], s[4];
    for (std::size_t i = 0; i < 4; ++i) {
      const double difference = w[4] - w[i];
      l[i] = lift<double>(r[i]);
      h[i] = l[i] + difference;
      s[i] = l[i] + std::abs(difference);
    }
    value = combine<double>(cofactors<double, double>(r[0], r[1], r[2], r[3]), h[0], h[1], h[2], h[3]);
    const double ab = l[0] * l[1], cd = l[2] * l[3];
    error_sq =
        1200 * detail::kUnitRoundoffSq *
        (cd * (s[0] * s[0] * l[1] + s[1] * s[1] * l[0]) + ab * (s[2] * s[2] * l[3] + s[3] * s[3] * l[2]));
  }
};

}  // namespace

namespace detail {

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double value, double error_sq,
                   StageCounts& counts) {
  IntegerRows<3> rows({row(b, a), row(c, a), row(d, a)});
  if (error_sq < kOrientExactLimit * power_of_g(rows.scale, 6)) {
    ++counts.small;
    return sign_of(value);
  }
  rows.reduce();
  const auto& r = rows.rows;
  if (rows.scale.bits <= kOrientMediumBits) {
    ++counts.small;
    return sign_of(determinant<Int128, Int128>(r[0], r[1], r[2]));
  }
  ++counts.wide;
  return sign_of(determinant<Int128, Int256>(r[0], r[1], r[2]));
}

int insphere_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                   const LiftedDeterminant& filter, StageCounts& counts) {
  Rows4 rows = rows_from(a, b, c, d, e);
  return exact_signs(rows, filter, counts).value;
}

int insphere_perturbed_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                             const LiftedDeterminant& filter, StageCounts& counts) {
  Rows4 rows = rows_from(a, b, c, d, e);
  const LiftedSigns exact = exact_signs(rows, filter, counts);
  if (exact.value != 0) return exact.value;
  ++counts.tie;
  const int sign = rows.scale.bits <= kNarrowKeyBits
                       ? perturbation_sign<std::int64_t, kNarrowKeyBits>(rows.rows, exact.cofactors)
                       : perturbation_sign<Int256, kCoordinateBits>(rows.rows, exact.cofactors);
  assert(sign != 0 && "e is one of a, b, c, d, or these are coplanar");
  return sign;
}

}  // namespace detail

int power_test(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
               const double (&w)[5], StageCounts& counts) {
  const std::array<Row<double>, 4> rows = {detail::row(a, e), detail::row(b, e), detail::row(c, e),
                                           detail::row(d, e)};
  const WeightedDeterminant filter(rows, w);
  if (filter.value * filter.value > filter.error_sq) {
    ++counts.filter;
    return sign_of(filter.value);
  }
  const Rows4 integers(rows);
  const auto& r = integers.rows;
  const auto height = [&](int i) {
    return lift<Int128>(r[static_cast<std::size_t>(i)]) - static_cast<Int128>(w[i]) +
           static_cast<Int128>(w[4]);
  };
  const auto m = cofactors<Int128, Int256>(r[0], r[1], r[2], r[3]);
  ++counts.wide;
  return sign_of(combine<Int256>(m, height(0), height(1), height(2), height(3)));
}

}  // namespace unsliver::exact
