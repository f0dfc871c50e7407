#include "refine/periodic_refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "delaunay/periodic_start.hpp"
#include "refine/criteria.hpp"
#include "refine/guarantees.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Of the cap that the header describes: rounding must not reach it.
constexpr double kCapShare = 0.999;
/// More vertices than this in the start alone are no mesh that anybody meant.
constexpr double kMostStartPoints = 0x1p23;

void require_few_points(const PeriodicWorld& place, Level level) {
  const Vec3 steps = 1 / lattice::power_of_two(lattice::exponent(level)) * place.period();
  const double points = (lattice::is_bcc(level) ? 2 : 1) * steps.x * steps.y * steps.z;
  if (points <= kMostStartPoints) return;
  const Vec3 size = place.cell().size();
  throw Error(
      ErrorCode::kLimit,
      fmt::format(
          "a periodic cell of {} x {} x {} needs {:.2g} vertices before it closes upon itself without "
          "tetrahedra that meet their own copies: repeat the cell along its shortest side",
          size.x, size.y, size.z, points));
}

/// All points of the level at home.
template <class Visit>
void for_each_lattice_point(Level level, const Vec3& period, const Visit& visit) {
  const double spacing = lattice::power_of_two(lattice::exponent(level));
  for (double x = 0; x < period.x; x += spacing)
    for (double y = 0; y < period.y; y += spacing)
      for (double z = 0; z < period.z; z += spacing) {
        visit(Vec3{x, y, z});
        if (lattice::is_bcc(level)) visit(Vec3{x, y, z} + 0.5 * Vec3{spacing, spacing, spacing});
      }
}

/// The points of the level whose regions are empty, and an input vertex from each region that is not.
std::vector<Vec3> start_points(const delaunay::Torus& torus, const PeriodicInputs& inputs, Level level) {
  std::vector<Vec3> points, chosen;
  for_each_lattice_point(level, torus.period(), [&](const Vec3& w) {
    const std::optional<Vec3> u = inputs.empty() ? std::nullopt : inputs.in_region(w, level);
    if (u)
      chosen.push_back(torus.home_of(*u));
    else
      points.push_back(w);
  });
  std::sort(chosen.begin(), chosen.end(), lex_less);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  points.insert(points.end(), chosen.begin(), chosen.end());
  return points;
}

/// The coarsest lattice that serves. Without input vertices the first one does, and with them any of which no
/// ball of radius r(SC_k) + 2^k rho can miss all points and all input vertices in the regions of points.
PeriodicRefinement::Start find_start(const PeriodicWorld& place, const PeriodicInputs& inputs) {
  const delaunay::Torus torus = place.torus();
  const double radius = (1 - kSizeSlack) * place.largest_size();
  const auto is_small = [&](const Tet& t) {
    return circumsphere(t).radius_sq < radius * radius * (1 + 1e-8);
  };
  for (Level level = lattice::coarsest_within(radius);; --level) {
    if (!inputs.empty() && lattice::is_bcc(level)) --level;  // regions are made for SC
    require_few_points(place, level);
    if (auto mesh = delaunay::periodic_start(torus, start_points(torus, inputs, level), is_small))
      return {*std::move(mesh), level};
  }
}

/// Refused as lattice::find_sites refuses them, who does not see across the faces of the cell.
void require_apart(const PeriodicWorld& place, const PeriodicInputs& inputs) {
  const double unit = place.world().unit();
  const double step = lattice::power_of_two(lattice::exponent(place.world().finest_level()));
  const double least =
      std::max(lattice::kLeastSeparation * place.cell().longest_side() / unit, lattice::kStepsBetween * step);
  for (VertexId site = 0; site < inputs.places().size(); ++site) {
    if (!inputs.lfs_at_most(inputs.places()[site], least)) continue;
    const VertexId id = inputs.sites().first_point[site];
    const Vec3& p = place.wrapped()[id];
    Error error(
        ErrorCode::kBadInput,
        fmt::format("point {}, at ({}, {}, {}) in the periodic cell, is nearer than {:.3g} to another one "
                    "or its copy: merge such points",
                    id, p.x, p.y, p.z, least * unit));
    error.ids.push_back(id);
    error.places.push_back(p);
    throw error;
  }
}

PeriodicInputs make_inputs(const PeriodicWorld& place) {
  lattice::InputSites sites = lattice::find_sites(place.wrapped(), place.cell().longest_side());
  std::vector<Vec3> places = lattice::to_world(sites, place.wrapped(), place.world());
  const delaunay::Torus torus = place.torus();
  for (Vec3& p : places) p = torus.home_of(p - place.in_frame({}));
  PeriodicInputs inputs(Inputs(std::move(sites), std::move(places)), place.period(), place.coarsest_level());
  require_apart(place, inputs);
  return inputs;
}

}  // namespace

PeriodicWorld::PeriodicWorld(const Box3& cell, const octree::BoxLattice& lattice,
                             std::span<const Vec3> inputs)
    : cell_(cell), lattice_(lattice) {
  wrapped_.reserve(inputs.size());
  for (const Vec3& x : inputs) wrapped_.push_back(home(x));
  meet_moved(inputs);
  if (wrapped_.empty() || !is_finite(wrapped_.front())) return;
  const double spacing = lattice::power_of_two(lattice_.brick.exponent);
  shift_ = (1 / spacing) * world().to_world(wrapped_.front());
  for (int axis = 0; axis < 3; ++axis) shift_[axis] = spacing * std::floor(shift_[axis]);
}

/// Moving rounds: copies of one point may come home some units apart. Those that were moved join those that
/// were not, or the first of them.
void PeriodicWorld::meet_moved(std::span<const Vec3> inputs) {
  const auto less = [](const Vec3& a, const Vec3& b) { return lex_less(a, b); };
  std::map<Vec3, Vec3, decltype(less)> known(less);  // by place
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (wrapped_[i] == inputs[i])
      known.emplace(world().to_world(wrapped_[i]), wrapped_[i]);
    else
      moved.push_back(i);
  for (const std::size_t i : moved) {
    const Vec3 place = world().to_world(wrapped_[i]);
    auto at = known.find(place);
    for (int n = 0; n < 27 && at == known.end(); ++n) {
      const int x = n % 3 - 1, y = n / 3 % 3 - 1, z = n / 9 - 1;
      at = known.find(place + Vec3{double(x), double(y), double(z)});
    }
    if (at == known.end()) at = known.emplace(place, wrapped_[i]).first;
    wrapped_[i] = at->second;
  }
}

Vec3 PeriodicWorld::period() const {
  const auto& count = lattice_.brick.count;
  return lattice::power_of_two(lattice_.brick.exponent) *
         Vec3{double(count[0]), double(count[1]), double(count[2])};
}

double PeriodicWorld::largest_size() const {
  const Vec3 sides = period();
  const double quarter = 0.25 * std::min({sides.x, sides.y, sides.z});
  return kCapShare * std::min(quarter, lattice::covering_radius(coarsest_level() + 1));
}

Vec3 PeriodicWorld::home(const Vec3& x) const {
  Vec3 result = x;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = cell_.lo[axis], hi = cell_.hi[axis];
    const double periods = std::floor((x[axis] - lo) / (hi - lo));
    if (periods != 0) result[axis] -= periods * (hi - lo);
  }
  const Vec3 place = world().to_world(result), end = period();
  for (int axis = 0; axis < 3; ++axis)
    // Less than a unit below the upper face, or below the lower one by rounding.
    if (place[axis] >= end[axis] || result[axis] < cell_.lo[axis]) result[axis] = cell_.lo[axis];
  return result;
}

Vec3 PeriodicWorld::to_caller(const Vec3& p) const { return world().to_caller(torus().home_of(in_frame(p))); }

PeriodicRefinement::PeriodicRefinement(const PeriodicWorld& place, const Sizing& sizing,
                                       const MeshOptions& options, const Control& control)
    : PeriodicRefinement(place, sizing, make_inputs(place), options, control) {}

PeriodicRefinement::PeriodicRefinement(const PeriodicWorld& place, const Sizing& sizing,
                                       PeriodicInputs inputs, const MeshOptions& options,
                                       const Control& control)
    : PeriodicRefinement(place, sizing, find_start(place, inputs), inputs, options, control) {}

PeriodicRefinement::PeriodicRefinement(const PeriodicWorld& place, const Sizing& sizing, Start start,
                                       PeriodicInputs inputs, const MeshOptions& options,
                                       const Control& control)
    : LabelledMesh(std::move(start.mesh), quality_bounds(options, !inputs.empty()), options, control),
      place_(place),
      sizing_(sizing, place.cell()),
      inputs_(std::move(inputs)),
      size_cap_(place.largest_size()) {
  const double finest = lattice::covering_radius(world().finest_level());  // sizes below it are refused
  size_floor_ = std::clamp(sizing_.lower_bound(place.cell()) / world().unit(), finest, size_cap_);
  if (lipschitz() == 0) constant_size_ = size_floor_;
  insert_inputs();
  label_vertices(start.level);
}

/// lfs <= c cap everywhere, and that is what inequality (1) allows the start's labels: they are as coarse as
/// those of vertices that the size step puts there.
void PeriodicRefinement::label_vertices(Level level) {
  const double lfs_bound = grading_guarantee(strategy(), !inputs_.empty()).c * size_cap_;
  for (VertexId v = 1; v < site_of_vertex_.size(); ++v)
    if (site_of_vertex_[v] != kNoVertex)
      add_notes(kNoLabel, kInfinity);
    else
      add_notes(inputs_.coarsest_label(mesh_.point(v), level), lfs_bound);
}

/// Some are there already.
void PeriodicRefinement::insert_inputs() {
  const std::vector<VertexId> vertices = mesh_.insert_all(inputs_.places());
  site_of_vertex_.resize(mesh_.vertex_count() + 1, kNoVertex);
  for (VertexId site = 0; site < vertices.size(); ++site) site_of_vertex_[vertices[site]] = site;
}

Box3 PeriodicRefinement::domain_box() {
  return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
}

double PeriodicRefinement::size_at(const Vec3& p) const {
  return std::min(size_cap_, sizing_.at(to_caller(p)) / world().unit());
}

double PeriodicRefinement::size_lower_bound(const Box3& box) const {
  if (constant_size_ > 0) return constant_size_;
  const auto in_caller = [this](const Vec3& p) { return world().to_caller(place_.in_frame(p)); };
  return std::min(size_cap_, sizing_.lower_bound({in_caller(box.lo), in_caller(box.hi)}) / world().unit());
}

}  // namespace unsliver::refine
