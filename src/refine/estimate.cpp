// How large the mesh will be, from the integral of 1 / (2.862 s^3). BCC is the thinnest lattice covering of
// space by balls: with covering radius s its spacing is 4 s / sqrt 5, and each vertex has 32 / (5 sqrt 5) s^3
// = 2.862 s^3 to itself.
#include <cmath>

#include "unsliver/error.hpp"
#include "unsliver/refine.hpp"

namespace unsliver {

namespace {

constexpr double kVolumePerVertex = 2.862;  // in units of s^3
constexpr double kTetsPerVertex = 5.9;
constexpr double kBytesPerTet = 75;     // measured peak, see bench/
constexpr double kRimShare = 0.6;       // tetrahedra reach about this many s beyond the domain
constexpr double kGradedSurplus = 2.3;  // rounding of s to lattice levels and grading cost up to this factor
constexpr double kLiteralSurplus = 2.9;
constexpr int kCellsPerSide = 24;
constexpr int kMaxDepth = 10;
constexpr int kMaxSplits = 20000;

/// Integrates 1/s^3 over the domain and its rim, halving cells where s varies.
class Integral {
 public:
  Integral(const Domain& domain, const Sizing& sizing) : domain_(domain), sizing_(sizing) {
    const Box3 box = domain.bounds();
    const Vec3 step = (1.0 / kCellsPerSide) * box.size();
    for (int i = 0; i < kCellsPerSide; ++i)
      for (int j = 0; j < kCellsPerSide; ++j)
        for (int k = 0; k < kCellsPerSide; ++k) {
          const Vec3 lo = box.lo + Vec3{i * step.x, j * step.y, k * step.z};
          add({lo, lo + step}, 0);
        }
  }
  double inside = 0;    ///< over the domain
  double with_rim = 0;  ///< over the domain and what its tetrahedra reach beyond

 private:
  void add(const Box3& cell, int depth) {
    const Vec3 center = cell.center();
    const double s = size_at(center);
    if (!(s > 0)) return;
    if (depth < kMaxDepth && splits_ < kMaxSplits && sizing_.lower_bound(cell) < 0.6 * s) {
      ++splits_;
      split(cell, depth);
      return;
    }
    const Vec3 side = cell.size();
    const double amount = side.x * side.y * side.z / (s * s * s);
    const bool contained = domain_.contains(center);
    if (contained) inside += amount;
    if (contained || domain_.clearance(center) < kRimShare * s) with_rim += amount;
  }

  void split(const Box3& cell, int depth) {
    const Vec3 middle = cell.center();
    for (int child = 0; child < 8; ++child) {
      Box3 part;
      for (int axis = 0; axis < 3; ++axis) {
        const bool upper = child >> axis & 1;
        part.lo[axis] = upper ? middle[axis] : cell.lo[axis];
        part.hi[axis] = upper ? cell.hi[axis] : middle[axis];
      }
      add(part, depth + 1);
    }
  }

  /// s, or 0 where it is not defined, which is legal outside the domain.
  double size_at(const Vec3& p) const {
    try {
      return sizing_.at(p);
    } catch (const Error&) {
      return 0;
    }
  }

  const Domain& domain_;
  const Sizing& sizing_;
  int splits_ = 0;
};

}  // namespace

SizeEstimate estimate_size(const Domain& domain, const Sizing& sizing, const MeshOptions& options) {
  const Integral integral(domain, sizing);
  const bool literal = options.strategy == Strategy::kLiteral;
  const double surplus = literal ? kLiteralSurplus : sizing.lipschitz() == 0 ? 1.0 : kGradedSurplus;
  SizeEstimate estimate;
  estimate.ideal_vertices = integral.inside / kVolumePerVertex;
  estimate.vertices = surplus * integral.with_rim / kVolumePerVertex + 100;
  estimate.tets = kTetsPerVertex * estimate.vertices;
  estimate.bytes = kBytesPerTet * estimate.tets;
  return estimate;
}

}  // namespace unsliver
