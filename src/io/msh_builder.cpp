#include "io/msh_builder.hpp"

#include <algorithm>
#include <functional>

#include "io/fail.hpp"
#include "io/polygons.hpp"

namespace unsliver::io {

void MshBuilder::add_node(std::int64_t tag, const Vec3& point) {
  tags_.push_back(tag);
  mesh_.points.push_back(point);
}

void MshBuilder::finish_nodes(const Scanner& place) {
  require_numberable(tags_.size(), place);
  by_tag_.clear();
  bool counts_up = true;
  for (std::size_t i = 0; i < tags_.size(); ++i) counts_up &= tags_[i] == static_cast<std::int64_t>(i) + 1;
  if (counts_up) return;
  for (std::size_t i = 0; i < tags_.size(); ++i) by_tag_.emplace_back(tags_[i], static_cast<VertexId>(i));
  std::sort(by_tag_.begin(), by_tag_.end());
  const auto twice = std::adjacent_find(by_tag_.begin(), by_tag_.end(),
                                        [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != by_tag_.end())
    place.fail_here(ErrorCode::kBadInput, fmt::format("node tag {} stands twice", twice->first));
}

VertexId MshBuilder::vertex(std::int64_t tag, const Scanner& place) const {
  if (by_tag_.empty()) return place.require_vertex(tag, 1, mesh_.points.size());
  const auto found = std::lower_bound(by_tag_.begin(), by_tag_.end(), std::pair{tag, VertexId{0}});
  if (found == by_tag_.end() || found->first != tag)
    place.fail_here(ErrorCode::kBadInput, fmt::format("there is no node with tag {}; tags are {} to {}", tag,
                                                      by_tag_.front().first, by_tag_.back().first));
  return found->second;
}

void MshBuilder::add_tet(const std::array<VertexId, 4>& tet, const MshLabels& labels, const Scanner& place) {
  mesh_.tets.push_back(tet);
  regions_.add(labels, place);
}

void MshBuilder::add_triangle(const std::array<VertexId, 3>& triangle, const MshLabels& labels,
                              const Scanner& place) {
  mesh_.triangles.push_back(triangle);
  triangle_labels_.add(labels, place);
}

TetMesh MshBuilder::take_mesh() {
  mesh_.regions = regions_.take();
  mesh_.triangle_labels = triangle_labels_.take();
  return std::move(mesh_);
}

void MshBuilder::Labels::add(const MshLabels& labels, const Scanner& place) {
  const std::int64_t value = labels.physical != 0 ? labels.physical : labels.elementary;
  if (value != static_cast<std::int32_t>(value))
    place.fail_here(ErrorCode::kBadInput, fmt::format("label {} does not fit 32 bits", value));
  has_physical_ |= labels.physical != 0;
  values_.push_back(static_cast<std::int32_t>(value));
}

std::vector<std::int32_t> MshBuilder::Labels::take() {
  const bool all_equal =
      std::adjacent_find(values_.begin(), values_.end(), std::not_equal_to<>()) == values_.end();
  if (!has_physical_ && all_equal) values_.clear();
  return std::move(values_);
}

}  // namespace unsliver::io
