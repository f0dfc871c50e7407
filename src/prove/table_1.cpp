#include <algorithm>

#include "prove/decimals.hpp"
#include "prove/theorem_8.hpp"

namespace unsliver::prover {
namespace {

/// One quantity of each tetrahedron of p with three vertices of a base, in all ties, at each edge.
std::vector<Quantity> quantities(const Hole& hole, Quantity::Kind kind) {
  std::vector<Quantity> all;
  for (const auto& base : hole.bases())
    for (std::size_t left_out = 0; left_out < (base.size() == 4 ? 4u : 1u); ++left_out) {
      Quantity q{kind, {}, 0, 0};
      std::size_t corner = 0;
      for (std::size_t i = 0; i < base.size(); ++i)
        if (base.size() == 3 || i != left_out) q.base[corner++] = base[i];
      for (q.i = 0; q.i < 4; ++q.i)
        for (q.j = q.i + 1; q.j < 4; ++q.j) all.push_back(q);
    }
  return all;
}

/// All tetrahedra of corners of a lattice cube: they are in S whatever p is.
Shape lattice_cells() {
  Shape all;
  const auto corners = points_around_origin(1, [](const Point& p) { return std::min({p.x, p.y, p.z}) >= 0; });
  for_each_tetrahedron_at_origin(corners, [&](const Tetrahedron& t, const Circumsphere& s) {
    all.include(shape_of(t, s));
  });
  return all;
}

/// The tetrahedra of lattice points and p = (x, y, z) at one corner of the region that attain the extreme.
std::string places_text(const Extreme& extreme) {
  const Extreme::Place& first = extreme.places.front();
  std::string text = fmt::format("{} times, as in p", extreme.places.size());
  for (const Point& p : first.quantity.base) text += fmt::format(" ({},{},{})", p.x, p.y, p.z);
  const bool all_at_least = std::all_of(extreme.places.begin(), extreme.places.end(),
                                        [](const Extreme::Place& place) { return place.corner == 0; });
  return text + (all_at_least ? ", only at the p of the table" : ", also at other p");
}

bool is_at_least_corner(const Extreme& extreme) {
  return std::any_of(extreme.places.begin(), extreme.places.end(),
                     [](const Extreme::Place& place) { return place.corner == 0; });
}

/// What one case of the table says of one quantity.
struct Row {
  int number;
  const char* name;
  Extreme extreme;
};

std::string found_text(const Row& row, const Enclosure& value) {
  return fmt::format("{} {}, {}; {} boxes{}", row.name, text(value), places_text(row.extreme), row.extreme.boxes,
                     row.extreme.is_certain ? "" : ", NOT decided");
}

}  // namespace

Finding prove_table_1(const Table1& claim) {
  Finding finding;
  const Shape lattice = lattice_cells();
  for (int number = 1; number <= 4; ++number) {
    const auto index = std::size_t(number - 1);
    const Hole hole(number - 1);
    const Region region = hole.region(claim.four_sigma);
    const Row least{number, "cos^2", largest(quantities(hole, Quantity::kSmallAngle), region)};
    const Row greatest{number, "-cos^2", largest(quantities(hole, Quantity::kLargeAngle), region)};
    const Row ratio{number, "ratio^2", largest(quantities(hole, Quantity::kRatio), region)};
    const auto add = [&](const Row& row, const std::string& claimed, const Enclosure& value, bool holds) {
      finding.push_back(part(fmt::format("case {}: {}", number, claimed), found_text(row, value),
                             holds && row.extreme.is_certain));
    };
    const Enclosure least_value = enclosure_of(least.extreme.value);
    add(least, fmt::format("least angle {} at the table's p", thousandths_text(claim.least[index])), least_value,
        prints_as(least_value, claim.least[index]) && is_at_least_corner(least.extreme));
    const Enclosure greatest_value = enclosure_of(greatest.extreme.value);
    add(greatest, fmt::format("greatest angle {}", thousandths_text(claim.greatest[index])), greatest_value, true);
    const Enclosure ratio_value = enclosure_of(ratio.extreme.value);
    add(ratio, fmt::format("largest ratio {} at the table's p", thousandths_text(claim.ratio[index])), ratio_value,
        root_prints_as(ratio_value, claim.ratio[index]) && is_at_least_corner(ratio.extreme));
  }
  finding.push_back(part("lattice", text(lattice), true));
  return finding;
}

}  // namespace unsliver::prover
