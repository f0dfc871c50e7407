// Angles are compared by their cotangents, which fall as angles grow: no inverse function an angle, only one
// for each number that is reported.
#include "unsliver/quality.hpp"

#include <numbers>

#include "geom/shape_cache.hpp"
#include "geom/tetrahedron.hpp"

namespace unsliver {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// The angles of lattice tetrahedra lie exactly on the limits of bins and counts: rounding must not
/// spread them to both sides.
constexpr double kSlackDeg = 1e-9;

double cot_deg(double angle) { return 1 / std::tan(angle / kDegrees); }
double degrees(double cotangent) { return kDegrees * geom::angle_of_cotangent(cotangent); }

/// Cotangents of the angles that bins and counts end at.
struct Limits {
  Limits() {
    bins.fill(std::numeric_limits<double>::quiet_NaN());  // no angle reaches them
    for (int i = 1; i < 36; ++i) bins[i] = cot_deg(5 * i - kSlackDeg);
    bins[27] = largest;  // 135 itself is within the guarantee, so the bin below it takes it
  }
  std::array<double, 64> bins;
  std::array<double, 5> below = {cot_deg(5 - kSlackDeg), cot_deg(10 - kSlackDeg), cot_deg(15 - kSlackDeg),
                                 cot_deg(20 - kSlackDeg), cot_deg(30 - kSlackDeg)};
  double smallest = cot_deg(30 - kSlackDeg), largest = cot_deg(135 + kSlackDeg);
};

/// The last bin whose lower end the angle reaches. Without branches: angles are hard to predict.
std::size_t bin_of(double cotangent, const Limits& limits) {
  std::size_t bin = 0;
  for (std::size_t step = 32; step > 0; step /= 2) bin += step * (cotangent <= limits.bins[bin + step]);
  return bin;
}

/// The exponent of a power of two that brings the largest coordinate to about 1: angles and ratios do not
/// change, and their products of five lengths stay in range.
int normalizing_exponent(const std::vector<Vec3>& points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest > 0 ? std::min(-std::ilogb(largest), 1023) : 0;
}

Tet operator*(double s, const Tet& t) { return {s * t[0], s * t[1], s * t[2], s * t[3]}; }

/// visit(id, scale * corners) for each tetrahedron in turn. Corners lie far apart in memory: they are asked
/// for some tetrahedra ahead.
template <class Visit>
void for_each_tet(const TetMesh& mesh, double scale, const Visit& visit) {
  constexpr std::size_t kAhead = 16;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    if (i + kAhead < mesh.tets.size())
      for (const VertexId v : mesh.tets[i + kAhead]) __builtin_prefetch(&mesh.points[v]);
    visit(i, scale * mesh.corners(i));
  }
}

/// Cotangents of the smallest and the largest angle.
struct Extremes {
  double min_angle = -std::numeric_limits<double>::infinity();
  double max_angle = std::numeric_limits<double>::infinity();

  void add(const Extremes& other) {
    min_angle = std::max(min_angle, other.min_angle);
    max_angle = std::min(max_angle, other.max_angle);
  }
};

Extremes extremes_of(const std::array<double, 6>& cotangents) {
  Extremes extremes;
  for (const double c : cotangents) extremes.add({c, c});
  return extremes;
}

/// What a summary takes from a tetrahedron: it depends on the shape alone.
struct Measures {
  Extremes angles;
  double radius_edge, volume;
  std::array<std::uint8_t, 6> bins;
  std::uint8_t below;  ///< how many of Limits::below its smallest angle is below
  bool outside;        ///< of 30 to 135 degrees
};

Measures measure(const Tet& t, const Limits& limits) {
  const auto cotangents = geom::dihedral_cotangents(t);
  Measures m{};
  m.angles = extremes_of(cotangents);
  m.radius_edge = geom::radius_edge_ratio(t);
  m.volume = geom::volume(t);
  for (std::size_t i = 0; i < 6; ++i) m.bins[i] = std::uint8_t(bin_of(cotangents[i], limits));
  for (const double limit : limits.below) m.below += m.angles.min_angle > limit;
  m.outside = m.angles.min_angle > limits.smallest || m.angles.max_angle < limits.largest;
  return m;
}

void count(const Measures& m, QualitySummary& summary) {
  for (const std::uint8_t bin : m.bins) ++summary.histogram[bin];
  for (std::size_t i = summary.below.size() - m.below; i < summary.below.size(); ++i) ++summary.below[i];
  summary.outside_30_135 += m.outside;
  summary.volume += std::abs(m.volume);
  summary.inverted += m.volume < 0;
  summary.flat += m.volume == 0;
}

struct Candidate {
  double cotangent;  ///< of the smallest angle
  std::size_t tet;
};

bool worse(const Candidate& a, const Candidate& b) {
  return a.cotangent != b.cotangent ? a.cotangent > b.cotangent : a.tet < b.tet;
}

/// Keeps `worst`, a heap with the best of the worst on top, at no more than `count`.
void keep_worst(const Candidate& candidate, std::size_t count, std::vector<Candidate>& worst) {
  if (worst.size() == count) {
    if (count == 0 || !worse(candidate, worst.front())) return;
    std::pop_heap(worst.begin(), worst.end(), worse);
    worst.pop_back();
  }
  worst.push_back(candidate);
  std::push_heap(worst.begin(), worst.end(), worse);
}

WorstTet describe(const TetMesh& mesh, double to_unit, std::size_t tet) {
  const Tet t = to_unit * mesh.corners(tet);
  const Extremes angles = extremes_of(geom::dihedral_cotangents(t));
  return {tet, degrees(angles.min_angle), degrees(angles.max_angle), geom::radius_edge_ratio(t),
          mesh.corners(tet)};
}

}  // namespace

QualitySummary summarize_quality(const TetMesh& mesh, std::size_t worst_count) {
  const Limits limits;
  const int exponent = normalizing_exponent(mesh.points);
  const double to_unit = std::ldexp(1.0, exponent);
  QualitySummary summary;
  Extremes extremes;
  std::vector<Candidate> worst;
  geom::ShapeCache<Measures> cache;
  for_each_tet(mesh, to_unit, [&](std::size_t i, Tet tet) {
    const Measures& m = cache.get(tet, [&](const Tet& t) { return measure(t, limits); });
    count(m, summary);
    extremes.add(m.angles);
    summary.max_radius_edge = std::max(summary.max_radius_edge, m.radius_edge);
    keep_worst({m.angles.min_angle, i}, worst_count, worst);
  });
  summary.tets = mesh.tets.size();
  summary.min_dihedral_deg = degrees(extremes.min_angle);
  summary.max_dihedral_deg = degrees(extremes.max_angle);
  summary.volume = std::ldexp(summary.volume, -3 * exponent);
  std::sort_heap(worst.begin(), worst.end(), worse);
  for (const Candidate& candidate : worst) summary.worst.push_back(describe(mesh, to_unit, candidate.tet));
  return summary;
}

std::vector<float> min_dihedral_angles_deg(const TetMesh& mesh) {
  const double to_unit = std::ldexp(1.0, normalizing_exponent(mesh.points));
  std::vector<float> angles(mesh.tets.size());
  geom::ShapeCache<float> cache;
  for_each_tet(mesh, to_unit, [&](std::size_t i, Tet tet) {
    angles[i] = cache.get(tet, [](const Tet& t) {
      return float(degrees(extremes_of(geom::dihedral_cotangents(t)).min_angle));
    });
  });
  return angles;
}

}  // namespace unsliver
