/// \file
/// Signed integers of a fixed number of 64-bit words, for the last stages of the exact predicates.
#pragma once

#include <bit>
#include <cstdint>

namespace unsliver::exact {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// Two's complement, kWords * 64 bits. Results are reduced modulo 2^(64 kWords): they are the true ones where
/// the caller proves that these fit, and intermediate overflow then does no harm.
template <int kWords>
class WideInt {
  static_assert(kWords >= 2);

 public:
  static constexpr int kBits = 64 * kWords;

  constexpr WideInt() = default;
  constexpr explicit WideInt(Int128 value) {
    words_[0] = static_cast<std::uint64_t>(value);
    words_[1] = static_cast<std::uint64_t>(value >> 64);
    extend_sign(2);
  }
  template <int kNarrow>
  requires(kNarrow < kWords) constexpr explicit WideInt(const WideInt<kNarrow>& value) {
    for (int i = 0; i < kNarrow; ++i) words_[i] = value.word(i);
    extend_sign(kNarrow);
  }

  constexpr std::uint64_t word(int i) const { return words_[i]; }

  /// -1, 0 or +1.
  constexpr int sign() const {
    if (words_[kWords - 1] >> 63) return -1;
    for (std::uint64_t word : words_)
      if (word != 0) return 1;
    return 0;
  }

  friend constexpr WideInt operator+(const WideInt& a, const WideInt& b) {
    WideInt sum;
    UInt128 carry = 0;
    for (int i = 0; i < kWords; ++i) {
      carry += static_cast<UInt128>(a.words_[i]) + b.words_[i];
      sum.words_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }

  friend constexpr WideInt operator-(const WideInt& a) {
    WideInt inverted;
    for (int i = 0; i < kWords; ++i) inverted.words_[i] = ~a.words_[i];
    return inverted + WideInt(1);
  }

  friend constexpr WideInt operator-(const WideInt& a, const WideInt& b) { return a + -b; }

  friend constexpr WideInt operator*(const WideInt& a, const WideInt& b) {
    WideInt product;
    for (int i = 0; i < kWords; ++i) {
      UInt128 carry = 0;
      for (int j = 0; i + j < kWords; ++j) {
        carry += static_cast<UInt128>(a.words_[i]) * b.words_[j] + product.words_[i + j];
        product.words_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return product;
  }

  friend constexpr bool operator==(const WideInt&, const WideInt&) = default;

 private:
  constexpr void extend_sign(int from) {
    const std::uint64_t fill = words_[from - 1] >> 63 ? ~std::uint64_t{0} : 0;
    for (int i = from; i < kWords; ++i) words_[i] = fill;
  }

  std::uint64_t words_[kWords] = {};
};

using Int256 = WideInt<4>;
using Int512 = WideInt<8>;

constexpr int sign_of(double v) { return (v > 0) - (v < 0); }
constexpr int sign_of(std::int64_t v) { return (v > 0) - (v < 0); }
constexpr int sign_of(Int128 v) { return (v > 0) - (v < 0); }
template <int kWords>
constexpr int sign_of(const WideInt<kWords>& v) {
  return v.sign();
}

/// factor * (2^bits)^degree <= 2^bit_budget: a signed type needs one bit more.
constexpr int bit_budget(std::uint64_t factor, int degree, int bits) {
  return degree * bits + static_cast<int>(std::bit_width(factor - 1));
}

}  // namespace unsliver::exact
