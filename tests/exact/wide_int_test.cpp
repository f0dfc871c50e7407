#include "exact/wide_int.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

namespace unsliver::exact {
namespace {

using Integer = boost::multiprecision::cpp_int;

static_assert((Int256(3) * Int256(-5) + Int256(16)) == Int256(1));
static_assert((Int512(-1) - Int512(-1)).sign() == 0);
static_assert((-Int256(7)).sign() == -1);
static_assert(Int512(Int256(-9)) == Int512(-9));
static_assert(bit_budget(72, 5, 49) == 252 && bit_budget(1, 1, 3) == 3 && bit_budget(4, 1, 3) == 5);

/// The value that the words mean.
template <int kWords>
Integer value_of(const WideInt<kWords>& v) {
  Integer value = 0;
  for (int i = kWords - 1; i >= 0; --i) value = (value << 64) + v.word(i);
  if (v.sign() < 0) value -= Integer(1) << (64 * kWords);
  return value;
}

/// A random value below 2^bits in size, built with the operations under test and beside them.
template <int kWords>
struct Sample {
  WideInt<kWords> wide{0};
  Integer value = 0;

  Sample(std::mt19937_64& random, int bits) {
    for (int got = 0; got < bits; got += 32) {
      const auto digit = static_cast<std::int64_t>(random() >> 32);
      wide = wide * WideInt<kWords>(std::int64_t{1} << 32) + WideInt<kWords>(digit);
      value = (value << 32) + digit;
    }
    if (random() & 1) wide = -wide, value = -value;
  }
};

template <int kWords>
void check_arithmetic(int bits) {
  SCOPED_TRACE("seed 1");
  std::mt19937_64 random(1);
  for (int n = 0; n < 2000; ++n) {
    const Sample<kWords> a(random, bits), b(random, bits);
    ASSERT_EQ(value_of(a.wide), a.value);
    ASSERT_EQ(value_of(a.wide + b.wide), a.value + b.value);
    ASSERT_EQ(value_of(a.wide - b.wide), a.value - b.value);
    ASSERT_EQ(value_of(a.wide * b.wide), a.value * b.value);
    ASSERT_EQ((a.wide - b.wide).sign(), a.value.compare(b.value) < 0 ? -1 : a.value != b.value);
    ASSERT_EQ((a.wide - a.wide).sign(), 0);
    ASSERT_EQ(value_of(WideInt<kWords + 2>(a.wide)), a.value);
  }
}

TEST(WideInt, Agrees256) {
  check_arithmetic<4>(32);
  check_arithmetic<4>(96);
}

TEST(WideInt, Agrees512) {
  check_arithmetic<8>(64);
  check_arithmetic<8>(224);
}

TEST(WideInt, ConvertsFrom128Bits) {
  const Int128 big = static_cast<Int128>(1) << 126;
  EXPECT_EQ(value_of(Int256(big)), Integer(1) << 126);
  EXPECT_EQ(value_of(Int256(-big)), -(Integer(1) << 126));
}

/// Carries through all words, and the ends of the range.
TEST(WideInt, CarriesAndLimits) {
  const Int128 word = static_cast<Int128>(1) << 64;
  Int256 power(1);
  for (int i = 0; i < 3; ++i) power = power * Int256(word);
  EXPECT_EQ(value_of(power - Int256(1)), (Integer(1) << 192) - 1);
  EXPECT_EQ(value_of(-power), -(Integer(1) << 192));
  EXPECT_EQ(value_of(power - Int256(1) + Int256(1)), Integer(1) << 192);
  EXPECT_EQ((power - power).sign(), 0);
}

}  // namespace
}  // namespace unsliver::exact
