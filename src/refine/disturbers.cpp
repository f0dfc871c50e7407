#include "refine/disturbers.hpp"

#include <algorithm>

#include "refine/bulk_points.hpp"

namespace unsliver::refine {

namespace {

/// A tetrahedron's circumcentre is in the leaf that owns it, and its circumradius at most sqrt(5)/4 of the
/// leaf's side where the leaf has its centre, else sqrt(3)/2.
constexpr double kReachWithCenter = 0.56, kReach = 0.87;

}  // namespace

Disturbers::Disturbers(octree::Forest& forest, std::vector<Disturber> disturbers) {
  std::stable_sort(disturbers.begin(), disturbers.end(),
                   [](const Disturber& a, const Disturber& b) { return a.group < b.group; });
  for (auto first = disturbers.begin(); first != disturbers.end();) {
    const auto last =
        std::find_if(first, disturbers.end(), [&](const Disturber& d) { return d.group != first->group; });
    visit_group(forest, {first, last});
    first = last;
  }
  join_runs();
}

void Disturbers::visit_group(octree::Forest& forest, std::span<const Disturber> group) {
  const BulkPoints bulk(forest);
  Box3 box;
  for (const Disturber& d : group) box.extend(d.place);
  bulk.visit_leaves(
      box, kReach * bulk.root_side(),
      [&](const octree::Node& node, double distance_sq) {
        const double reach = kReach * lattice::power_of_two(node.exponent);
        return distance_sq <= reach * reach && (node.flags & octree::kOutside) == 0;
      },
      [&](const octree::Cell& leaf, octree::NodeId parent) {
        octree::Node& node = forest[leaf.node];
        const double share = (node.flags & octree::kHasCenter) != 0 ? kReachWithCenter : kReach,
                     reach = share * double(leaf.side());
        const auto first = std::uint32_t(places_.size());
        for (const Disturber& d : group)
          if (BulkPoints::dist_sq_between(leaf, {d.place, d.place}) <= reach * reach)
            places_.push_back(d.place);
        if (places_.size() == first) return;
        runs_.push_back({leaf.node, first, std::uint32_t(places_.size() - first)});
        node.flags |= octree::kDisturbed;
        forest[parent].flags |= octree::kDisturbed;
      });
}

/// One run a leaf, whatever the number of groups.
void Disturbers::join_runs() {
  std::stable_sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) { return a.leaf < b.leaf; });
  std::vector<Vec3> places;
  places.reserve(places_.size());
  std::vector<Run> joined;
  for (const Run& run : runs_) {
    if (joined.empty() || joined.back().leaf != run.leaf)
      joined.push_back({run.leaf, std::uint32_t(places.size()), 0});
    places.insert(places.end(), places_.begin() + run.first, places_.begin() + run.first + run.count);
    joined.back().count += run.count;
  }
  runs_ = std::move(joined);
  places_ = std::move(places);
}

std::span<const Vec3> Disturbers::at(octree::NodeId leaf) const {
  const auto run = std::lower_bound(runs_.begin(), runs_.end(), leaf,
                                    [](const Run& a, octree::NodeId n) { return a.leaf < n; });
  if (run == runs_.end() || run->leaf != leaf) return {};
  return {places_.data() + run->first, run->count};
}

}  // namespace unsliver::refine
