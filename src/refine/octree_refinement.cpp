#include "refine/octree_refinement.hpp"

#include <algorithm>

#include "exact/predicates.hpp"
#include "refine/figure_8.hpp"
#include "refine/guarantees.hpp"

namespace unsliver::refine {

namespace {

/// The certificates of inequality (1): any function will do for lfs that varies no faster than distance does.
/// Here it is, next to lfs_i, the least of kBulkShare sides of a leaf plus the distance to it; SC_{k-2} may
/// use 88.18 / 4 of them.
constexpr double kBulkShare = 10;

bool in_conflict(const Tet& t, const Vec3& p) {
  exact::StageCounts counts;
  return std::find(t.begin(), t.end(), p) == t.end() &&
         exact::insphere_perturbed(t[0], t[1], t[2], t[3], p, counts) > 0;
}

/// Points farther than this from the centre are not in conflict, ties included: the centre is rounded.
double reach_of(const geom::Sphere& sphere) { return std::sqrt(sphere.radius_sq) * (1 + 1e-8) + 1; }

}  // namespace

OctreeRefinement::OctreeRefinement(Refinement& refinement, octree::Forest& forest)
    : r_(refinement),
      forest_(forest),
      bulk_(forest),
      search_(refinement),
      surroundings_(gather_surroundings(forest, r_.inputs(), r_.world().finest_level())) {
  notes_.push_back({kNoVertex, false});  // the vertex at infinity
  for (VertexId v = 1; v <= r_.mesh().vertex_count(); ++v)
    notes_.push_back({r_.is_input(v) ? r_.site(v) : kNoVertex, r_.is_input(v)});
}

void OctreeRefinement::lift_surroundings() {
  for (const BulkVertex& v : surroundings_.removed) known_.find_or_add(v.place, kRemoved);
  for (const BulkVertex& v : surroundings_.kept) insert_lifted(v, r_.created().front());
}

void OctreeRefinement::refine() {
  push_all();
  settle();
  for (const BulkVertex& removed : surroundings_.removed) complete_star(removed);
  do {
    enforce_quality_everywhere();
    choose();
  } while (adopt_dropped_proofs());
}

std::uint64_t OctreeRefinement::bytes() const {
  return r_.mesh().bytes() + known_.bytes() + notes_.capacity() * sizeof(Note) +
         (surroundings_.kept.capacity() + surroundings_.removed.capacity()) * sizeof(BulkVertex) +
         surroundings_.shells.capacity() * sizeof(Vec3);
}

/// --- Vertices of the forest

void OctreeRefinement::insert_lifted(const BulkVertex& v, TetId near) {
  r_.insert(v.place, label_of(v), kBulkShare * lattice::power_of_two(v.exponent), near);
  known_.find_or_add(v.place, VertexId(r_.mesh().vertex_count()));
  notes_.push_back({v.home, false});
}

/// The coarsest whose region is empty: where its home is not in it, as a rule nobody is.
Level OctreeRefinement::label_of(const BulkVertex& v) const {
  const Level least = finest_label(v.exponent, r_.world().finest_level());
  Level label = std::max(least, lattice::canonical_level(v.place));
  const auto is_home_in_region = [&] {
    return v.home != kNoVertex && lattice::in_forbidden_region(v.place, label, r_.inputs().places()[v.home]);
  };
  while (label > least && (is_home_in_region() || !r_.inputs().region_is_empty(v.place, label))) --label;
  return label;
}

/// What was not lifted is farther from all input vertices than what was.
Level OctreeRefinement::label_of(const Vec3& p, Level coarse) const {
  const double reach = lattice::kRho * lattice::power_of_two(lattice::region_exponent(coarse));
  if (reach < surroundings_.least_radius || r_.inputs().region_is_empty(p, coarse)) return coarse;
  return label_of({p, bulk_.exponent_at(p).value(), kNoVertex});
}

/// One that was found to be missing.
void OctreeRefinement::lift(const Vec3& p, TetId near) {
  const auto exponent =
      bulk_.exponent_at(p, [&](const octree::Cell& leaf) { forest_[leaf.node].flags |= octree::kVisited; });
  insert_lifted({p, exponent.value(), home_of(near)}, near);
  for (const TetId made : r_.created())
    if (has_guest(made)) push(made);
}

/// The vertex of B, not lifted, that is nearest to the centre of those in the ball that `accept` accepts.
template <class Accept>
std::optional<Vec3> OctreeRefinement::nearest_missing(const Vec3& center, double radius, VertexId home,
                                                      const Accept& accept) const {
  const auto is_accepted = [&](const Vec3& p) { return is_missing(p) && accept(p); };
  if (home == kNoVertex) return bulk_.nearest_if(center, radius, is_accepted);
  const Surroundings::Site& site = surroundings_.sites[home];
  const double reach = dist(center, r_.inputs().places()[home]) + radius;
  if (reach <= site.radius) return std::nullopt;
  if (reach > site.shell_radius) return bulk_.nearest_if(center, radius, is_accepted);
  Nearest nearest(center, radius);
  for (const Vec3& p : surroundings_.shell(site)) nearest.consider(p, is_accepted);
  return nearest.found();
}

std::optional<Vec3> OctreeRefinement::missing_in_conflict(const Tet& t, VertexId home) const {
  const geom::Sphere sphere = circumsphere(t);
  return nearest_missing(sphere.center, reach_of(sphere), home,
                         [&](const Vec3& p) { return in_conflict(t, p); });
}

/// --- Guests

bool OctreeRefinement::has_guest(TetId t) const {
  const auto& v = r_.mesh().tet(t).v;
  return notes_[v[0]].is_guest || notes_[v[1]].is_guest || notes_[v[2]].is_guest || notes_[v[3]].is_guest;
}

/// Guests know best what is around.
VertexId OctreeRefinement::home_of(TetId t) const {
  VertexId home = kNoVertex;
  for (const VertexId v : r_.mesh().tet(t).v) {
    if (notes_[v].is_guest) return notes_[v].home;
    home = std::min(home, notes_[v].home);
  }
  return home;
}

void OctreeRefinement::push_all() {
  for (TetId t = 0; t < r_.mesh().slot_count(); ++t) {
    r_.mesh().prefetch(t);
    if (r_.mesh().is_finite(t) && has_guest(t)) push(t);
  }
}

void OctreeRefinement::note_guest(VertexId home) {
  notes_.push_back({home, true});
  for (const TetId made : r_.created()) push(made);
}

/// Bad tetrahedra come last: most are gone by then, and no vertex was lifted for them.
void OctreeRefinement::enforce_quality_everywhere() {
  while (const auto next = queue_.pop()) {
    const TetId t = next->slot;
    if (!still_there(r_, *next)) continue;
    const VertexId home = home_of(t);
    if (const auto p = missing_in_conflict(r_.mesh().corners(t), home)) {
      lift(*p, t);
    } else if (r_.meets_domain(t)) {
      enforce_quality(r_, t);
      note_guest(home);
    }
    settle();
  }
}

/// Tetrahedra with a guest, or in conflict with a removed vertex: the bad ones are queued, the others made
/// right.
void OctreeRefinement::settle() {
  while (!fresh_.empty() || !pending_.empty()) {
    judge_fresh();
    if (pending_.empty()) continue;
    const Queued next = pending_.back();
    pending_.pop_back();
    if (still_there(r_, next)) settle(next);
  }
}

/// Judged together, which takes half the time.
void OctreeRefinement::judge_fresh() {
  std::erase_if(fresh_, [this](const Queued& entry) { return !still_there(r_, entry); });
  corners_.clear();
  for (const Queued& entry : fresh_) corners_.push_back(r_.mesh().corners(entry.slot));
  judgements_.resize(corners_.size());
  r_.judge(corners_, judgements_);
  for (std::size_t i = 0; i < fresh_.size(); ++i)
    if (judgements_[i].is_bad)
      queue_.push(fresh_[i], judgements_[i].radius_sq);
    else
      pending_.push_back(fresh_[i]);
  fresh_.clear();
}

void OctreeRefinement::settle(const Queued& entry) {
  const TetId t = entry.slot;
  if (const auto p = missing_in_conflict(r_.mesh().corners(t), home_of(t))) return lift(*p, t);
  if (!r_.meets_domain(t)) return;
  if (const auto ball = search_.find(t, 0)) {
    pending_.push_back(entry);  // it may survive
    enforce_size(*ball, t);
  }
}

/// What the search found empty may hold vertices of the forest that were not lifted yet.
void OctreeRefinement::enforce_size(const EmptyBall& ball, TetId t) {
  const auto missing = nearest_missing(ball.center, (1 - kSizeSlack) * ball.size, home_of(t),
                                       [](const Vec3&) { return true; });
  if (missing) return lift(*missing, t);
  if (const Vec3 w = point_for(r_, ball).w; is_missing(w) && bulk_.exponent_at(w)) return lift(w, t);
  const VertexId home = home_of(t);
  insert_for_size(r_, ball, t);  // throws where the point is there already
  note_guest(home);
}

/// --- Removed vertices

/// Tetrahedra without guests that conflict with a removed point are right, but some may be missing: where the
/// kernel lacks a vertex, it has others in their place that conflict with nothing. None is missing once all
/// vertices of the forest that the removed point would be joined to are there. Insertions to come join it to
/// no others.
void OctreeRefinement::complete_star(const BulkVertex& removed) {
  const Vec3& p = removed.place;
  std::vector<TetId> conflicts;
  for (std::optional<Vec3> missing = p; missing;) {
    const TetId t = r_.mesh().locate(p);
    if (r_.mesh().corner_at(t, p) != kNoVertex) return;
    r_.mesh().carve(p, t);
    missing = missing_in_star(removed);
    conflicts.assign(r_.mesh().cavity().begin(), r_.mesh().cavity().end());
    r_.mesh().abandon();
    if (missing) lift(*missing, t);
  }
  for (const TetId t : conflicts)
    if (!has_guest(t)) push(t);
  settle();
}

/// Between carve and abandon: in conflict with a tetrahedron that the vertex would have in the kernel.
std::optional<Vec3> OctreeRefinement::missing_in_star(const BulkVertex& removed) const {
  for (const auto& facet : r_.mesh().boundary()) {
    if (facet.v[2] == delaunay::kInfinite) continue;
    const Tet t{r_.mesh().point(facet.v[0]), r_.mesh().point(facet.v[1]), r_.mesh().point(facet.v[2]),
                removed.place};
    if (const auto missing = missing_in_conflict(t, removed.home)) return missing;
  }
  return std::nullopt;
}

/// --- The result

void OctreeRefinement::choose() {
  kept_.clear();
  for (TetId t = 0; t < r_.mesh().slot_count(); ++t)
    if (r_.mesh().is_finite(t) && has_guest(t) && r_.meets_domain(t)) kept_.push_back(t);
  for (const BulkVertex& removed : surroundings_.removed) {
    const TetId at = r_.mesh().locate(removed.place);
    if (r_.mesh().corner_at(at, removed.place) != kNoVertex) continue;
    r_.mesh().carve(removed.place, at);
    for (const TetId t : r_.mesh().cavity())
      if (r_.mesh().is_finite(t) && !has_guest(t) && r_.meets_domain(t)) kept_.push_back(t);
    r_.mesh().abandon();
  }
  std::sort(kept_.begin(), kept_.end());
  kept_.erase(std::unique(kept_.begin(), kept_.end()), kept_.end());
}

/// See want_dropped_proofs. A vertex of the forest is a guest from now on, so that all its tetrahedra come
/// from the kernel. One inside the domain stays what it is: some tetrahedron at it is kept, whoever gives it.
bool OctreeRefinement::adopt_dropped_proofs() {
  std::vector<bool> is_used(r_.mesh().vertex_count() + 1);
  for (const TetId t : kept_)
    for (const VertexId v : r_.mesh().tet(t).v) is_used[v] = true;
  bool any = false;
  for (VertexId v = 1; v < is_used.size(); ++v) {
    if (!r_.is_relied_on(v) || is_used[v] || r_.is_input(v)) continue;
    if (!is_guest(v) && r_.clearance(v) < 0) continue;
    r_.want(v);
    notes_[v].is_guest = any = true;
  }
  if (!any) return false;
  push_all();
  settle();
  return true;
}

}  // namespace unsliver::refine
