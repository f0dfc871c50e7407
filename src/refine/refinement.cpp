#include "refine/refinement.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <string_view>

#include "octree/fit.hpp"
#include "refine/criteria.hpp"
#include "refine/guarantees.hpp"
#include "refine/rounded.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

// The cube's corners are (+-2^46)^3 while the domain stays within 2^44 of the origin: a ball that meets the
// domain and holds no corner reaches no farther than 0.92 * 2^48, so every candidate stays inside the
// kernel's range of 2^48.
constexpr double kCubeCorner = 0x1p46;

// A lower bound of s below this share of the domain comes from places outside the domain, where s may be
// anything.
constexpr double kUnknownSize = 1e-12;

double fit_radius(const Domain& domain, const Sizing& sizing, Strategy strategy) {
  if (strategy == Strategy::kLiteral) return 0;
  if (strategy == Strategy::kOctree) return octree::fit_radius(domain, sizing);
  const double s = sizing.lower_bound(domain.bounds());
  const bool known = std::isfinite(s) && s > kUnknownSize * domain.bounds().diagonal();
  return known ? (1 - kSizeSlack) * s : 0;
}

double norm_inf(const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

Box3 box_of(const Domain& domain, std::span<const Vec3> inputs) {
  Box3 box = domain.bounds();
  for (const Vec3& p : inputs) box.extend(p);
  return box;
}

Inputs make_inputs(lattice::InputSites sites, std::span<const Vec3> inputs, const lattice::World& world) {
  std::vector<Vec3> places = lattice::to_world(sites, inputs, world);
  return Inputs(std::move(sites), std::move(places));
}

}  // namespace

Refinement::Refinement(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                       const MeshOptions& options, const Control& control)
    : Refinement(domain, sizing, inputs, lattice::find_sites(inputs, box_of(domain, inputs).longest_side()),
                 options, control) {}

Refinement::Refinement(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                       lattice::InputSites sites, const MeshOptions& options, const Control& control)
    : LabelledMesh(delaunay::Triangulation(), quality_bounds(options, !inputs.empty()), options, control),
      domain_(domain),
      sizing_(sizing),
      world_(lattice::World::fit(box_of(domain, inputs), fit_radius(domain, sizing, options.strategy),
                                 sites.max_step())),
      caller_bounds_(domain.bounds()),
      lipschitz_(sizing.lipschitz()),
      given_(inputs),
      inputs_(make_inputs(std::move(sites), inputs, world_)) {
  domain_box_ = {world_.to_world_real(caller_bounds_.lo), world_.to_world_real(caller_bounds_.hi)};
  size_cap_ = caller_bounds_.diagonal() / world_.unit();
  const double finest = lattice::covering_radius(world_.finest_level());  // sizes below it are refused
  size_floor_ = std::clamp(sizing.lower_bound(caller_bounds_) / world_.unit(), finest, size_cap_);
  if (lipschitz_ == 0) constant_size_ = size_floor_;
  start_from_cube();
  insert_inputs();
}

void Refinement::start_from_cube() {
  const double c = grading_guarantee(options_.strategy, !inputs_.empty()).c;
  const double farthest = kCubeCorner + std::max({norm_inf(domain_box_.lo), norm_inf(domain_box_.hi)});
  const double lfs_bound = farthest * std::sqrt(3.0) + c * size_cap_;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{i & 1 ? kCubeCorner : -kCubeCorner, i & 2 ? kCubeCorner : -kCubeCorner,
                      i & 4 ? kCubeCorner : -kCubeCorner};
    mesh_.insert(corner);
    add_notes(inputs_.coarsest_label(corner, lattice::kMinLevel), lfs_bound);
  }
}

void Refinement::insert_inputs() {
  const std::vector<Vec3>& places = inputs_.places();
  first_input_ = static_cast<VertexId>(mesh_.vertex_count() + 1);
  site_of_vertex_.resize(places.size());
  outside_.resize(places.size());
  const std::vector<VertexId> vertices = mesh_.insert_all(places);
  for (VertexId site = 0; site < places.size(); ++site) {
    site_of_vertex_[vertices[site] - first_input_] = site;
    add_notes(kNoLabel, std::numeric_limits<double>::infinity());
    if (!lies_outside(site)) continue;
    outside_[vertices[site] - first_input_] = true;
    ++outside_count_;
  }
}

/// By more than rounding: which side of a surface one of its own vertices is on is a toss-up, and some of its
/// tetrahedra meet the domain anyway.
bool Refinement::lies_outside(VertexId site) const {
  constexpr double kRounding = 2;  // units
  return !domain_.contains(given_[inputs_.sites().first_point[site]]) &&
         side_of_ball(inputs_.places()[site], kRounding) > 0;
}

bool Refinement::has_outside_input(TetId t) const {
  return outside_count_ > 0 && std::any_of(mesh_.tet(t).v, mesh_.tet(t).v + 4, [this](VertexId v) {
           return is_input(v) && outside_[v - first_input_];
         });
}

bool Refinement::has_wanted(TetId t) const {
  return any_wanted_ && std::any_of(mesh_.tet(t).v, mesh_.tet(t).v + 4,
                                    [this](VertexId v) { return (notes(v).proofs & kWanted) != 0; });
}

Tet Refinement::to_caller(const Tet& t) const {
  return {world_.to_caller(t[0]), world_.to_caller(t[1]), world_.to_caller(t[2]), world_.to_caller(t[3])};
}

double Refinement::clearance(VertexId v) {
  float& known = notes(v).clearance;
  if (std::isnan(known))
    known = rounded_towards_zero(domain_.clearance(world_.to_caller(mesh_.point(v))) / world_.unit() *
                                 (1 - 1e-12));
  return known;
}

/// A corner inside the domain tells, or the ball about a corner outside of it that holds the tetrahedron.
/// Input vertices are written less than a unit away from their places in the world.
bool Refinement::meets_domain(TetId t) {
  if (has_outside_input(t) || has_wanted(t)) return true;
  const auto& v = mesh_.tet(t).v;
  const double shift = inputs_.empty() ? 0 : 1;
  for (int i = 0; i < 4; ++i)
    if (clearance(v[i]) < -shift) return true;
  const Tet corners = mesh_.corners(t);
  for (int i = 0; i < 4; ++i) {
    const double radius = std::max(0.0, clearance(v[i]) - shift);
    double farthest_sq = 0;
    for (int j = 0; j < 4; ++j) farthest_sq = std::max(farthest_sq, dist_sq(corners[i], corners[j]));
    if (farthest_sq < radius * radius) return false;
  }
  ++stats_.domain_tests;
  return domain_.meets(
      {output_position(v[0]), output_position(v[1]), output_position(v[2]), output_position(v[3])});
}

double Refinement::size_at(const Vec3& p) const {
  return std::min(size_cap_, sizing_.at(world_.to_caller(p)) / world_.unit());
}

double Refinement::size_lower_bound(const Box3& box) const {
  if (constant_size_ > 0) return constant_size_;
  Box3 in_caller{world_.to_caller(box.lo), world_.to_caller(box.hi)};
  for (int axis = 0; axis < 3; ++axis) {
    in_caller.lo[axis] = std::max(in_caller.lo[axis], caller_bounds_.lo[axis]);
    in_caller.hi[axis] = std::min(in_caller.hi[axis], caller_bounds_.hi[axis]);
  }
  if (in_caller.empty()) return std::numeric_limits<double>::infinity();
  return std::min(size_cap_, sizing_.lower_bound(in_caller) / world_.unit());
}

std::optional<double> Refinement::varying_size_if_defined(const Vec3& p) const {
  Vec3 x = world_.to_caller(p);
  for (int axis = 0; axis < 3; ++axis) {  // a point of the domain's box may leave it by rounding
    const double inside = std::clamp(x[axis], caller_bounds_.lo[axis], caller_bounds_.hi[axis]);
    if (std::abs(x[axis] - inside) > 2 * world_.unit()) return std::nullopt;
    x[axis] = inside;
  }
  try {
    return std::min(size_cap_, sizing_.at(x) / world_.unit());
  } catch (const Error&) {
    return std::nullopt;  // outside the domain a size may be anything: where it matters size_at reports it
  }
}

}  // namespace unsliver::refine
