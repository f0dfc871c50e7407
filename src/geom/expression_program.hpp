/// \file
/// A formula as flat postfix code: what the parser builds and the evaluators run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace unsliver::geom {

enum class Op : std::uint8_t {
  kConstant,
  kX,
  kY,
  kZ,
  // one operand
  kNegate,
  kAbs,
  kSqrt,
  kCbrt,
  kExp,
  kLog,
  kLog10,
  kSin,
  kCos,
  kTan,
  kAsin,
  kAcos,
  kAtan,
  kSinh,
  kCosh,
  kTanh,
  kFloor,
  kCeil,
  kSign,
  kSquare,
  kPowerInt,  ///< the exponent is `count`
  // two operands
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kPower,
  kAtan2,
  kMin,
  kMax,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
  // three operands
  kSelect,
  kClamp,
  // `count` operands
  kNorm,  ///< square root of the sum of squares
};

struct Instruction {
  Op op;
  std::int32_t count = 0;
  double constant = 0;

  friend bool operator==(const Instruction&, const Instruction&) = default;
};

using Code = std::vector<Instruction>;

/// How many operands the instruction takes from the stack; it puts one back.
int operand_count(const Instruction& instruction);

struct Program {
  Code code;
  std::size_t stack_depth = 0;
};

/// \throws Error kBadOption with the column of the fault and what was expected.
Program compile(const std::string& text);

}  // namespace unsliver::geom
