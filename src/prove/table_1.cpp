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
  for_each_tetrahedron_at_origin(
      corners, [&](const Tetrahedron& t, const Circumsphere& s) { all.include(shape_of(t, s)); });
  return all;
}

/// Where an extreme is attained. p is at the lower corner of the region in all of the table.
std::string places_text(int number, const Extreme& extreme) {
  std::string text = fmt::format("{} tetrahedra and edges, the first p", extreme.places.size());
  for (const Point& p : extreme.places.front().quantity.base)
    text += fmt::format(" ({},{},{})", p.x, p.y, p.z);
  // Case 4 alone has no axis of the half open kind I.
  return number < 4 ? text + "; a limit, sigma is not in I" : text;
}

bool is_only_at_lower_corner(const Extreme& extreme) {
  return extreme.is_certain && std::all_of(extreme.places.begin(), extreme.places.end(),
                                           [](const Extreme::Place& place) { return place.corner == 0; });
}

/// p's own tetrahedra in one case.
struct Row {
  Row(const Hole& hole, const Region& region)
      : least(largest(quantities(hole, Quantity::kSmallAngle), region)),
        greatest(largest(quantities(hole, Quantity::kLargeAngle), region)),
        ratio(largest(quantities(hole, Quantity::kRatio), region)) {}

  Enclosure least_signed_cos_sq() const { return enclosure_of(least.value); }
  Enclosure greatest_signed_cos_sq() const { return -enclosure_of(greatest.value); }
  Enclosure ratio_sq() const { return enclosure_of(ratio.value); }

  Extreme least, greatest, ratio;
};

ProofPart least_part(int number, int claimed, const Row& row, const Shape& lattice) {
  const Enclosure found = row.least_signed_cos_sq();
  const bool beats_lattice = Enclosure(lattice.least.signed_cos_sq()).is_certainly_below(found);
  return part(
      fmt::format("case {}: least angle about {}, at the table's p alone", number, thousandths_text(claimed)),
      fmt::format("{}: {}", degrees_text(found), places_text(number, row.least)),
      is_only_at_lower_corner(row.least) && prints_as(found, claimed) && beats_lattice);
}

ProofPart greatest_part(int number, int claimed, bool is_intrinsic, const Row& row, const Shape& lattice) {
  const Enclosure found = row.greatest_signed_cos_sq(), of_lattice(lattice.greatest.signed_cos_sq());
  const bool is_of_lattice = row.greatest.is_certain && of_lattice.is_certainly_below(found);
  const Enclosure all = is_of_lattice ? of_lattice : found;
  return part(
      fmt::format("case {}: greatest angle about {}, {}", number, thousandths_text(claimed),
                  is_intrinsic ? "of lattice tetrahedra" : "at the table's p alone"),
      fmt::format("{}: {}", degrees_text(all),
                  is_of_lattice ? fmt::format("p's own reach {}", degrees_text(found))
                                : places_text(number, row.greatest)),
      prints_as(all, claimed) && is_intrinsic == is_of_lattice && is_only_at_lower_corner(row.greatest));
}

ProofPart ratio_part(int number, int claimed, const Row& row) {
  const Enclosure found = row.ratio_sq();
  return part(fmt::format("case {}: largest ratio about {}, at the table's p alone", number,
                          thousandths_text(claimed)),
              fmt::format("{:.5f}: {}", middle(square_root(found)), places_text(number, row.ratio)),
              is_only_at_lower_corner(row.ratio) && root_prints_as(found, claimed));
}

/// The extremes of all cases, as exact as they come.
struct Total {
  SurdFraction least_signed_cos_sq{-1}, ratio_sq{0};
  Enclosure greatest_signed_cos_sq{1};
  bool is_certain = true;

  void include(const Row& row) {
    least_signed_cos_sq = std::max(least_signed_cos_sq, row.least.value);
    ratio_sq = std::max(ratio_sq, row.ratio.value);
    if (row.greatest_signed_cos_sq().is_certainly_below(greatest_signed_cos_sq))
      greatest_signed_cos_sq = row.greatest_signed_cos_sq();
    is_certain &= row.least.is_certain && row.greatest.is_certain && row.ratio.is_certain;
  }
};

void add_total(Finding& finding, const Table1& claim, const Total& total) {
  const SurdFraction bound{int(claim.least_signed_cos_sq.num), int(claim.least_signed_cos_sq.den)};
  const Fraction ratio_sq_bound{std::int64_t(claim.ratio_bound) * claim.ratio_bound, 1'000'000};
  const auto found = [&](bool holds) { return holds ? "for all p, exactly" : "not for all p"; };
  const auto add = [&](const std::string& claimed, bool holds) {
    finding.push_back(part(claimed, found(holds), holds && total.is_certain));
  };
  add("all cases: no angle is below 30", !(bound < total.least_signed_cos_sq));
  add("all cases: angles are below " + thousandths_text(claim.greatest_bound),
      is_below(total.greatest_signed_cos_sq, claim.greatest_bound));
  add("all cases: ratios are below " + thousandths_text(claim.ratio_bound),
      enclosure_of(total.ratio_sq).is_certainly_below(ratio_sq_bound));
  const bool all_hold =
      std::all_of(finding.begin(), finding.end(), [](const ProofPart& p) { return p.holds; });
  add("Corollary 9: so what Figure 8 calls bad, outside [30, 135] or above 1.368, has a point of S inside",
      all_hold);
}

}  // namespace

Finding prove_table_1(const Table1& claim) {
  Finding finding;
  Total total;
  const Shape lattice = lattice_cells();
  for (int number = 1; number <= 4; ++number) {
    const auto i = std::size_t(number - 1);
    const Hole hole(number - 1);
    const Row row(hole, hole.region(claim.four_sigma));
    total.include(row);
    finding.push_back(least_part(number, claim.least[i], row, lattice));
    finding.push_back(greatest_part(number, claim.greatest[i], claim.greatest_is_intrinsic[i], row, lattice));
    finding.push_back(ratio_part(number, claim.ratio[i], row));
  }
  add_total(finding, claim, total);
  return finding;
}

}  // namespace unsliver::prover
