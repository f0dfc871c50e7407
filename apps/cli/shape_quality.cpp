#include "shape_quality.hpp"

#include <algorithm>

namespace unsliver::cli {
namespace {

QualitySummary summarize_one(const TetShape& shape) {
  TetMesh mesh;
  mesh.points.assign(shape.corners.begin(), shape.corners.end());
  mesh.tets = {{0, 1, 2, 3}};
  QualitySummary one = unsliver::summarize_quality(mesh, 1);
  for (WorstTet& worst : one.worst) worst.tet = static_cast<std::size_t>(shape.first_tet);
  return one;
}

void add(QualitySummary& sum, const QualitySummary& one, std::uint64_t times) {
  sum.tets += times;
  sum.min_dihedral_deg = std::min(sum.min_dihedral_deg, one.min_dihedral_deg);
  sum.max_dihedral_deg = std::max(sum.max_dihedral_deg, one.max_dihedral_deg);
  sum.max_radius_edge = std::max(sum.max_radius_edge, one.max_radius_edge);
  sum.volume += one.volume * static_cast<double>(times);
  sum.inverted += one.inverted * times;
  sum.flat += one.flat * times;
  sum.outside_30_135 += one.outside_30_135 * times;
  for (std::size_t i = 0; i < sum.histogram.size(); ++i) sum.histogram[i] += one.histogram[i] * times;
  for (std::size_t i = 0; i < sum.below.size(); ++i) sum.below[i] += one.below[i] * times;
  sum.worst.insert(sum.worst.end(), one.worst.begin(), one.worst.end());
}

}  // namespace

QualitySummary summarize_quality(const std::vector<TetShape>& shapes, std::size_t worst_count) {
  QualitySummary sum;
  for (const TetShape& shape : shapes) add(sum, summarize_one(shape), shape.tets);
  std::sort(sum.worst.begin(), sum.worst.end(), [](const WorstTet& a, const WorstTet& b) {
    return a.min_dihedral_deg != b.min_dihedral_deg ? a.min_dihedral_deg < b.min_dihedral_deg : a.tet < b.tet;
  });
  sum.worst.resize(std::min(worst_count, sum.worst.size()));
  return sum;
}

}  // namespace unsliver::cli
