/// \file
/// Exact arithmetic with sqrt(6), the irrational part of the forbidden region's half side.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "prove/enclosure.hpp"

namespace unsliver::prover {

/// a + b sqrt(6) with integers a and b of any size.
class Surd {
 public:
  using Integer =
      boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

  Surd() = default;
  Surd(int a, int b = 0) : a_(a), b_(b) {}  // NOLINT: an integer is a surd

  static Surd of(Integer a) { return Surd(std::move(a), 0); }

  friend Surd operator-(const Surd& x) { return Surd(-x.a_, -x.b_); }
  friend Surd operator+(const Surd& x, const Surd& y) { return Surd(x.a_ + y.a_, x.b_ + y.b_); }
  friend Surd operator-(const Surd& x, const Surd& y) { return Surd(x.a_ - y.a_, x.b_ - y.b_); }
  friend Surd operator*(const Surd& x, const Surd& y) {
    return Surd(x.a_ * y.a_ + 6 * x.b_ * y.b_, x.a_ * y.b_ + x.b_ * y.a_);
  }

  const Integer& a() const { return a_; }
  const Integer& b() const { return b_; }
  Surd conjugate() const { return Surd(a_, -b_); }
  int sign() const {
    const int sign_a = a_.sign(), sign_b = b_.sign();
    if (sign_a * sign_b >= 0) return sign_a != 0 ? sign_a : sign_b;
    return a_ * a_ > 6 * b_ * b_ ? sign_a : sign_b;
  }
  friend bool operator<(const Surd& x, const Surd& y) { return (x - y).sign() < 0; }
  friend bool operator==(const Surd& x, const Surd& y) { return x.a_ == y.a_ && x.b_ == y.b_; }

 private:
  Surd(Integer a, Integer b) : a_(std::move(a)), b_(std::move(b)) {}

  Integer a_, b_;
};

/// x |x|
inline Surd signed_square(const Surd& x) { return x.sign() < 0 ? -(x * x) : x * x; }

/// num / den, den > 0.
struct SurdFraction {
  Surd num, den = 1;

  friend bool operator<(const SurdFraction& x, const SurdFraction& y) {
    return x.num * y.den < y.num * x.den;
  }
  friend bool operator==(const SurdFraction& x, const SurdFraction& y) {
    return x.num * y.den == y.num * x.den;
  }
};

/// Within 2^-35. Requires |f| < 2^25.
Enclosure enclosure_of(const SurdFraction& f);

}  // namespace unsliver::prover
