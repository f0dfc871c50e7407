/// \file
/// A size on a periodic cell.
#pragma once

#include "unsliver/sizing.hpp"

namespace unsliver::sizing {

/// s repeated with the period of the cell, and lowered where it would jump at the faces: with L its Lipschitz
/// constant, s'(p) is the least of s(p) and s(q) + L |p + T - q|, q the point of the cell nearest to p + T,
/// over the vectors T to neighbouring cells. Then s' <= s, with equality all over where s does not jump; and
/// s' is sqrt(2) L-Lipschitz on the torus, because q and |p + T - q| vary at right angles. Where s has no L,
/// it is repeated as it is. Nothing is asked of s beyond the cell. `s` must outlive the result.
class Periodic final : public Sizing {
 public:
  Periodic(const Sizing& s, const Box3& cell);

  double at(const Vec3& p) const override;
  double lower_bound(const Box3& box) const override;
  double lipschitz() const override;
  std::string describe() const override { return s_.describe(); }
  std::vector<std::string> notes() const override { return s_.notes(); }

 private:
  double least_over(const Box3& query) const;

  const Sizing& s_;
  Box3 cell_;
  double slope_;  ///< L; 0 where there is none
  double least_;  ///< a lower bound of s
};

}  // namespace unsliver::sizing
