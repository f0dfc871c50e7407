#include "refine/surroundings.hpp"

#include "refine/point_lookup.hpp"

namespace unsliver::refine {

using lattice::Level;

namespace {

constexpr int kFinerLabel = 2;
/// Balls that hold what tetrahedra at an input vertex and at the vertices inserted around it conflict with,
/// in covering radii of the input vertex's leaf. Larger ones lift more in vain, smaller ones leave more to
/// be found one by one.
constexpr double kLiftedShare = 2.7;
/// Where these are looked for, as a rule.
constexpr double kShellShare = 4.2;

class Gathering {
 public:
  Gathering(octree::Forest& forest, const Inputs& inputs, Level finest)
      : forest_(forest), bulk_(forest), inputs_(inputs), finest_(finest) {}

  Surroundings run() {
    result_.sites.resize(inputs_.places().size());
    for (const auto& [leaf, site] : homes_by_leaf()) gather(leaf, site);
    for (const BulkVertex& v : found_)
      (inputs_.region_is_empty(v.place, finest_label(v.exponent, finest_)) ? result_.kept : result_.removed)
          .push_back(v);
    return std::move(result_);
  }

 private:
  struct Home {
    octree::Cell leaf;
    VertexId site;
  };

  /// In the order of their leaves, which is one along a curve through space.
  std::vector<Home> homes_by_leaf() const {
    std::vector<Home> homes;
    for (VertexId site = 0; site < inputs_.places().size(); ++site)
      homes.push_back({bulk_.leaf_at(inputs_.places()[site]).value(), site});
    std::stable_sort(homes.begin(), homes.end(),
                     [](const Home& a, const Home& b) { return a.leaf.node < b.leaf.node; });
    return homes;
  }

  void gather(const octree::Cell& home, VertexId number) {
    const bool has_center = (forest_[home.node].flags & octree::kHasCenter) != 0;
    const double covering = (has_center ? lattice::kQuarterSqrt5 : lattice::kHalfSqrt3) * double(home.side());
    Surroundings::Site& site = result_.sites[number];
    site = {kLiftedShare * covering, kShellShare * covering, result_.shells.size(), 0};
    result_.least_radius = std::min(result_.least_radius, site.radius);
    const Vec3& u = inputs_.places()[number];
    const auto reaches = [&](const octree::Node& node, double distance_sq) {
      if (distance_sq <= site.shell_radius * site.shell_radius) return true;
      const double reach = region_reach(node);
      return distance_sq <= reach * reach && (node.flags & octree::kOutside) == 0;
    };
    PointLookup in_shell;
    bulk_.visit_leaves({u, u}, std::max(site.shell_radius, lattice::kRho * bulk_.root_side()), reaches,
                       [&](const octree::Cell& leaf, octree::NodeId) { gather(leaf, number, in_shell); });
    site.shell_size = result_.shells.size() - site.shell_first;
  }

  void gather(const octree::Cell& leaf, VertexId number, PointLookup& in_shell) {
    const Surroundings::Site& site = result_.sites[number];
    const double radius_sq = site.radius * site.radius, shell_sq = site.shell_radius * site.shell_radius;
    const double fine = half_side(finest_label(leaf.exponent, finest_)),
                 coarse = half_side(2 * leaf.exponent);
    bool is_visited = false;
    bulk_.visit_vertices(leaf, [&](const Vec3& p) {
      const Vec3 d = p - inputs_.places()[number];
      const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}),
                   distance_sq = norm_sq(d);
      const bool is_near = distance_sq <= radius_sq || largest <= fine;
      if (is_near)
        add({p, leaf.exponent, number});
      else if (distance_sq <= shell_sq && in_shell.add(p, 0))
        result_.shells.push_back(p);
      is_visited = is_visited || is_near || largest <= coarse;
    });
    if (is_visited) forest_[leaf.node].flags |= octree::kVisited;
  }
  static double half_side(Level label) { return lattice::half_side(lattice::region_exponent(label)); }

  /// An input vertex in the region of a vertex of the leaf, or of a leaf below, with any label up to BCC_k is
  /// no farther.
  double region_reach(const octree::Node& node) const {
    const int exponent = (node.is_leaf() ? node.exponent : node.exponent - 1) - 1;
    const int least = lattice::region_exponent(finest_);
    return lattice::kRho * lattice::power_of_two(std::max(exponent, least)) * (1 + 1e-9);
  }

  void add(const BulkVertex& v) {
    const VertexId index = known_.find_or_add(v.place, VertexId(found_.size()));
    if (index == found_.size()) found_.push_back(v);
    found_[index].exponent = std::min(found_[index].exponent, v.exponent);
  }

  octree::Forest& forest_;
  BulkPoints bulk_;
  const Inputs& inputs_;
  Level finest_;
  std::vector<BulkVertex> found_;
  PointLookup known_;  ///< their indices
  Surroundings result_;
};

}  // namespace

Level finest_label(int leaf_exponent, Level finest_of_world) {
  return std::max(2 * (leaf_exponent - kFinerLabel) + 1, finest_of_world);
}

Surroundings gather_surroundings(octree::Forest& forest, const Inputs& inputs, Level finest_of_world) {
  return Gathering(forest, inputs, finest_of_world).run();
}

}  // namespace unsliver::refine
