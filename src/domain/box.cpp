#include <fmt/format.h>

#include "domain/ranges.hpp"
#include "domain/tet_box.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

class BoxDomain final : public Domain {
 public:
  explicit BoxDomain(const Box3& box) : box_(box) {}

  Box3 bounds() const override { return box_; }
  bool contains(const Vec3& p) const override { return box_.contains(p); }
  double clearance(const Vec3& p) const override {
    return contains(p) ? -domain::depth_in_box(p, box_) : domain::distance_to_box(p, box_);
  }
  bool meets(const Tet& t) const override { return domain::interior_meets_box(t, box_); }
  double volume() const override {
    const Vec3 side = box_.size();
    return side.x * side.y * side.z;
  }
  std::string describe() const override {
    return fmt::format("box, {} to {}", domain::format_point(box_.lo), domain::format_point(box_.hi));
  }

 private:
  Box3 box_;
};

}  // namespace

DomainPtr make_box(const Box3& box) {
  domain::require_usable_range(box, "the box");
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lo[axis] < box.hi[axis]) continue;
    throw Error(
        ErrorCode::kBadInput,
        fmt::format("the box has no extent along {}: it goes from {} to {}; give the smaller corner first",
                    "xyz"[axis], box.lo[axis], box.hi[axis]));
  }
  return std::make_shared<BoxDomain>(box);
}

}  // namespace unsliver
