/// \file
/// Runs a formula's code on doubles, intervals or duals: one loop, so that all three mean the same formula.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "geom/dual.hpp"
#include "geom/expression_program.hpp"
#include "geom/interval.hpp"

namespace unsliver::geom {

// The double versions of the operations whose C++ namesake differs: zeros of divisors count as +0, so that
// 1 / 0 has one value, and NaN is never swallowed.
inline double divide(double a, double b) { return a / (b + 0.0); }
inline double square(double a) { return a * a; }
inline double power(double a, double b) { return std::pow(a + 0.0, b); }
inline double atan2(double y, double x) { return std::atan2(y + 0.0, x + 0.0); }
inline double sign(double a) { return std::isnan(a) ? a : (a > 0) - (a < 0); }
inline double nan_of(double a, double b) { return a + b; }
inline double smaller(double a, double b) { return a < b ? a : a >= b ? b : nan_of(a, b); }
inline double larger(double a, double b) { return a > b ? a : a <= b ? b : nan_of(a, b); }
inline double less(double a, double b) { return a < b ? 1 : a >= b ? 0 : nan_of(a, b); }
inline double less_equal(double a, double b) { return a <= b ? 1 : a > b ? 0 : nan_of(a, b); }
inline double select(double condition, double yes, double no) {
  return std::isnan(condition) ? condition : condition != 0 ? yes : no;
}
inline double norm(std::span<const double> terms) {
  double sum = 0;
  for (double t : terms) sum += t * t;
  return std::sqrt(sum);
}
inline double power_int(double a, int n) {
  double result = 1;
  for (int m = n < 0 ? -n : n; m > 0; m /= 2) {
    if (m % 2 == 1) result *= a;
    a *= a;
  }
  return n < 0 ? divide(1, result) : result;
}

template <class T>
T constant_as(double v) {
  if constexpr (std::is_same_v<T, double>) {
    return v;
  } else if constexpr (std::is_same_v<T, Interval>) {
    return Interval::point(v);
  } else {
    return Dual{Interval::point(v), {}, 0, 0};
  }
}

/// Runs on the given stack of at least program.stack_depth places.
template <class T>
T run_on(const Program& program, const T& x, const T& y, const T& z, T* stack) {
  using std::abs, std::sqrt, std::cbrt, std::exp, std::log, std::log10, std::sin, std::cos, std::tan;
  using std::asin, std::acos, std::atan, std::sinh, std::cosh, std::tanh, std::floor, std::ceil;
  T* top = stack - 1;
  for (const Instruction& i : program.code) {
    switch (i.op) {
      case Op::kConstant:
        *++top = constant_as<T>(i.constant);
        break;
      case Op::kX:
        *++top = x;
        break;
      case Op::kY:
        *++top = y;
        break;
      case Op::kZ:
        *++top = z;
        break;
      case Op::kNegate:
        *top = -*top;
        break;
      case Op::kAbs:
        *top = abs(*top);
        break;
      case Op::kSqrt:
        *top = sqrt(*top);
        break;
      case Op::kCbrt:
        *top = cbrt(*top);
        break;
      case Op::kExp:
        *top = exp(*top);
        break;
      case Op::kLog:
        *top = log(*top);
        break;
      case Op::kLog10:
        *top = log10(*top);
        break;
      case Op::kSin:
        *top = sin(*top);
        break;
      case Op::kCos:
        *top = cos(*top);
        break;
      case Op::kTan:
        *top = tan(*top);
        break;
      case Op::kAsin:
        *top = asin(*top);
        break;
      case Op::kAcos:
        *top = acos(*top);
        break;
      case Op::kAtan:
        *top = atan(*top);
        break;
      case Op::kSinh:
        *top = sinh(*top);
        break;
      case Op::kCosh:
        *top = cosh(*top);
        break;
      case Op::kTanh:
        *top = tanh(*top);
        break;
      case Op::kFloor:
        *top = floor(*top);
        break;
      case Op::kCeil:
        *top = ceil(*top);
        break;
      case Op::kSign:
        *top = sign(*top);
        break;
      case Op::kSquare:
        *top = square(*top);
        break;
      case Op::kPowerInt:
        *top = power_int(*top, i.count);
        break;
      case Op::kAdd:
        --top, top[0] = top[0] + top[1];
        break;
      case Op::kSubtract:
        --top, top[0] = top[0] - top[1];
        break;
      case Op::kMultiply:
        --top, top[0] = top[0] * top[1];
        break;
      case Op::kDivide:
        --top, top[0] = divide(top[0], top[1]);
        break;
      case Op::kPower:
        --top, top[0] = power(top[0], top[1]);
        break;
      case Op::kAtan2:
        --top, top[0] = atan2(top[0], top[1]);
        break;
      case Op::kMin:
        --top, top[0] = smaller(top[0], top[1]);
        break;
      case Op::kMax:
        --top, top[0] = larger(top[0], top[1]);
        break;
      case Op::kLess:
        --top, top[0] = less(top[0], top[1]);
        break;
      case Op::kLessEqual:
        --top, top[0] = less_equal(top[0], top[1]);
        break;
      case Op::kGreater:
        --top, top[0] = less(top[1], top[0]);
        break;
      case Op::kGreaterEqual:
        --top, top[0] = less_equal(top[1], top[0]);
        break;
      case Op::kSelect:
        top -= 2, top[0] = select(top[0], top[1], top[2]);
        break;
      case Op::kClamp:
        top -= 2, top[0] = smaller(larger(top[0], top[1]), top[2]);
        break;
      case Op::kNorm:
        top -= i.count - 1;
        *top = norm(std::span<const T>(top, static_cast<std::size_t>(i.count)));
        break;
    }
  }
  return *top;
}

template <class T>
T run(const Program& program, const T& x, const T& y, const T& z) {
  constexpr std::size_t kUsualDepth = 12;
  if (program.stack_depth <= kUsualDepth) {
    std::array<T, kUsualDepth> stack;
    return run_on(program, x, y, z, stack.data());
  }
  std::vector<T> stack(program.stack_depth);
  return run_on(program, x, y, z, stack.data());
}

}  // namespace unsliver::geom
