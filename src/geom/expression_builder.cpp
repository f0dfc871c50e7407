#include "geom/expression_builder.hpp"

#include <algorithm>
#include <cmath>

#include "geom/expression_run.hpp"

namespace unsliver::geom {
namespace {

constexpr int kMostMultipliedPower = 64;
constexpr std::size_t kMostNormTerms = 8;

std::size_t deepest_stack(const Code& code) {
  std::size_t depth = 0, deepest = 0;
  for (const Instruction& i : code) {
    depth += 1 - static_cast<std::size_t>(operand_count(i));
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

}  // namespace

int operand_count(const Instruction& instruction) {
  const Op op = instruction.op;
  if (op == Op::kNorm) return instruction.count;
  if (op >= Op::kSelect) return 3;
  if (op >= Op::kAdd) return 2;
  return op >= Op::kNegate ? 1 : 0;
}

void ProgramBuilder::apply(Op op, int count) {
  const Instruction instruction{op, count};
  if (fold_constants(instruction)) return;
  if (op == Op::kMultiply && square_equal_factors()) return;
  if (op == Op::kPower && simplify_constant_power()) return;
  if (op == Op::kSqrt && turn_root_into_norm()) return;
  code_.push_back(instruction);
}

Program ProgramBuilder::finish() && {
  const std::size_t depth = deepest_stack(code_);
  return {std::move(code_), depth};
}

bool ProgramBuilder::fold_constants(const Instruction& instruction) {
  const std::size_t n = static_cast<std::size_t>(operand_count(instruction));
  const auto first = code_.end() - static_cast<std::ptrdiff_t>(n);
  if (!std::all_of(first, code_.end(), [](const Instruction& i) { return i.op == Op::kConstant; })) {
    return false;
  }
  Program constant{Code(first, code_.end()), n};
  constant.code.push_back(instruction);
  const double value = run<double>(constant, 0, 0, 0);
  code_.erase(first, code_.end());
  push_constant(value);
  return true;
}

bool ProgramBuilder::square_equal_factors() {
  const std::size_t right = operand_begin(code_.size());
  const std::size_t left = operand_begin(right);
  const auto at = [this](std::size_t i) { return code_.begin() + static_cast<std::ptrdiff_t>(i); };
  if (!std::equal(at(left), at(right), at(right), code_.end())) return false;
  code_.erase(at(right), code_.end());
  apply(Op::kSquare);
  return true;
}

bool ProgramBuilder::simplify_constant_power() {
  if (code_.back().op != Op::kConstant) return false;
  const double exponent = code_.back().constant;
  const bool multiplied =
      exponent == std::floor(exponent) && exponent != 0 && std::fabs(exponent) <= kMostMultipliedPower;
  if (!multiplied && exponent != 0.5) return false;
  code_.pop_back();
  if (exponent == 0.5) {
    apply(Op::kSqrt);
  } else if (exponent == 2) {
    apply(Op::kSquare);
  } else if (exponent != 1) {
    apply(Op::kPowerInt, static_cast<int>(exponent));
  }
  return true;
}

bool ProgramBuilder::turn_root_into_norm() {
  std::vector<Code> terms;
  std::size_t end = code_.size();
  const auto take_square = [&](std::size_t begin, std::size_t square_end) {
    if (code_[square_end - 1].op != Op::kSquare) return false;
    const auto at = [this](std::size_t i) { return code_.begin() + static_cast<std::ptrdiff_t>(i); };
    terms.emplace_back(at(begin), at(square_end - 1));
    return true;
  };
  while (code_[end - 1].op == Op::kAdd && terms.size() + 1 < kMostNormTerms) {
    const std::size_t begin = operand_begin(end - 1);
    if (!take_square(begin, end - 1)) return false;
    end = begin;
  }
  const std::size_t begin = operand_begin(end);
  if (!take_square(begin, end)) return false;
  code_.resize(begin);
  for (auto term = terms.rbegin(); term != terms.rend(); ++term) {
    code_.insert(code_.end(), term->begin(), term->end());
  }
  code_.push_back({Op::kNorm, static_cast<int>(terms.size())});
  return true;
}

std::size_t ProgramBuilder::operand_begin(std::size_t end) const {
  for (int missing = 1; missing > 0;) missing += operand_count(code_[--end]) - 1;
  return end;
}

}  // namespace unsliver::geom
