#include "refine/criteria.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

constexpr double kNoRatioDemand = 999;  // beyond this a bound means nothing, and squares outgrow 20 bits

void require(bool holds, const std::string& message) {
  if (!holds) throw Error(ErrorCode::kBadOption, message);
}

/// Flatter tetrahedra than these could be inverted when their input corners are written as they were given.
constexpr double kFlattestMin = 0.06, kFlattestMax = 179.94;

}  // namespace

exact::QualityBounds quality_bounds(const MeshOptions& options, bool with_input_vertices) {
  const double least_ratio = least_radius_edge(with_input_vertices);
  const double max_ratio = max_radius_edge(options, with_input_vertices);
  // Negated comparisons: NaN fails them too.
  require(options.min_dihedral_deg >= 0 && options.min_dihedral_deg <= 30,
          fmt::format(
              "minimum dihedral angle {}: must be between 0 and 30 degrees; no theorem backs more than 30 "
              "(Labelle 2006, section 4)",
              options.min_dihedral_deg));
  require(
      options.max_dihedral_deg >= 135 && options.max_dihedral_deg <= 180,
      fmt::format(
          "maximum dihedral angle {}: must be between 135 and 180 degrees; no theorem backs less than 135 "
          "(Labelle 2006, section 4)",
          options.max_dihedral_deg));
  require(
      !with_input_vertices || options.min_dihedral_deg >= kFlattestMin ||
          options.max_dihedral_deg <= kFlattestMax,
      fmt::format("angles from {} to {}: beside input vertices demand at least {} or at most {} degrees, or "
                  "rounding may invert tetrahedra",
                  options.min_dihedral_deg, options.max_dihedral_deg, kFlattestMin, kFlattestMax));
  require(max_ratio >= least_ratio * (1 - 1e-12),
          fmt::format(
              "maximum radius-edge ratio {}: must be at least {}; no theorem backs less (Labelle 2006, {})",
              max_ratio, with_input_vertices ? "1.368 beside input vertices" : "sqrt(5)/2 = 1.118034",
              with_input_vertices ? "section 5" : "section 4"));
  exact::QualityBounds bounds;
  // cos = 1 and cos = -1 demand nothing.
  bounds.min_dihedral = options.min_dihedral_deg > 0 ? exact::cos_bound(options.min_dihedral_deg, true)
                                                     : exact::CosBound{1, 1, 1};
  bounds.max_dihedral = options.max_dihedral_deg < 180 ? exact::cos_bound(options.max_dihedral_deg, false)
                                                       : exact::CosBound{-1, 1, 1};
  bounds.max_radius_edge = exact::ratio_bound(std::min(max_ratio, kNoRatioDemand));
  return bounds;
}

}  // namespace unsliver::refine
