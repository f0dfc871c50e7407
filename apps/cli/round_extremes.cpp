#include <algorithm>
#include <cmath>

#include "mesh_report.hpp"

namespace unsliver::cli {
namespace {

double rounded(double x) {
  constexpr int kDigits = 12;
  if (!std::isfinite(x) || x == 0) return x;
  const double scale = std::pow(10.0, kDigits - 1 - std::floor(std::log10(std::abs(x))));
  return std::isfinite(scale) ? std::round(x * scale) / scale : x;
}

void round_within(const QualityLimits& kept, double& min_angle, double& max_angle, double& ratio) {
  min_angle = std::max(kept.min_dihedral_deg, rounded(min_angle));
  max_angle = std::min(kept.max_dihedral_deg, rounded(max_angle));
  ratio = std::min(kept.max_radius_edge, rounded(ratio));
}

}  // namespace

void round_extremes(const QualityLimits& kept, VerifyReport& verified, QualitySummary& quality) {
  round_within(kept, verified.min_dihedral_deg, verified.max_dihedral_deg, verified.max_radius_edge);
  round_within(kept, quality.min_dihedral_deg, quality.max_dihedral_deg, quality.max_radius_edge);
  for (WorstTet& tet : quality.worst)
    round_within(kept, tet.min_dihedral_deg, tet.max_dihedral_deg, tet.radius_edge);
}

}  // namespace unsliver::cli
