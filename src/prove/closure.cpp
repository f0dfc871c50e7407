#include "prove/closure.hpp"

#include <algorithm>

#include "prove/decimals.hpp"
#include "prove/lattices.hpp"

namespace unsliver::prover {
namespace {

bool none_inside(const Circumsphere& sphere, const std::vector<Point>& points) {
  return std::none_of(points.begin(), points.end(), [&](const Point& p) { return sphere.holds_inside(p); });
}

/// Tetrahedra at the origin with certain points outside.
struct Census {
  int count = 0;
  Shape shape;
  Fraction largest_radius_sq{0, 1};

  void add(const Tetrahedron& t, const Circumsphere& sphere) {
    ++count;
    shape.include(shape_of(t, sphere));
    largest_radius_sq = std::max(largest_radius_sq, sphere.radius_sq());
  }
};

Census census(const std::vector<Point>& points, const std::vector<Point>& outside) {
  Census result;
  for_each_tetrahedron_at_origin(points, [&](const Tetrahedron& t, const Circumsphere& sphere) {
    if (none_inside(sphere, outside)) result.add(t, sphere);
  });
  return result;
}

Finding finding_of(const Census& census, int count, const Fraction& radius_sq, const Shape& bounds) {
  return {count_part("tetrahedra", count, census.count),
          part(fmt::format("R^2 <= {}", text(radius_sq)),
               fmt::format("R^2 up to {}", text(census.largest_radius_sq)),
               census.largest_radius_sq <= radius_sq),
          shape_part("extremes: ", bounds, census.shape)};
}

/// The brick y <= 0, or y <= 0 and z <= 0, with v = 0 in its boundary, K >= 1.
struct Boundary {
  std::string place;
  bool second_face;            ///< z <= 0 too
  std::vector<Point> parents;  ///< in the brick
  std::vector<Point>
      theirs;  ///< corners of the cubes of side 2 at v: the parents of those parents that are centres
};

bool in_brick(const Boundary& b, const Point& p) { return p.y <= 0 && (!b.second_face || p.z <= 0); }

/// Of v the middle of the edge along x, or of the face across y.
Boundary boundary(const std::string& place, bool second_face, bool middle_of_face) {
  Boundary b{place, second_face, {}, {}};
  std::vector<Point> parents{{1, 0, 0}, {-1, 0, 0}, {0, 1, 1}, {0, 1, -1}, {0, -1, 1}, {0, -1, -1}};
  if (middle_of_face) parents = {{0, 1, 0}, {0, -1, 0}, {1, 0, 1}, {1, 0, -1}, {-1, 0, 1}, {-1, 0, -1}};
  for (const Point& p : parents) {
    if (!in_brick(b, p)) continue;
    b.parents.push_back(p);
    for (int corner = 0; corner < 8; ++corner) {
      const Point q = p + Point{corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};
      const bool is_center = middle_of_face ? p.y != 0 : p.x == 0;
      if (is_center && q != Point{} && in_brick(b, q)) b.theirs.push_back(q);
    }
  }
  return b;
}

bool is_beyond(const Boundary& b, const Circumsphere& sphere) {
  return sphere.compare_center(1, 0) > 0 || (b.second_face && sphere.compare_center(2, 0) > 0);
}

}  // namespace

Finding prove_closure_a(const ClosureA& claim) {
  // R <= sqrt(5)/2 by the parents; without them the window of 3 would hold others too.
  const auto points = points_around_origin(3, [](const Point&) { return true; });
  return finding_of(census(points, claim.parents), claim.count, claim.largest_radius_sq, claim.bounds);
}

Finding prove_closure_b(const ClosureB& claim) {
  const auto corners = points_around_origin(1, [](const Point& p) { return (p.x & p.y & p.z & 1) != 0; });
  Census found = census(points_around_origin(3, is_bcc), corners);
  found.largest_radius_sq.den *= 4;
  return finding_of(found, claim.count, claim.largest_radius_sq, claim.bounds);
}

Finding prove_closure_brick(const ClosureBrick& claim) {
  Finding finding;
  Shape all, beyond;
  const auto decide = [&](const Boundary& b, int claimed) {
    std::vector<Point> outside = b.parents;
    if (claim.keep_parents_of_parents_out) outside.insert(outside.end(), b.theirs.begin(), b.theirs.end());
    int count = 0;
    const auto points = points_around_origin(3, [&](const Point& p) { return in_brick(b, p); });
    for_each_tetrahedron_at_origin(points, [&](const Tetrahedron& t, const Circumsphere& sphere) {
      if (!none_inside(sphere, outside)) return;
      const Shape shape = shape_of(t, sphere);
      all.include(shape);
      if (!is_beyond(b, sphere)) return;
      ++count;
      beyond.include(shape);
    });
    finding.push_back(
        count_part("tetrahedra with circumcentre beyond, v the middle of " + b.place, claimed, count));
  };
  decide(boundary("an edge in a face of the brick", false, false), claim.edge_in_a_face);
  decide(boundary("a face in a face of the brick", false, true), claim.face_in_a_face);
  decide(boundary("an edge in an edge of the brick", true, false), claim.edge_in_an_edge);
  finding.push_back(shape_part("those beyond: ", claim.beyond, beyond));
  finding.push_back(shape_part("all at these places: ", claim.bounds, all));
  return finding;
}

namespace {

/// A lattice L_0 in units in which it is one of integers.
struct Lattice {
  bool (*holds)(const Point&);
  int period;                ///< of L_1 along the axes
  std::int64_t covering_sq;  ///< r(L_1)^2
};

/// Of the tetrahedra of L_0 whose open circumballs hold no point of L_1; their radii are at most r(L_1).
Shape single_lattice(const Lattice& lattice) {
  Shape all;
  const auto in_double = [&](const Point& q) {
    return is_even(q) && lattice.holds({q.x / 2, q.y / 2, q.z / 2});
  };
  const auto near = [&](const Point& p) { return dot(p, p) <= 4 * lattice.covering_sq; };
  const int n = lattice.period;
  for (int i = 0; i < n * n * n; ++i) {
    const Point corner{i % n, i / n % n, i / n / n};
    if (!lattice.holds(corner)) continue;
    const auto points =
        points_around_origin(4, [&](const Point& p) { return near(p) && lattice.holds(p + corner); });
    const auto outside =
        points_around_origin(4, [&](const Point& p) { return near(p) && in_double(p + corner); });
    for_each_tetrahedron_at_origin(points, [&](const Tetrahedron& t, const Circumsphere& sphere) {
      if (sphere.radius_sq() <= Fraction{lattice.covering_sq, 1} && none_inside(sphere, outside))
        all.include(shape_of(t, sphere));
    });
  }
  return all;
}

ProofPart least_part(const std::string& lattice, int millidegrees, const Shape& shape) {
  return part(fmt::format("{} alone: least angle about {}", lattice, thousandths_text(millidegrees)),
              fmt::format("cos^2 = {}: {}", text(shape.least.signed_cos_sq()), text(shape)),
              prints_as(shape.least, millidegrees));
}

}  // namespace

Finding prove_single_lattices(const SingleLattices& claim) {
  const Lattice sc{[](const Point&) { return true; }, 2, 3};
  const Lattice bcc{is_bcc, 4, 5};                                                       // in halves
  const Lattice fcc{[](const Point& p) { return ((p.x + p.y + p.z) & 1) == 0; }, 4, 4};  // in halves
  return {least_part("SC", claim.sc, single_lattice(sc)), least_part("BCC", claim.bcc, single_lattice(bcc)),
          least_part("FCC", claim.fcc, single_lattice(fcc))};
}

}  // namespace unsliver::prover
