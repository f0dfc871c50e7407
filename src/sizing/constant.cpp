#include <fmt/format.h>

#include "sizing/checks.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {
namespace {

class Constant final : public Sizing {
 public:
  explicit Constant(double s) : s_(s) {}

  double at(const Vec3&) const override { return s_; }
  double lower_bound(const Box3&) const override { return s_; }
  double lipschitz() const override { return 0; }
  std::string describe() const override { return fmt::format("constant {}", s_); }

 private:
  double s_;
};

}  // namespace

SizingPtr constant_size(double s) {
  sizing::require_positive(s, "The size");
  return std::make_shared<Constant>(s);
}

}  // namespace unsliver
