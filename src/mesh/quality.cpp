#include "unsliver/quality.hpp"

#include <numbers>

#include "geom/tetrahedron.hpp"

namespace unsliver {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kBinWidth = 5;
constexpr std::array<double, 5> kLimits = {5, 10, 15, 20, 30};

/// The angles of lattice tetrahedra lie exactly on the limits of bins and counts: rounding must not
/// spread them to both sides.
constexpr double kSlack = 1e-9;

/// The exponent of a power of two that brings the largest coordinate to about 1: angles and ratios do not
/// change, and their products of five lengths stay in range.
int normalizing_exponent(const std::vector<Vec3>& points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest > 0 ? std::min(-std::ilogb(largest), 1023) : 0;
}

Tet operator*(double s, const Tet& t) { return {s * t[0], s * t[1], s * t[2], s * t[3]}; }

struct Extremes {
  double min = 180, max = 0;
  void add(double angle) {
    min = std::min(min, angle);
    max = std::max(max, angle);
  }
};

Extremes count_angles(const Tet& t, std::array<std::uint64_t, 36>& histogram) {
  Extremes extremes;
  for (const double radians : geom::dihedral_angles(t)) {
    const double angle = kDegrees * radians;
    extremes.add(angle);
    ++histogram[std::min(std::size_t((angle + kSlack) / kBinWidth), histogram.size() - 1)];
  }
  return extremes;
}

void count_limits(const Extremes& angles, QualitySummary& summary) {
  for (std::size_t i = 0; i < kLimits.size(); ++i) summary.below[i] += angles.min < kLimits[i] - kSlack;
  summary.outside_30_135 += angles.min < 30 - kSlack || angles.max > 135 + kSlack;
  summary.min_dihedral_deg = std::min(summary.min_dihedral_deg, angles.min);
  summary.max_dihedral_deg = std::max(summary.max_dihedral_deg, angles.max);
}

void count_volume(const Tet& t, QualitySummary& summary) {
  const double volume = geom::volume(t);
  summary.volume += std::abs(volume);
  summary.inverted += volume < 0;
  summary.flat += volume == 0;
}

bool worse(const WorstTet& a, const WorstTet& b) {
  if (a.min_dihedral_deg != b.min_dihedral_deg) return a.min_dihedral_deg < b.min_dihedral_deg;
  return a.tet < b.tet;
}

/// Keeps `worst`, a heap with the best of the worst on top, at no more than `count`.
void keep_worst(const WorstTet& candidate, std::size_t count, std::vector<WorstTet>& worst) {
  if (worst.size() == count && (count == 0 || !worse(candidate, worst.front()))) return;
  if (worst.size() == count) {
    std::pop_heap(worst.begin(), worst.end(), worse);
    worst.pop_back();
  }
  worst.push_back(candidate);
  std::push_heap(worst.begin(), worst.end(), worse);
}

}  // namespace

QualitySummary summarize_quality(const TetMesh& mesh, std::size_t worst_count) {
  QualitySummary summary;
  summary.tets = mesh.tets.size();
  const int exponent = normalizing_exponent(mesh.points);
  const double to_unit = std::ldexp(1.0, exponent);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const Tet t = to_unit * mesh.corners(i);
    const Extremes angles = count_angles(t, summary.histogram);
    const double radius_edge = geom::radius_edge_ratio(t);
    count_limits(angles, summary);
    count_volume(t, summary);
    summary.max_radius_edge = std::max(summary.max_radius_edge, radius_edge);
    keep_worst({i, angles.min, angles.max, radius_edge, mesh.corners(i)}, worst_count, summary.worst);
  }
  summary.volume = std::ldexp(summary.volume, -3 * exponent);
  std::sort_heap(summary.worst.begin(), summary.worst.end(), worse);
  return summary;
}

std::vector<float> min_dihedral_angles_deg(const TetMesh& mesh) {
  const double to_unit = std::ldexp(1.0, normalizing_exponent(mesh.points));
  std::vector<float> angles(mesh.tets.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto six = geom::dihedral_angles(to_unit * mesh.corners(i));
    angles[i] = float(kDegrees * *std::min_element(six.begin(), six.end()));
  }
  return angles;
}

}  // namespace unsliver
