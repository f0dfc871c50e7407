/// \file
/// Appends postfix code and simplifies on the way, so that bounds over boxes come out tight.
#pragma once

#include "geom/expression_program.hpp"

namespace unsliver::geom {

/// Operands are pushed in order, then the operation is applied. Simplifications made:
/// - operations on constants are carried out;
/// - u * u and u ^ 2 become a square, which intervals know to be >= 0; small integer powers multiply;
/// - the square root of a sum of squares becomes a norm, whose derivatives stay bounded at 0 (the distance
///   to a point is the commonest ingredient of sizing functions).
class ProgramBuilder {
 public:
  void push(Op variable) { code_.push_back({variable}); }
  void push_constant(double v) { code_.push_back({Op::kConstant, 0, v}); }
  /// `count` is the number of operands of kNorm, 0 for every other operation.
  void apply(Op op, int count = 0);
  Program finish() &&;

 private:
  bool fold_constants(const Instruction& instruction);
  bool square_equal_factors();
  bool simplify_constant_power();
  bool turn_root_into_norm();
  std::size_t operand_begin(std::size_t end) const;

  Code code_;
};

}  // namespace unsliver::geom
