#include "prove/closure_runs.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <random>
#include <set>

#include "prove/constants.hpp"
#include "prove/decimals.hpp"
#include "prove/watched.hpp"

namespace unsliver::prover {
namespace {

constexpr int kCoarsest = 6;              // SC_6 is there from the start
constexpr std::int64_t kReach = 3 << 6;   // in this cube around the origin
constexpr Fraction kC{1987, 1000};        // rounded down
constexpr Fraction kLargestSize{100, 1};  // c s <= 2^6 a

/// The lattice of a level: 2k = BCC_k, 2k + 1 = SC_k, k >= 0, integer points.
struct Level {
  int number;

  bool is_bcc() const { return (number & 1) == 0; }
  int exponent() const { return number >> 1; }
  /// All points are multiples of this.
  std::int64_t step() const { return std::int64_t{1} << ((number - 1) >> 1); }
  Fraction covering_sq() const {
    const std::int64_t unit = std::int64_t{1} << (2 * exponent());
    return is_bcc() ? Fraction{5 * unit, 16} : Fraction{3 * unit, 4};
  }
};

/// The coarsest level that holds p, not the origin.
Level canonical(const Point& p) {
  const int zeros = std::countr_zero(std::uint64_t(p.x | p.y | p.z));
  const bool all_odd = ((p.x & p.y & p.z) >> zeros & 1) != 0;
  return {2 * zeros + (all_odd ? 2 : 1)};
}

bool is_coarsest(const Point& p) { return p == Point{} || canonical(p).number > 2 * kCoarsest; }

/// See docs/CLOSURE.md.
std::vector<Point> parents(const Point& v) {
  const std::int64_t step = canonical(v).step();
  const auto odd = [&](std::int64_t c) { return c / step % 2 != 0; };
  const std::array<bool, 3> is_odd{odd(v.x), odd(v.y), odd(v.z)};
  const int odd_count = is_odd[0] + is_odd[1] + is_odd[2];
  std::vector<Point> result;
  for (const Point& d : points_around_origin(1, [](const Point&) { return true; })) {
    const std::array<bool, 3> moves{d.x != 0, d.y != 0, d.z != 0};
    const int move_count = moves[0] + moves[1] + moves[2];
    // Edges: the odd axis, or both others. Faces: the even axis, or both others. Centres: all three.
    const bool special = odd_count == 1;
    const bool along = move_count == 1, across = move_count == 2;
    int on_axis = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) on_axis += moves[axis] && is_odd[axis] == special;
    if (odd_count == 3 ? move_count == 3 : (along && on_axis == 1) || (across && on_axis == 0))
      result.push_back(v + step * d);
  }
  return result;
}

class Run {
 public:
  explicit Run(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 3; ++i) apexes_.push_back({random_point(kReach / 2), std::int64_t(1) + below(3)});
    constexpr std::int64_t kCell = 1 << kCoarsest;
    for (std::int64_t x = -kReach; x <= kReach; x += kCell)
      for (std::int64_t y = -kReach; y <= kReach; y += kCell)
        for (std::int64_t z = -kReach; z <= kReach; z += kCell) vertices_.insert({x, y, z});
  }

  void insert_for_size(int tries) {
    for (int i = 0; i < tries; ++i) {
      const Point& apex = apexes_[std::size_t(below(3))].at;
      const std::int64_t radius = std::int64_t{1} << below(8);
      const Point p = apex + random_point(radius);
      if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kReach - (1 << kCoarsest)) serve(p);
    }
  }

  void watch(Watched& inequality, Watched& neighbour, const Enclosure& grading) const {
    const Roots r;
    const Enclosure a = r.root3 + r.root2, b = r.root3 / Enclosure(2) + r.root2;
    for (const Point& v : vertices_) {
      const Level level = is_coarsest(v) ? Level{2 * kCoarsest + 1} : canonical(v);
      const Enclosure lfs_sq = square(lfs(v));
      const Enclosure unit = Fraction{1, std::int64_t{1} << (2 * level.exponent())};
      inequality.see(lfs_sq * unit, square(level.is_bcc() ? b : a));
      neighbour.see(lfs_sq / Enclosure(Fraction{nearest_sq(v), 1}), square(grading));
    }
  }

 private:
  struct Apex {
    Point at;
    std::int64_t size;
  };

  std::int64_t below(std::int64_t n) { return std::int64_t(random_() % std::uint64_t(n)); }
  Point random_point(std::int64_t radius) {
    const auto coordinate = [&] { return below(2 * radius + 1) - radius; };
    const std::int64_t x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }

  Enclosure lfs(const Point& p) const {
    Enclosure least = Enclosure(kC) * Enclosure(kLargestSize);
    for (const Apex& apex : apexes_) {
      const Enclosure here =
          Enclosure(kC) * Enclosure(int(apex.size)) + square_root(Fraction{dot(p - apex.at, p - apex.at), 1});
      if (here.lo() < least.lo()) least = here;
    }
    return least;
  }

  /// Of the other vertices.
  std::int64_t nearest_sq(const Point& p) const {
    std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
    for (const Point& v : vertices_)
      if (v != p) nearest = std::min(nearest, dot(v - p, v - p));
    return nearest;
  }

  /// The size step at p, and the closure.
  void serve(const Point& p) {
    const Enclosure size_sq = square(lfs(p) / Enclosure(kC));
    if (vertices_.count(p) != 0 || !size_sq.is_certainly_below(Fraction{nearest_sq(p), 1})) return;
    Level level{2 * kCoarsest + 1};
    while (level.number > 1 && !Enclosure(level.covering_sq()).is_certainly_below(size_sq)) --level.number;
    std::vector<Point> open{nearest_point(level, p)};
    while (!open.empty()) {
      const Point v = open.back();
      open.pop_back();
      if (!vertices_.insert(v).second || is_coarsest(v)) continue;
      for (const Point& parent : parents(v)) open.push_back(parent);
    }
  }

  /// A point of the level nearest to p.
  static Point nearest_point(const Level& level, const Point& p) {
    const std::int64_t step = level.is_bcc() ? 2 * level.step() : level.step();
    const auto rounded = [&](const Point& shift) {
      const auto nearest = [&](std::int64_t c, std::int64_t s) {
        return s + step * ((c - s + step / 2 + 1024 * step) / step - 1024);
      };
      return Point{nearest(p.x, shift.x), nearest(p.y, shift.y), nearest(p.z, shift.z)};
    };
    const Point corner = rounded({}), center = rounded({step / 2, step / 2, step / 2});
    return level.is_bcc() && dot(center - p, center - p) < dot(corner - p, corner - p) ? center : corner;
  }

  std::mt19937_64 random_;
  std::vector<Apex> apexes_;
  std::set<Point> vertices_;
};

}  // namespace

Finding prove_closure_runs(const ClosureRuns& claim) {
  const Enclosure grading = Fraction{claim.grading, 1000};
  Watched inequality, neighbour;
  for (int seed = 1; seed <= claim.runs; ++seed) {
    Run run{std::uint64_t(seed)};
    run.insert_for_size(1000);
    run.watch(inequality, neighbour, grading);
  }
  Finding finding{
      watched_part("(1): lfs(v) <= (sqrt 3 + sqrt 2) 2^k for SC_k, (sqrt 3/2 + sqrt 2) 2^k for BCC_k",
                   inequality),
      watched_part(fmt::format("nearest neighbours are at lfs/{} or more", thousandths_text(claim.grading)),
                   neighbour)};
  finding.back().found += fmt::format(": down to lfs/{:.3f}", neighbour.worst_share * middle(grading));
  return finding;
}

}  // namespace unsliver::prover
