#include "verify/stream_points.hpp"

#include "verify/lattice_check.hpp"
#include "verify/point_pages.hpp"
#include "verify/same_place.hpp"

namespace unsliver::verifier {
namespace {

/// Calls visit(number, point, level) for each vertex.
template <class Visit>
void for_each_point(const StreamContext& c, const Visit& visit) {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> levels;
  for (std::uint64_t first = 0; first < c.head.vertices; first += kChunk) {
    const auto count = static_cast<std::size_t>(std::min(kChunk, c.head.vertices - first));
    points.resize(count);
    levels.resize(count);
    c.source.read_points(first, points, levels);
    for (std::size_t i = 0; i < count; ++i) visit(first + i, points[i], levels[i]);
    c.pulse.beats(count);
  }
}

std::string text_of(std::uint64_t v, const Vec3& p) {
  return "vertex " + std::to_string(v) + " at " + full(p);
}

class PointCheck {
 public:
  explicit PointCheck(const StreamContext& context) : c_(context), axes_(grid_axes(context.head.frame)) {}

  void check(std::uint64_t v, const Vec3& p, int level) {
    if (!is_finite(p)) return find("coordinates", v, p, " is not finite");
    Row<std::int64_t> q;
    bool exact = true;
    for (int axis = 0; axis < 3; ++axis) {
      const GridPlace place = axes_[axis].place(p[axis]);
      if (!place.in_range) return find("coordinates", v, p, " is out of range of the frame's grid");
      exact &= place.exact;
      q[axis] = place.q;
    }
    if (!exact || level == 0 || !in_lattice(level, q))
      find("lattice", v, p, ", level " + std::to_string(level) + ", is not in the lattice of its level");
  }

 private:
  void find(const char* check, std::uint64_t v, const Vec3& p, const std::string& fault) const {
    c_.reporter.find(check, {static_cast<std::int64_t>(v)}, [&] { return text_of(v, p) + fault; });
  }

  const StreamContext& c_;
  std::array<GridAxis, 3> axes_;
};

struct HashedVertex {
  std::uint64_t hash;
  std::uint64_t vertex;
  friend auto operator<=>(const HashedVertex&, const HashedVertex&) = default;
};

Vec3 point_of(const StreamContext& c, std::uint64_t v) {
  Vec3 p;
  std::uint8_t level;
  c.source.read_points(v, {&p, 1}, {&level, 1});
  return p;
}

void compare_neighbors(const StreamContext& c, std::vector<HashedVertex>& part) {
  std::sort(part.begin(), part.end());
  for (std::size_t i = 1; i < part.size(); ++i) {
    if (part[i - 1].hash != part[i].hash) continue;
    const std::uint64_t a = part[i - 1].vertex, b = part[i].vertex;
    const Vec3 p = point_of(c, a);
    if (p == point_of(c, b))
      find_coincident(c.reporter, static_cast<std::int64_t>(a), static_cast<std::int64_t>(b), p);
  }
}

}  // namespace

bool check_stream_points(const StreamContext& c) {
  PointCheck check(c);
  for_each_point(c, [&](std::uint64_t v, const Vec3& p, std::uint8_t level) {
    check.check(v, p, level);
    c.report.bounds.extend(p);
  });
  const std::uint64_t wrong = c.reporter.count("lattice");
  c.reporter.line(
      "lattice: " + grouped(c.head.vertices) + " lattice vertices; " +
      (wrong == 0 ? "every one is in the lattice of its level (exact)" : grouped(wrong) + " defects"));
  return c.reporter.count("coordinates") == 0;
}

/// A part of the vertices at a time, those whose hashes agree modulo the number of parts.
void check_stream_coincident(const StreamContext& c) {
  constexpr std::uint64_t kMostInMemory = std::uint64_t{1} << 22;
  const std::uint64_t parts = c.head.vertices / kMostInMemory + 1;
  std::vector<HashedVertex> part;
  for (std::uint64_t number = 0; number < parts; ++number) {
    part.clear();
    for_each_point(c, [&](std::uint64_t v, const Vec3& p, std::uint8_t) {
      const std::uint64_t hash = hash_of(p);
      if (hash % parts == number) part.push_back({hash, v});
    });
    compare_neighbors(c, part);
  }
}

}  // namespace unsliver::verifier
