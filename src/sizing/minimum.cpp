#include <algorithm>

#include "unsliver/error.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {
namespace {

class Minimum final : public Sizing {
 public:
  explicit Minimum(std::vector<SizingPtr> sizes) : sizes_(std::move(sizes)) {}

  double at(const Vec3& p) const override {
    return least([&p](const Sizing& s) { return s.at(p); });
  }

  double lower_bound(const Box3& box) const override {
    return least([&box](const Sizing& s) { return s.lower_bound(box); });
  }

  double lipschitz() const override {
    return -least([](const Sizing& s) { return -s.lipschitz(); });
  }

  double lipschitz_over(const Box3& box) const override {
    return -least([&box](const Sizing& s) { return -s.lipschitz_over(box); });
  }

  std::string describe() const override {
    std::string text = "minimum of: ";
    for (const SizingPtr& s : sizes_) text += (s == sizes_.front() ? "" : "; ") + s->describe();
    return text;
  }

  std::vector<std::string> notes() const override {
    std::vector<std::string> all;
    for (const SizingPtr& s : sizes_)
      for (std::string& note : s->notes()) all.push_back(std::move(note));
    return all;
  }

 private:
  template <class F>
  double least(F f) const {
    double value = f(*sizes_.front());
    for (std::size_t i = 1; i < sizes_.size(); ++i) value = std::min(value, f(*sizes_[i]));
    return value;
  }

  std::vector<SizingPtr> sizes_;
};

}  // namespace

SizingPtr minimum_size(std::vector<SizingPtr> sizes) {
  if (sizes.empty()) {
    throw Error(ErrorCode::kBadOption,
                "The minimum of no sizing functions was asked for; give at least one.");
  }
  if (sizes.size() == 1) return sizes.front();
  return std::make_shared<Minimum>(std::move(sizes));
}

}  // namespace unsliver
