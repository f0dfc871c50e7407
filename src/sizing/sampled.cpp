#include <fmt/format.h>

#include "sizing/checks.hpp"
#include "sizing/grid.hpp"
#include "unsliver/error.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {
namespace {

constexpr std::size_t kFewestSamples = 8;
constexpr std::size_t kMostSamples = std::size_t{1} << 28;
/// Stands for infinity, which cannot be interpolated.
constexpr double kHuge = 1e300;

class Sampled final : public Sizing {
 public:
  explicit Sampled(sizing::Grid grid) : grid_(std::move(grid)) {}

  double at(const Vec3& p) const override { return grid_.at(p); }
  double lower_bound(const Box3& box) const override { return grid_.lower_bound(box); }
  double lipschitz() const override { return grid_.lipschitz(); }

  std::string describe() const override {
    return fmt::format("function sampled at {}", grid_.shape().describe());
  }

  std::vector<std::string> notes() const override {
    return {
        fmt::format("the size function was sampled once on a grid of {} over {} and is interpolated "
                    "trilinearly: detail finer than the grid is not seen; outside, the size is that of "
                    "the nearest point inside",
                    grid_.shape().describe(), sizing::to_text(grid_.shape().bounds))};
  }

 private:
  sizing::Grid grid_;
};

[[noreturn]] void refuse_thrown(const Vec3& p, const char* what) {
  Error error(ErrorCode::kBadInput,
              fmt::format("The size function threw an exception at {}: {}", sizing::to_text(p), what));
  error.places.push_back(p);
  throw error;
}

double called(const std::function<double(const Vec3&)>& f, const Vec3& p) {
  try {
    return f(p);
  } catch (const std::exception& e) {
    refuse_thrown(p, e.what());
  } catch (...) {
    refuse_thrown(p, "of unknown type");
  }
}

std::vector<Vec3> nodes_of(const sizing::GridShape& shape) {
  std::vector<Vec3> nodes;
  nodes.reserve(shape.node_count());
  for (std::uint32_t k = 0; k < shape.counts[2]; ++k)
    for (std::uint32_t j = 0; j < shape.counts[1]; ++j)
      for (std::uint32_t i = 0; i < shape.counts[0]; ++i) nodes.push_back(shape.node(i, j, k));
  return nodes;
}

}  // namespace

SizingPtr sampled_size(std::function<double(const Vec3&)> f, const Box3& bounds, std::size_t samples) {
  if (!f) throw Error(ErrorCode::kBadInput, "The size function is empty.");
  const auto one_by_one = [&f](const std::vector<Vec3>& points) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Vec3& p : points) values.push_back(called(f, p));
    return values;
  };
  return sampled_size_at_once(one_by_one, bounds, samples);
}

SizingPtr sampled_size_at_once(const ManyValues& f, const Box3& bounds, std::size_t samples) {
  sizing::require_bounds(bounds);
  if (!f) throw Error(ErrorCode::kBadInput, "The size function is empty.");
  if (samples < kFewestSamples || samples > kMostSamples) {
    throw Error(ErrorCode::kBadOption,
                fmt::format("{} samples of the size function were asked for; from {} to {} are possible.",
                            samples, kFewestSamples, kMostSamples));
  }
  const auto shape = sizing::GridShape::about(bounds, samples);
  const std::vector<Vec3> nodes = nodes_of(shape);
  std::vector<double> values = f(nodes);
  if (values.size() != nodes.size())
    throw Error(ErrorCode::kBadInput,
                fmt::format("The size function gave {} values for {} points.", values.size(), nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    values[i] = std::min(sizing::checked_size(values[i], nodes[i], "sampled function"), kHuge);
  return std::make_shared<Sampled>(sizing::Grid(shape, std::move(values)));
}

}  // namespace unsliver
