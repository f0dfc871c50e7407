#include "refine/figure_8_octree.hpp"

#include <algorithm>

#include "exact/predicates.hpp"
#include "refine/bulk_points.hpp"
#include "refine/figure_8.hpp"
#include "refine/guarantees.hpp"
#include "refine/point_lookup.hpp"
#include "refine/queued.hpp"
#include "refine/size_enforcement.hpp"

namespace unsliver::refine {

namespace {

/// A tetrahedron's circumcentre is in the leaf that owns it, and its circumradius at most sqrt(5)/4 of the
/// leaf's side where the leaf has its centre, else sqrt(3)/2.
constexpr double kReachWithCenter = 0.56, kReach = 0.87;
/// Labels of the forest's vertices are SC_{k-2} or coarser, k the exponent of the smallest leaf there: the
/// smaller the region, the fewer vertices are removed and must be made up for, but the more slivers remain
/// between them and the input vertices. (SC_{k-1} takes twice, SC_{k-3} 1.6 times the vertices.)
constexpr int kFinerLabel = 2;
/// The certificates of inequality (1): any function will do for lfs that varies no faster than distance does.
/// Here it is, next to lfs_i, the least of kBulkShare sides of a leaf plus the distance to it; SC_{k-2} may
/// use 88.18 / 4 of them.
constexpr double kBulkShare = 10;

class InputGuest final : public octree::Guest {
 public:
  explicit InputGuest(Refinement& r) : r_(r), search_(r) {}

  void on_forest(octree::Forest& forest) override {
    bulk_.emplace(forest);
    find_removed();
    for (VertexId v = 1; v <= r_.mesh().vertex_count(); ++v) is_guest_.push_back(r_.is_input(v));
    refine();
    choose();
    set_apart(forest);
  }

  bool keeps(const Tet& t) const override {
    return std::none_of(t.begin(), t.end(), [this](const Vec3& p) { return is_removed(p); }) &&
           !holds(*guest_tree_, circumsphere(t), [&](const Vec3& q) { return conflicts(t, q); });
  }

  VertexId vertex_count() const override { return first_bulk_; }

  std::uint8_t on_vertex(VertexId number, const Vec3& p, const octree::Cell& owner,
                         const octree::Node& leaf) override {
    if (const VertexId v = lifted_.find(p); v != kNoVertex) {
      number_[v] = number;
      return static_cast<std::uint8_t>(r_.label(v));
    }
    const Level coarse = std::min(lattice::canonical_level(p), 2 * owner.exponent + 1);
    const bool fits = (leaf.flags & octree::kRemote) != 0 || r_.inputs().region_is_empty(p, coarse);
    return static_cast<std::uint8_t>(fits ? coarse : label_of(p, *bulk_->exponent_at(p)));
  }

  std::uint64_t tet_count() const override { return kept_.size(); }
  std::uint64_t bytes() const override { return r_.mesh().bytes(); }

  void complete(TetMesh& mesh) override {
    for (VertexId v = 1; v < number_.size(); ++v) {
      if (number_[v] == kMissing) {
        number_[v] = static_cast<VertexId>(mesh.points.size());
        mesh.points.emplace_back();
        mesh.levels.emplace_back();
      } else if (number_[v] == kNoVertex || !is_guest_[v - 1]) {
        continue;
      }
      mesh.points[number_[v]] = r_.output_position(v);
      mesh.levels[number_[v]] = static_cast<std::uint8_t>(r_.label(v));
    }
    for (const TetId t : kept_) {
      const auto& v = r_.mesh().tet(t).v;
      mesh.tets.push_back({number_[v[0]], number_[v[1]], number_[v[2]], number_[v[3]]});
    }
    const auto& sources = r_.inputs().sites().first_point;
    mesh.point_source.assign(sources.begin(), sources.end());
    mesh.point_source.resize(mesh.points.size(), -1);
  }

 private:
  static constexpr VertexId kMissing = kNoVertex - 1;  ///< in use, number not known yet

  /// --- The forest's vertices

  bool is_removed(const Vec3& p) const {
    return std::binary_search(removed_.begin(), removed_.end(), p, lex_less);
  }
  Level finest_label(int leaf_exponent) const {
    return std::max(2 * (leaf_exponent - kFinerLabel) + 1, r_.world().finest_level());
  }
  Level label_of(const Vec3& p, int leaf_exponent) const {
    return r_.inputs().coarsest_label(p, finest_label(leaf_exponent));
  }

  /// "By construction no input point is in the forbidden region": points where that fails with the finest
  /// label are left out.
  void find_removed() {
    constexpr double kShare = 0.5;  // sqrt(3) times the region's half side, sigma / 4 of the leaf's side
    for (const Vec3& u : r_.inputs().places())
      bulk_->visit_near(u, kShare, [this](const Vec3& p) {
        if (!r_.inputs().region_is_empty(p, finest_label(*bulk_->exponent_at(p)))) removed_.push_back(p);
      });
    std::sort(removed_.begin(), removed_.end(), lex_less);
    removed_.erase(std::unique(removed_.begin(), removed_.end()), removed_.end());
    removed_tree_.emplace(removed_);
  }

  /// --- The kernel

  void refine() {
    for (TetId t = 0; t < r_.mesh().slot_count(); ++t) pending_.push_back(queued(r_, t));
    settle();
    for (const Vec3& removed : removed_) complete_star(removed);
    while (const auto next = queue_.pop()) {
      if (!still_there(r_, *next)) continue;
      enforce_quality(r_, next->slot);
      note_insertion(true);
      settle();
    }
  }

  /// Tetrahedra without guests that conflict with a removed point are right, but some may be missing: where
  /// the kernel lacks a vertex, it has others in their place that conflict with nothing. None is missing once
  /// all vertices of the forest that the removed point would be joined to are there. Insertions to come
  /// join it to no others.
  void complete_star(const Vec3& removed) {
    while (const auto p = missing_neighbour(removed)) {
      lift(*p, r_.mesh().locate(removed));
      settle();
    }
  }

  /// A vertex of the forest, not lifted, in conflict with a tetrahedron of the star that a removed point
  /// would have in the kernel.
  std::optional<Vec3> missing_neighbour(const Vec3& removed) {
    const TetId t = r_.mesh().locate(removed);
    if (r_.mesh().corner_at(t, removed) != kNoVertex) return std::nullopt;
    std::optional<Vec3> missing;
    r_.mesh().carve(removed, t);
    for (const auto& facet : r_.mesh().boundary()) {
      if (missing) break;
      if (facet.v[2] == delaunay::kInfinite) continue;
      missing = bulk_in_conflict(Tet{r_.mesh().point(facet.v[0]), r_.mesh().point(facet.v[1]),
                                     r_.mesh().point(facet.v[2]), removed});
    }
    r_.mesh().abandon();
    return missing;
  }

  void note_insertion(bool guest) {
    is_guest_.push_back(guest);
    for (const TetId made : r_.created()) pending_.push_back(queued(r_, made));
  }

  void settle() {
    while (!pending_.empty()) {
      const Queued next = pending_.back();
      pending_.pop_back();
      if (still_there(r_, next)) settle(next);
    }
  }

  void settle(const Queued& entry) {
    const TetId t = entry.slot;
    if (!concerns_guests(t)) return;
    if (const auto p = bulk_in_conflict(r_.mesh().corners(t))) return lift(*p, t);
    if (!r_.meets_domain(t)) return;
    if (const auto ball = search_.find(t, 0)) {
      pending_.push_back(entry);  // it may survive
      return enforce_size(*ball, t);
    }
    if (const auto [is_bad, radius_sq] = r_.judge(t); is_bad) queue_.push(entry, radius_sq);
  }

  bool concerns_guests(TetId t) const {
    for (const VertexId v : r_.mesh().tet(t).v)
      if (is_guest_[v - 1]) return true;
    const Tet corners = r_.mesh().corners(t);
    return !removed_.empty() &&
           holds(*removed_tree_, circumsphere(corners), [&](const Vec3& p) { return conflicts(corners, p); });
  }

  static bool conflicts(const Tet& t, const Vec3& p) {
    exact::StageCounts counts;
    return std::find(t.begin(), t.end(), p) == t.end() &&
           exact::insphere_perturbed(t[0], t[1], t[2], t[3], p, counts) > 0;
  }

  /// Points farther than this from the centre are not in conflict, ties included: the centre is rounded.
  static double reach_of(const geom::Sphere& sphere) { return std::sqrt(sphere.radius_sq) * (1 + 1e-8) + 1; }

  /// Does any point of the tree that may lie in the sphere pass the test?
  template <class Test>
  static bool holds(const geom::PointTree& tree, const geom::Sphere& sphere, const Test& test) {
    const double reach = reach_of(sphere);
    bool found = false;
    tree.visit_cube(sphere.center, reach, [&](VertexId, const Vec3& p) {
      return found = dist_sq(p, sphere.center) <= reach * reach && test(p);
    });
    return found;
  }

  std::optional<Vec3> bulk_in_conflict(const Tet& t) const {
    const geom::Sphere sphere = circumsphere(t);
    const double reach = reach_of(sphere);
    std::optional<Vec3> found;
    bulk_->visit_ball(sphere.center, reach, [&](const Vec3& p) {
      if (dist_sq(p, sphere.center) > reach * reach || !conflicts(t, p) || is_removed(p)) return false;
      found = p;
      return true;
    });
    return found;
  }

  void lift(const Vec3& p, TetId near) {
    const int exponent = *bulk_->exponent_at(p);
    r_.insert(p, label_of(p, exponent), kBulkShare * lattice::power_of_two(exponent), near);
    note_insertion(false);
  }

  /// What the search found empty may hold vertices of the forest that were not lifted yet.
  void enforce_size(const EmptyBall& ball, TetId t) {
    std::optional<Vec3> found;
    const double radius = (1 - kSizeSlack) * ball.size;
    bulk_->visit_ball(ball.center, radius, [&](const Vec3& p) {
      if (dist_sq(p, ball.center) > radius * radius || is_lifted(p, t) || is_removed(p)) return false;
      found = p;
      return true;
    });
    if (!found)
      if (const Vec3 w = search_.point_for(ball).w; bulk_->exponent_at(w) && !is_removed(w)) found = w;
    if (found) return lift(*found, t);
    insert_for_size(r_, search_, ball, t);  // throws where the point is there already
    note_insertion(true);
  }
  bool is_lifted(const Vec3& p, TetId near) const {
    return r_.mesh().corner_at(r_.mesh().locate(p, near), p) != kNoVertex;
  }

  /// --- The mesh

  /// Which tetrahedra of the kernel are kept, and numbers for their vertices.
  void choose() {
    number_.assign(r_.mesh().vertex_count() + 1, kNoVertex);
    for (TetId t = 0; t < r_.mesh().slot_count(); ++t) {
      if (!r_.mesh().is_finite(t) || !concerns_guests(t) || !r_.meets_domain(t)) continue;
      kept_.push_back(t);
      for (const VertexId v : r_.mesh().tet(t).v) number_[v] = kMissing;
    }
    first_bulk_ = static_cast<VertexId>(r_.inputs().places().size());
    std::vector<Vec3> guests;
    for (VertexId v = 1; v < number_.size(); ++v) {
      if (is_guest_[v - 1])
        guests.push_back(r_.mesh().point(v));
      else if (number_[v] == kMissing)
        lifted_.add(r_.mesh().point(v), v);
      if (r_.is_input(v))
        number_[v] = r_.site(v);
      else if (is_guest_[v - 1] && number_[v] == kMissing)
        number_[v] = first_bulk_++;
    }
    lifted_.finish();
    guest_tree_.emplace(guests);
    guests_ = std::move(guests);
  }

  /// Leaves that may own tetrahedra in conflict with a guest, or with a removed corner.
  void set_apart(octree::Forest& forest) const {
    constexpr auto kNotInside = static_cast<std::uint8_t>(~(octree::kInside | octree::kDeep));
    constexpr auto kNotUniform = static_cast<std::uint8_t>(~octree::kUniform);
    for (const auto* points : {&guests_, &removed_})
      for (const Vec3& q : *points)
        bulk_->visit_leaves_near(q, kReach, [&](const octree::Cell& leaf, octree::NodeId parent) {
          octree::Node& node = forest[leaf.node];
          if ((node.flags & octree::kHasCenter) != 0 && !BulkPoints::is_near(leaf, q, kReachWithCenter))
            return;
          node.flags &= kNotInside;
          forest[parent].flags &= kNotUniform;
        });
  }

  Refinement& r_;
  EmptyBallSearch search_;
  std::optional<BulkPoints> bulk_;
  std::vector<Vec3> removed_, guests_;
  std::optional<geom::PointTree> removed_tree_, guest_tree_;
  std::vector<bool> is_guest_;  ///< by vertex - 1: not one of the forest's
  std::vector<Queued> pending_;
  RadiusQueue queue_;
  std::vector<TetId> kept_;
  std::vector<VertexId> number_;  ///< in the mesh, by the kernel's vertex
  PointLookup lifted_;
  VertexId first_bulk_ = 0;
};

}  // namespace

octree::OctreeResult figure_8_on_octree(Refinement& r, const Domain& domain, const Sizing& sizing,
                                        const octree::OctreeOptions& options, const Control& control) {
  InputGuest guest(r);
  const geom::PointTree places(r.inputs().places());
  return octree::mesh_domain_octree(domain, sizing, r.world(), options, control, {places, guest});
}

}  // namespace unsliver::refine
