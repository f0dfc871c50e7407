/// \file
/// The two determinants of the kernel, written once for doubles and for integers of every width.
///
/// One, Two, Three, Five: number types that hold values of degree 1, 2, 3 and 5 in the coordinates.
#pragma once

namespace unsliver::exact {

/// A difference of two points.
template <class One>
struct Row {
  One x, y, z;
};

/// x and y part of a x b.
template <class Two, class One>
constexpr Two minor_xy(const Row<One>& a, const Row<One>& b) {
  return Two(a.x) * Two(b.y) - Two(b.x) * Two(a.y);
}

/// det(a, b, c), given the three minors.
template <class Three, class Two, class One>
constexpr Three expand_z(const Row<One>& a, const Row<One>& b, const Row<One>& c, const Two& bc,
                         const Two& ac, const Two& ab) {
  return Three(a.z) * Three(bc) - Three(b.z) * Three(ac) + Three(c.z) * Three(ab);
}

/// det(a, b, c).
template <class Two, class Three, class One>
constexpr Three determinant(const Row<One>& a, const Row<One>& b, const Row<One>& c) {
  return expand_z<Three>(a, b, c, minor_xy<Two>(b, c), minor_xy<Two>(a, c), minor_xy<Two>(a, b));
}

/// |a|^2.
template <class Two, class One>
constexpr Two lift(const Row<One>& a) {
  return Two(a.x) * Two(a.x) + Two(a.y) * Two(a.y) + Two(a.z) * Two(a.z);
}

/// What each lifted height contributes to the in-sphere determinant: with e at the origin, the orientation of
/// a, b, c, d with that point replaced by e.
template <class Three>
struct Cofactors {
  Three a, b, c, d;
};

template <class Two, class Three, class One>
constexpr Cofactors<Three> cofactors(const Row<One>& a, const Row<One>& b, const Row<One>& c,
                                     const Row<One>& d) {
  const Two ab = minor_xy<Two>(a, b), ac = minor_xy<Two>(a, c), ad = minor_xy<Two>(a, d);
  const Two bc = minor_xy<Two>(b, c), bd = minor_xy<Two>(b, d), cd = minor_xy<Two>(c, d);
  return {expand_z<Three>(b, c, d, cd, bd, bc), -expand_z<Three>(a, c, d, cd, ad, ac),
          expand_z<Three>(a, b, d, bd, ad, ab), -expand_z<Three>(a, b, c, bc, ac, ab)};
}

/// The in-sphere determinant for the lifted heights al, ..., dl relative to e: positive if e is in conflict.
template <class Five, class Two, class Three>
constexpr Five combine(const Cofactors<Three>& m, const Two& al, const Two& bl, const Two& cl,
                       const Two& dl) {
  return (Five(al) * Five(m.a) + Five(bl) * Five(m.b)) + (Five(cl) * Five(m.c) + Five(dl) * Five(m.d));
}

}  // namespace unsliver::exact
