#include "verify/holders.hpp"

namespace unsliver::verifier {

std::vector<Vec3> around(const Context& c, const Vec3& p) {
  const double half = c.options.cover_tolerance;
  std::vector<Vec3> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const double step : {-half, half}) {
      points.push_back(p);
      points.back()[axis] += step;
    }
  for (int i = 0; i < 8; ++i)
    points.push_back(p + half * Vec3{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  return points;
}

std::vector<VertexId> uncovered(const Context& c, const std::vector<Vec3>& points,
                                const std::vector<VertexId>& ids) {
  std::vector<bool> covered(points.size());
  visit_holders(c, points, ids, [&](VertexId id, std::uint32_t, bool) { covered[id] = true; });
  std::vector<VertexId> missed;
  for (const VertexId id : ids)
    if (!covered[id]) missed.push_back(id);
  return missed_by_more(c, points, missed);
}

std::vector<VertexId> missed_by_more(const Context& c, const std::vector<Vec3>& points,
                                     const std::vector<VertexId>& missed) {
  if (c.options.cover_tolerance == 0 || missed.empty()) return missed;
  std::vector<Vec3> all;
  std::vector<VertexId> ids;
  for (const VertexId id : missed)
    for (const Vec3& p : around(c, points[id])) {
      ids.push_back(static_cast<VertexId>(all.size()));
      all.push_back(p);
    }
  const std::size_t per_point = all.size() / missed.size();
  std::vector<bool> covered(missed.size());
  visit_holders(c, all, ids, [&](VertexId id, std::uint32_t, bool) { covered[id / per_point] = true; });
  std::vector<VertexId> left;
  for (std::size_t i = 0; i < missed.size(); ++i)
    if (!covered[i]) left.push_back(missed[i]);
  return left;
}

}  // namespace unsliver::verifier
