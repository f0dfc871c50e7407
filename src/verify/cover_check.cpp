#include <algorithm>

#include "verify/holders.hpp"
#include "verify/sampling_checks.hpp"

namespace unsliver::verifier {
namespace {

/// What is known about a point so far.
struct Cover {
  std::uint32_t holder = kNoVertex;  ///< a tetrahedron that holds it
  bool inside = false;               ///< strictly
};

/// Findings for points that are not finite; the ids of the others.
std::vector<VertexId> finite_points(const Context& c) {
  std::vector<VertexId> ids;
  for (std::size_t i = 0; i < c.options.must_cover.size(); ++i) {
    if (is_finite(c.options.must_cover[i])) {
      ids.push_back(static_cast<VertexId>(i));
    } else {
      c.reporter.find("cover", {static_cast<std::int64_t>(i)},
                      [&] { return "point " + std::to_string(i) + " is not finite"; });
    }
  }
  return ids;
}

void find_overlap(const Context& c, VertexId point, std::uint32_t first, std::uint32_t second) {
  c.reporter.find("overlap", {first, second}, [&] {
    return "point " + full(c.options.must_cover[point]) + " is strictly inside both " +
           describe_tet(c.mesh, first) + " and " + describe_tet(c.mesh, second);
  });
}

/// Is all that the tolerance may take for the point strictly inside the tetrahedron?
bool holds_deeply(const Context& c, std::uint32_t tet, VertexId point) {
  const Tet corners = c.mesh.corners(tet);
  const std::vector<Vec3> points = around(c, c.options.must_cover[point]);
  SignCounts counts;
  const bool deep = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return locate_in_tet(corners, p, counts) == Side::kInside;
  });
  add_counts(c, counts);
  return deep;
}

/// For a point strictly inside its holder and another tetrahedron: a finding if both hold it deeply. If only
/// the other one does, that is the holder from now on, or a third one would be compared with the wrong one.
bool find_deep_overlap(const Context& c, VertexId point, std::uint32_t& holder, std::uint32_t other) {
  if (!holds_deeply(c, other, point)) return false;
  if (!holds_deeply(c, holder, point)) {
    holder = other;
    return false;
  }
  find_overlap(c, point, holder, other);
  return true;
}

std::string verdict(const Context& c, std::uint64_t missed, std::uint64_t tolerated, std::uint64_t thin) {
  const std::string tolerance = full(c.options.cover_tolerance);
  std::string text =
      missed > 0 ? grouped(missed) + " NOT covered" : "all in the union of the tetrahedra (exact)";
  if (missed == 0 && tolerated > 0)
    text += ", " + grouped(tolerated) + " of them within " + tolerance + " of it";
  if (thin > 0) text += ", " + grouped(thin) + " overlaps no deeper than " + tolerance;
  return text;
}

}  // namespace

void check_cover(const Context& c) {
  const auto& points = c.options.must_cover;
  const std::vector<VertexId> ids = finite_points(c);
  std::vector<Cover> cover(points.size());
  std::uint64_t thin_overlaps = 0;
  visit_holders(c, points, ids, [&](VertexId id, std::uint32_t t, bool inside) {
    if (!cover[id].inside)
      cover[id] = {t, inside};
    else if (inside && !find_deep_overlap(c, id, cover[id].holder, t))
      ++thin_overlaps;
  });
  std::vector<VertexId> missed;
  for (const VertexId id : ids)
    if (cover[id].holder == kNoVertex) missed.push_back(id);
  const std::vector<VertexId> left = missed_by_more(c, points, missed);
  for (const VertexId id : left)
    c.reporter.find("cover", {id}, [&] {
      return "point " + std::to_string(id) + " at " + full(points[id]) + " is in no tetrahedron";
    });
  c.reporter.line(
      "cover: " + grouped(points.size()) + " points, " +
      verdict(c, points.size() - ids.size() + left.size(), missed.size() - left.size(), thin_overlaps));
}

}  // namespace unsliver::verifier
