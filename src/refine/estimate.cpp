// How large the mesh will be. What the size costs, from the integral of 1 / (2.862 s^3): BCC is the thinnest
// lattice covering of space by balls; with covering radius s its spacing is 4 s / sqrt 5, and each vertex has
// 32 / (5 sqrt 5) s^3 = 2.862 s^3 to itself. What input vertices cost, from their Delaunay tetrahedra: where
// all are good, nothing is inserted. All other constants are measured, on balls, boxes, surfaces, random
// points and meshes of TetGen.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "refine/refinement.hpp"
#include "unsliver/error.hpp"
#include "unsliver/refine.hpp"

namespace unsliver {

namespace {

constexpr double kVolumePerVertex = 2.862;  // in units of s^3
constexpr double kTetsPerVertex = 6;        // of BCC
constexpr double kBytesPerTet = 75;         // peak of the process, see bench/
constexpr double kTetRim = 0.6;             // tetrahedra cover the points within about this many s
constexpr double kVertexRim = 1.3;          // and their vertices lie within this many
constexpr int kCellsPerSide = 24;
constexpr int kMaxDepth = 10;
constexpr int kMaxSplits = 20000;

/// Vertices per BCC vertex: the price of grading, of rounding s to levels, and of a unit that does not fit s.
double surplus(Strategy strategy, double lipschitz, bool with_inputs) {
  const bool constant = lipschitz == 0;
  if (strategy == Strategy::kLiteral) return constant ? 3.3 : 2.9;
  if (strategy == Strategy::kOctree) return constant ? 1 : std::min(7.0, 2.2 + 6 * lipschitz);
  return !constant ? 2.1 : with_inputs ? 1.4 : 1;
}

/// Integrates 1/s^3 over the domain and around it, halving cells where s varies.
class Integral {
 public:
  Integral(const Domain& domain, const Sizing& sizing) : domain_(domain), sizing_(sizing) {
    const Box3 box = domain.bounds();
    const double reach = kVertexRim * std::min(largest_size(box), box.diagonal());
    std::array<std::vector<double>, 3> cuts;
    for (int axis = 0; axis < 3; ++axis) cuts[axis] = cuts_between(box.lo[axis], box.hi[axis], reach);
    for (std::size_t i = 1; i < cuts[0].size(); ++i)
      for (std::size_t j = 1; j < cuts[1].size(); ++j)
        for (std::size_t k = 1; k < cuts[2].size(); ++k)
          add({{cuts[0][i - 1], cuts[1][j - 1], cuts[2][k - 1]}, {cuts[0][i], cuts[1][j], cuts[2][k]}}, 0);
  }
  double inside = 0;       ///< over the domain
  double of_tets = 0;      ///< over the domain and what its tetrahedra reach beyond
  double of_vertices = 0;  ///< likewise the vertices

 private:
  /// Even inside, and outside the thicker the farther away. No cell is on both sides of an end, beyond which
  /// s may well be constant.
  static std::vector<double> cuts_between(double lo, double hi, double reach) {
    std::vector<double> cuts;
    for (const double share : {1.0, 0.5, 0.25, 0.125, 0.0625}) cuts.push_back(lo - share * reach);
    for (int i = 0; i <= kCellsPerSide; ++i) cuts.push_back(lo + (hi - lo) * i / kCellsPerSide);
    for (const double share : {0.0625, 0.125, 0.25, 0.5, 1.0}) cuts.push_back(hi + share * reach);
    return cuts;
  }

  double largest_size(const Box3& box) const {
    const Vec3 size = box.size();
    double largest = 0;
    for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0})
      for (const double y : {0.0, 0.25, 0.5, 0.75, 1.0})
        for (const double z : {0.0, 0.25, 0.5, 0.75, 1.0})
          largest = std::max(largest, size_at(box.lo + Vec3{x * size.x, y * size.y, z * size.z}));
    return largest;
  }

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
    const double outside = contained ? 0 : domain_.clearance(center) / s;
    if (contained) inside += amount;
    if (outside < kTetRim) of_tets += amount;
    if (outside < kVertexRim) of_vertices += amount;
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

  /// s; 0 where it is infinite and costs nothing, and where it is not defined, which is legal outside the
  /// domain.
  double size_at(const Vec3& p) const {
    try {
      const double s = sizing_.at(p);
      return std::isfinite(s) ? s : 0;
    } catch (const Error&) {
      return 0;
    }
  }

  const Domain& domain_;
  const Sizing& sizing_;
  int splits_ = 0;
};

/// The Delaunay tetrahedra of input vertices that meet the domain.
struct InputTets {
  double all = 0, bad = 0;
};

/// Looks at about kLooks of them: whether a point is in the domain can be a slow question.
InputTets survey(refine::Refinement& r) {
  constexpr std::size_t kLooks = 20000;
  const refine::TetId slots = r.mesh().slot_count();
  const auto step = static_cast<refine::TetId>(1 + slots / kLooks);
  InputTets found;
  for (refine::TetId t = 0; t < slots; t += step) {
    if (!r.mesh().is_finite(t) || r.finest_corner(t) != kNoVertex) continue;
    if (!r.meets_domain(t)) continue;
    found.all += step;
    if (r.is_bad(t)) found.bad += step;
  }
  return found;
}

/// Vertices inserted for each input vertex, `bad` of whose tetrahedra are. Under strict demands few bad ones
/// spoil all the others; under loose demands the damage stays where it is.
double vertices_per_input(const MeshOptions& options, double bad) {
  const double ratio = std::max(options.max_radius_edge, least_radius_edge(true));
  const double leniency = 0.055 * (30 - options.min_dihedral_deg) + 0.05 * (options.max_dihedral_deg - 135) +
                          1.6 * (std::min(ratio, 3.0) - least_radius_edge(true));
  const bool literal = options.strategy == Strategy::kLiteral;
  const double most = literal ? 95 * std::exp(-0.45 * leniency) : 24 * std::exp(-leniency);
  const double spread = std::min(1.0, 16 / (most * most));
  return most * (1 - std::exp(-bad / spread));
}

void add_inputs(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                const MeshOptions& options, SizeEstimate& estimate) {
  const Control control;
  refine::Refinement start(domain, sizing, inputs, options, control);
  const auto count = static_cast<double>(start.inputs().places().size());
  const InputTets tets = survey(start);
  const double inserted = count * vertices_per_input(options, tets.bad / count);
  estimate.vertices += count + inserted;
  estimate.tets += tets.all + kTetsPerVertex * inserted;
}

}  // namespace

SizeEstimate estimate_size(const Domain& domain, const Sizing& sizing, const MeshOptions& options) {
  return estimate_size(domain, sizing, {}, options);
}

SizeEstimate estimate_size(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                           const MeshOptions& options) {
  MeshOptions resolved = options;
  resolved.strategy = choose_strategy(options, sizing, !inputs.empty()).strategy;
  const Integral integral(domain, sizing);
  const double density = surplus(resolved.strategy, sizing.lipschitz(), !inputs.empty()) / kVolumePerVertex;
  SizeEstimate estimate;
  estimate.ideal_vertices = integral.inside / kVolumePerVertex;
  estimate.vertices = density * integral.of_vertices;
  estimate.tets = kTetsPerVertex * density * integral.of_tets;
  if (!inputs.empty()) add_inputs(domain, sizing, inputs, resolved, estimate);
  estimate.bytes = kBytesPerTet * estimate.tets;
  return estimate;
}

}  // namespace unsliver
