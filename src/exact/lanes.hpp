/// \file
/// Four doubles that go through the same arithmetic at once, each rounded as a double alone is.
#pragma once

#include <cstddef>

/// A function for which GCC uses the widest registers that the processor has. Which they are makes no
/// difference to the result: nothing is contracted or reassociated. (The thread sanitizer cannot start
/// programs that choose functions as they are loaded.)
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define UNSLIVER_WIDEST_LANES __attribute__((target_clones("avx2", "default"), flatten))
#else
#define UNSLIVER_WIDEST_LANES
#endif

namespace unsliver::exact {

class Lanes {
 public:
  static constexpr std::size_t kCount = 4;

  Lanes() = default;
  explicit Lanes(double all) : v_{all, all, all, all} {}
  Lanes(double a, double b, double c, double d) : v_{a, b, c, d} {}

  double operator[](std::size_t i) const { return v_[i]; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.v_ + b.v_); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.v_ - b.v_); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.v_ * b.v_); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.v_ / b.v_); }
  friend Lanes operator-(const Lanes& a) { return Lanes(-a.v_); }
  friend Lanes min(const Lanes& a, const Lanes& b) { return Lanes(b.v_ < a.v_ ? b.v_ : a.v_); }
  friend Lanes max(const Lanes& a, const Lanes& b) { return Lanes(a.v_ < b.v_ ? b.v_ : a.v_); }
  friend Lanes abs(const Lanes& a) { return Lanes(a.v_ < 0 ? -a.v_ : a.v_); }

 private:
  typedef double Vector __attribute__((vector_size(kCount * sizeof(double))));
  explicit Lanes(const Vector& v) : v_(v) {}

  Vector v_;
};

}  // namespace unsliver::exact
