#include <algorithm>
#include <cmath>
#include <memory>

#include "geom/point_tree.hpp"
#include "refine/guarantees.hpp"
#include "unsliver/error.hpp"
#include "unsliver/refine.hpp"

namespace unsliver {

namespace {

double size_or_zero(const Sizing& sizing, const Vec3& p) {
  try {
    return sizing.at(p);
  } catch (const Error&) {
    return 0;  // outside the domain s need not be defined
  }
}

}  // namespace

GradingGuarantee grading_guarantee(Strategy strategy, bool with_input_vertices) {
  const bool literal = strategy == Strategy::kLiteral;
  if (strategy == Strategy::kOctree) return {with_input_vertices ? refine::kFigure8ThriftyC : 0, 1, 0};
  if (strategy == Strategy::kClosure)
    return {refine::kClosureC, refine::kClosureLargestSize, refine::kClosureGrading};
  if (with_input_vertices)
    return {literal ? refine::kFigure8LiteralC : refine::kFigure8ThriftyC, 1, refine::kFigure8Grading};
  return {literal ? refine::kFigure5LiteralC : refine::kFigure5ThriftyC, 1, refine::kFigure5Grading};
}

/// With s(a) >= max(least, s(p) - L d), d = |pa|, the infimum of c s(a) + d is attained at d = 0 or where the
/// two bounds meet.
std::function<double(const Vec3&)> lfs_lower_bound(const Domain& domain, const Sizing& sizing,
                                                   const GradingGuarantee& grading) {
  const double c = grading.c, slope = sizing.lipschitz();
  const double cap = grading.largest_size * domain.bounds().diagonal();
  const double least = std::min(cap, sizing.lower_bound(domain.bounds()));
  return [&sizing, c, cap, slope, least](const Vec3& p) {
    const double s = std::min(cap, size_or_zero(sizing, p));
    if (!(s > 0) || c * slope <= 1) return c * std::max(0.0, s);
    return std::min(c * s, c * least + std::max(0.0, s - least) / slope);
  };
}

std::function<double(const Vec3&)> lfs_lower_bound(const Domain& domain, const Sizing& sizing,
                                                   const GradingGuarantee& grading,
                                                   std::vector<Vec3> inputs) {
  std::sort(inputs.begin(), inputs.end(), lex_less);
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  const auto tree = std::make_shared<geom::PointTree>(inputs);
  return [lfs_s = lfs_lower_bound(domain, sizing, grading), tree](const Vec3& p) {
    return std::min(lfs_s(p), std::sqrt(tree->two_nearest(p).second_sq));
  };
}

}  // namespace unsliver
