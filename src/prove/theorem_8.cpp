// The combinatorial part of Theorem 8. A subdivision into convex cells is the Delaunay one if across each
// facet the vertices of one cell are strictly outside the sphere of the other (the lifted function is then
// convex). For pyramids of p that is a statement about p and a sphere of lattice points: |p - c|^2 is least
// and greatest over a box at known places, so that it is decided exactly for all p at once.
#include "prove/theorem_8.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace unsliver::prover {
namespace {

std::vector<Point> cube_corners(const Point& lower) {
  std::vector<Point> corners;
  for (int c = 0; c < 8; ++c) corners.push_back(lower + Point{c & 1, c >> 1 & 1, c >> 2});
  return corners;
}

Vector<Surd> quarters(const Point& p) { return vector<Surd>(p, 4); }

std::int64_t det(const Point& a, const Point& b, const Point& c, const Point& d) {
  return dot(b - a, cross(c - a, d - a));
}

/// The sides of a base, a triangle or a rectangle: pairs that are no diagonal.
std::vector<std::pair<Point, Point>> edges_of(const std::vector<Point>& base) {
  std::int64_t diagonal_sq = 0;
  const auto length_sq = [](const Point& a, const Point& b) { return dot(b - a, b - a); };
  if (base.size() == 4)
    for (const Point& p : base) diagonal_sq = std::max(diagonal_sq, length_sq(base[0], p));
  std::vector<std::pair<Point, Point>> edges;
  for (std::size_t i = 0; i < base.size(); ++i)
    for (std::size_t j = i + 1; j < base.size(); ++j)
      if (length_sq(base[i], base[j]) != diagonal_sq) edges.emplace_back(base[i], base[j]);
  return edges;
}

/// Decides for all p of a case.
class Decision {
 public:
  Decision(const Hole& hole, const Surd& four_sigma) : hole_(hole), region_(hole.region(four_sigma)) {}

  /// All p are strictly outside the spheres of the cut cubes and of the cubes around the box; at p = sigma,
  /// which is not in I, they may be on them.
  bool is_outside_lattice_spheres() const {
    for (int x = -1; x <= hole_.side(0); ++x)
      for (int y = -1; y <= hole_.side(1); ++y)
        for (int z = -1; z <= hole_.side(2); ++z)
          if (is_cell(Point{x, y, z}) && !is_outside_sphere_of_cube(Point{x, y, z})) return false;
    return true;
  }

  /// The bases are a closed surface, each edge in two of them, with p strictly on that side of each where the
  /// others are.
  bool bases_enclose_p() const {
    std::map<std::pair<Point, Point>, int> edges;
    for (const auto& base : hole_.bases()) {
      for (const auto& edge : edges_of(base)) ++edges[edge];
      const int side = side_of(base);
      if (side == 0) return false;
      for (const Point& p : hole_.face_vertices())
        if (side * det(base[0], base[1], base[2], p) < 0) return false;
    }
    return std::all_of(edges.begin(), edges.end(), [](const auto& entry) { return entry.second == 2; });
  }

  /// Across each edge of the hull the pyramids of p are strictly locally Delaunay.
  bool pyramids_are_delaunay() const {
    std::map<std::pair<Point, Point>, std::vector<std::size_t>> at_edge;
    for (std::size_t i = 0; i < hole_.bases().size(); ++i)
      for (const auto& edge : edges_of(hole_.bases()[i])) at_edge[edge].push_back(i);
    for (const auto& [edge, bases] : at_edge)
      for (const std::size_t i : bases)
        for (const std::size_t j : bases)
          if (i != j && !is_locally_delaunay(hole_.bases()[i], hole_.bases()[j])) return false;
    return true;
  }

  /// Six times the volumes of hull and cut cubes make up the box.
  bool cells_fill_the_box() const {
    std::int64_t twice_volumes =
        0;  // pyramids with their apex at half-integers: 12 V, with doubled coordinates 8 * 6 V
    const Point middle{hole_.side(0), hole_.side(1), hole_.side(2)};
    for (const auto& base : hole_.bases()) {
      const std::int64_t triangle = std::abs(det(2 * base[0], 2 * base[1], 2 * base[2], middle));
      twice_volumes += base.size() == 4 ? 2 * triangle : triangle;
    }
    for (const auto& cell : hole_.cut_cubes()) twice_volumes += 8 * (cell.size() == 7 ? 5 : 3);
    return twice_volumes == std::int64_t{8} * 6 * hole_.side(0) * hole_.side(1) * hole_.side(2);
  }

 private:
  bool is_cell(const Point& cube) const {
    const auto inside = [&](std::int64_t c, int axis) { return c >= 0 && c < hole_.side(axis); };
    if (!inside(cube.x, 0) || !inside(cube.y, 1) || !inside(cube.z, 2)) return true;
    return std::any_of(hole_.cut_cubes().begin(), hole_.cut_cubes().end(),
                       [&](const std::vector<Point>& cell) {
                         return std::all_of(cell.begin(), cell.end(), [&](const Point& p) {
                           const Point d = p - cube;
                           return std::min({d.x, d.y, d.z}) >= 0 && std::max({d.x, d.y, d.z}) <= 1;
                         });
                       });
  }

  bool is_outside_sphere_of_cube(const Point& cube) const {
    const Vector<Surd> center = quarters(cube) + Vector<Surd>{2, 2, 2};
    Surd distance_sq = 0;
    bool at_open_end = false;
    const auto add = [&](const Surd& c, int axis) {
      const Range& range = region_[std::size_t(axis)];
      const Surd gap = c < range.lo ? range.lo - c : range.hi < c ? c - range.hi : Surd(0);
      at_open_end |= c < range.lo && hole_.side(axis) == 3;
      distance_sq = distance_sq + gap * gap;
    };
    add(center.x, 0), add(center.y, 1), add(center.z, 2);
    const int sign = (distance_sq - Surd(12)).sign();  // (sqrt(3)/2)^2 in quarters
    return sign > 0 || (sign == 0 && at_open_end);
  }

  /// The side of a base that p is on, the same for all p; 0 if there is none.
  int side_of(const std::vector<Point>& base) const {
    const Vector<Surd> a = quarters(base[0]);
    const Vector<Surd> normal = cross(quarters(base[1]) - a, quarters(base[2]) - a);
    int common = dot(normal, corner(region_, 0) - a).sign();
    for (int c = 1; c < 8; ++c)
      if (dot(normal, corner(region_, c) - a).sign() != common) common = 0;
    return common;
  }

  /// The vertices of `other` are strictly outside all spheres through p and `base`.
  bool is_locally_delaunay(const std::vector<Point>& base, const std::vector<Point>& other) const {
    return std::all_of(other.begin(), other.end(), [&](const Point& d) {
      if (std::find(base.begin(), base.end(), d) != base.end()) return true;
      const std::int64_t side = det(base[0], base[1], base[2], d);
      if (side == 0) return is_outside_circle(base, d);
      // On p's side of the base: d is outside the sphere through p if p is inside the one through d.
      return (side > 0) == (side_of(base) > 0) && p_is_inside({base[0], base[1], base[2], d});
    });
  }

  static bool is_outside_circle(const std::vector<Point>& base, const Point& d) {
    const Point normal = cross(base[1] - base[0], base[2] - base[0]);
    const auto sphere = Circumsphere::of({base[0], base[1], base[2], base[0] + normal});
    return sphere && sphere->side(d) < 0;
  }

  /// |p - c|^2 is greatest at a corner of the region.
  bool p_is_inside(const Tetrahedron& t) const {
    const Quotient<Vector<Surd>> center = circumcenter(t);
    for (int c = 0; c < 8; ++c) {
      const auto distance_sq = [&](const Vector<Surd>& q) {
        const Vector<Surd> gap = center.den.x * q - center.num;
        return length_sq(gap);
      };
      if (!(distance_sq(corner(region_, c)) < distance_sq(quarters(t[0])))) return false;
    }
    return true;
  }

  /// num / den.x, in quarters.
  static Quotient<Vector<Surd>> circumcenter(const Tetrahedron& t) {
    const Vector<Surd> a = quarters(t[0]), b = quarters(t[1]) - a, c = quarters(t[2]) - a,
                       d = quarters(t[3]) - a;
    const Surd twice_det = Surd(2) * dot(b, cross(c, d));
    const Vector<Surd> center =
        length_sq(b) * cross(c, d) + length_sq(c) * cross(d, b) + length_sq(d) * cross(b, c);
    return {center + twice_det * a, {twice_det, twice_det, twice_det}};
  }

  const Hole& hole_;
  Region region_;
};

/// Which lattice coordinates R(p, 0) covers: with 1 < sigma < 3/2 exactly {1, 2} for p in (sigma, 3 - sigma),
/// exactly {1, 2, 3} for p in [3 - sigma, 1 + sigma], and translates of the two intervals fill the line.
bool intervals_are_as_said(const Surd& four_sigma) { return Surd(4) < four_sigma && four_sigma < Surd(6); }

}  // namespace

Hole::Hole(int wide) : sides_{wide > 2 ? 4 : 3, wide > 1 ? 4 : 3, wide > 0 ? 4 : 3} {
  for (int x = 0; x < sides_[0]; ++x)
    for (int y = 0; y < sides_[1]; ++y)
      for (int z = 0; z < sides_[2]; ++z) {
        std::vector<Point> left, base;
        for (const Point& p : cube_corners({x, y, z})) {
          if (ends(p) > 0) left.push_back(p);
          if (ends(p) == 1) base.push_back(p);
        }
        if (!base.empty()) bases_.push_back(base);
        if (left.size() > 4) cut_cubes_.push_back(left);
      }
}

int Hole::ends(const Point& p) const {
  const auto at_end = [](std::int64_t c, int side) { return c == 0 || c == side; };
  return at_end(p.x, sides_[0]) + at_end(p.y, sides_[1]) + at_end(p.z, sides_[2]);
}

Region Hole::region(const Surd& four_sigma) const {
  const auto range = [&](int side) {
    return side == 3 ? Range{four_sigma, Surd(6)} : Range{Surd(12) - four_sigma, Surd(8)};
  };
  return {range(sides_[0]), range(sides_[1]), range(sides_[2])};
}

std::vector<Point> Hole::face_vertices() const {
  std::set<Point> points;
  for (const auto& base : bases_) points.insert(base.begin(), base.end());
  return {points.begin(), points.end()};
}

Finding prove_theorem_8(const Theorem8& claim) {
  const bool intervals = intervals_are_as_said(claim.four_sigma);
  Finding finding{part("1 < sigma < 3/2: R(p, 0) covers two or three lattice coordinates along each axis",
                       intervals ? "so it is" : "not so", intervals)};
  const auto say = [&](int number, const std::string& what, bool holds) {
    finding.push_back(
        part(fmt::format("case {}: {}", number, what), holds ? "for all p" : "not for all p", holds));
  };
  for (int number = 1; number <= 4; ++number) {
    const Hole hole(number - 1);
    const Decision decide(hole, claim.four_sigma);
    finding.push_back(count_part(fmt::format("box face vertices in case {}", number),
                                 claim.face_vertices[std::size_t(number - 1)],
                                 int(hole.face_vertices().size())));
    say(number, "no sphere of a lattice cell holds p", decide.is_outside_lattice_spheres());
    say(number, "the box face vertices' hull encloses p", decide.bases_enclose_p());
    say(number, "hull and cut cubes fill the hole", decide.cells_fill_the_box());
    say(number, "p joins this hull and nothing else, strictly Delaunay", decide.pyramids_are_delaunay());
  }
  const Surd half_width = claim.four_sigma - Surd(2);
  const bool tight = half_width * half_width + half_width * half_width == Surd(12);
  finding.push_back(
      part("sigma is the least possible: (sigma, sigma, 3/2) is on the sphere about (1/2, 1/2, 3/2)",
           tight ? "it is, exactly" : "it is not", tight));
  return finding;
}

}  // namespace unsliver::prover
