#include "prove/lattices.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace unsliver::prover {
namespace {

bool any_point(const Point&) { return true; }

Fraction scaled(const Fraction& f, std::int64_t num, std::int64_t den) { return {f.num * num, f.den * den}; }

ProofPart squared_part(const std::string& what, const Fraction& claimed, const Fraction& found) {
  return part(fmt::format("{}^2 = {}", what, text(claimed)), text(found), claimed == found);
}

/// The shortest vector of the lattice, squared. Requires one of squared length at most 4.
Fraction shortest_sq(bool (*in_lattice)(const Point&)) {
  Fraction shortest{4, 1};
  for (const Point& p : points_around_origin(2, in_lattice)) shortest = std::min(shortest, {dot(p, p), 1});
  return shortest;
}

struct Delaunay {
  Fraction largest_radius_sq{0, 1};
  Shape shape;
};

/// Of all tetrahedra of the lattice at the origin whose balls are empty, whatever breaks the ties. A largest
/// empty ball has such a tetrahedron. Requires that balls with a radius above reach/2 are never empty.
Delaunay delaunay_at_origin(bool (*in_lattice)(const Point&), int reach) {
  const auto points = points_around_origin(reach, in_lattice);
  Delaunay result;
  for_each_tetrahedron_at_origin(points, [&](const Tetrahedron& t, const Circumsphere& sphere) {
    if (std::any_of(points.begin(), points.end(), [&](const Point& p) { return sphere.holds_inside(p); }))
      return;
    result.largest_radius_sq = std::max(result.largest_radius_sq, sphere.radius_sq());
    result.shape.include(shape_of(t, sphere));
  });
  return result;
}

}  // namespace

Finding prove_nesting(const Nesting& claim) {
  // Membership has period 4 in halves of the spacing of SC_0 along each axis.
  const auto in_period = [&](bool (*inner)(const Point&), bool (*outer)(const Point&)) {
    bool subset = true, equal = true;
    for (int i = 0; i < 64; ++i) {
      const Point p{i & 3, i >> 2 & 3, i >> 4};
      subset &= !inner(p) || outer(p);
      equal &= inner(p) == outer(p);
    }
    return subset && !equal;
  };
  const bool first = in_period(claim.coarse, claim.middle), second = in_period(claim.middle, claim.fine);
  const auto said = [](bool yes) {
    return yes ? "a proper subset, on a whole period" : "not a proper subset";
  };
  return {part("BCC_{k+1} is a proper subset of SC_k", said(first), first),
          part("SC_k is a proper subset of BCC_k", said(second), second)};
}

Finding prove_lattice_lengths(const LatticeLengths& claim) {
  // No ball of radius sqrt(3)/2 misses SC_0: its centre is in a unit cube, whose nearest corner is no
  // farther.
  const Delaunay sc = delaunay_at_origin(any_point, 2), bcc = delaunay_at_origin(is_bcc, 4);
  return {squared_part("e(SC_0)", claim.sc_shortest_sq, shortest_sq(any_point)),
          squared_part("e(BCC_0)", claim.bcc_shortest_sq, scaled(shortest_sq(is_bcc), 1, 4)),
          squared_part("r(SC_0)", claim.sc_covering_sq, sc.largest_radius_sq),
          squared_part("r(BCC_0)", claim.bcc_covering_sq, scaled(bcc.largest_radius_sq, 1, 4)),
          shape_part("Delaunay tetrahedra of BCC: ", claim.bcc_delaunay, bcc.shape)};
}

Finding prove_lemma_5(const Lemma5& claim) {
  Shape all;
  int count = 0;
  std::set<Tetrahedron> different;
  std::map<Tetrahedron, Angle> worst;
  // R <= sqrt(5)/2 keeps the other corners within sqrt 5.
  const auto points = points_around_origin(2, any_point);
  for_each_tetrahedron_at_origin(points, [&](const Tetrahedron& t, const Circumsphere& sphere) {
    if (sphere.radius_sq() > claim.largest_radius_sq) return;
    const Shape shape = shape_of(t, sphere);
    all.include(shape);
    ++count;
    different.insert(up_to_translation(t));
    if (shape.least <= claim.least || shape.greatest >= claim.greatest)
      worst.emplace(up_to_symmetry(t), shape.greatest);
  });
  std::vector<Angle> greatest;
  std::string names;
  for (const auto& [t, angle] : worst) {
    greatest.push_back(angle);
    names += fmt::format("; {} up to {}", text(t), text(angle));
  }
  std::sort(greatest.begin(), greatest.end());
  return {part(fmt::format("tetrahedra of SC_0 with R^2 <= {} have angles in [{}, {}], both attained",
                           text(claim.largest_radius_sq), text(claim.least), text(claim.greatest)),
               fmt::format("[{}, {}]; {} tetrahedra up to translation", text(all.least), text(all.greatest),
                           different.size()),
               all.least == claim.least && all.greatest == claim.greatest),
          count_part("of them have a given corner", claim.at_a_corner, count),
          part(fmt::format("{} tetrahedra attain a bound, up to symmetry (Figure 3)", claim.worst.size()),
               fmt::format("{}{}", worst.size(), names), greatest == claim.worst)};
}

Finding prove_lemma_6(const Lemma6& claim) {
  Shape all;
  std::set<Tetrahedron> different, worst;
  const Fraction largest = scaled(claim.largest_radius_sq, 4, 1);
  // Each tetrahedron is met at each of its corners: in SC_0, or a centre, a translation by (1, 1, 1) away.
  for (const Point& corner : {Point{0, 0, 0}, Point{1, 1, 1}}) {
    const auto in_sc = [&](const Point& p) { return is_even(p + corner); };
    auto outside = points_around_origin(3, in_sc);
    if (in_sc({})) outside.push_back({});
    for_each_tetrahedron_at_origin(points_around_origin(3, is_bcc), [&](const Tetrahedron& t,
                                                                        const Circumsphere& sphere) {
      if (sphere.radius_sq() > largest) return;
      if (std::any_of(outside.begin(), outside.end(), [&](const Point& p) { return sphere.holds_inside(p); }))
        return;
      const Shape shape = shape_of(t, sphere);
      all.include(shape);
      different.insert(up_to_translation(t));
      if (shape.least <= claim.least || shape.greatest >= claim.greatest) worst.insert(up_to_symmetry(t));
    });
  }
  const std::string example = worst.empty() ? "" : ": " + text(*worst.begin()) + " in halves";
  return {
      part(fmt::format(
               "tetrahedra of BCC_0 with R^2 <= {} and no point of SC_0 inside the circumsphere have angles "
               "in [{}, {}], both attained",
               text(claim.largest_radius_sq), text(claim.least), text(claim.greatest)),
           fmt::format("[{}, {}]; {} tetrahedra up to translation", text(all.least), text(all.greatest),
                       different.size()),
           all.least == claim.least && all.greatest == claim.greatest),
      part(fmt::format("{} of them attains a bound, up to symmetry (Figure 4)", claim.worst),
           fmt::format("{}{}", worst.size(), example), int(worst.size()) == claim.worst)};
}

}  // namespace unsliver::prover
