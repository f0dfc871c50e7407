#include "prove/figure_8_runs.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>

#include "prove/constants.hpp"

namespace unsliver::prover {
namespace {

/// Some far apart, some in tight pairs.
std::vector<Point> random_inputs(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::int64_t n) { return std::int64_t(random() % std::uint64_t(n)); };
  std::vector<Point> inputs;
  for (int i = 0; i < 6; ++i) {
    const Point u{1024 + below(6144), 1024 + below(6144), 1024 + below(6144)};
    inputs.push_back(u);
    inputs.push_back(u + Point{48 + below(400), below(300), below(600)});
  }
  std::sort(inputs.begin(), inputs.end());
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  return inputs;
}

/// The bounds of the lemmas and of 5.2.5, squared, in units of 4^k.
struct Bounds {
  explicit Bounds(const Fraction& scale) {
    const auto scaled = [&](const Enclosure& x) { return square(Enclosure(scale) * x); };
    const Enclosure both = r.root3 + r.rho;
    lemma_10 = scaled(both);
    lemma_11 = scaled(r.root5 + Enclosure(2) * both);
    lemma_11_type_2 = scaled(Enclosure(2) * both);
    to_coarse = scaled(r.root5 + Enclosure(5) * both);
    to_incomplete = scaled(Enclosure(5) * both);
    to_other_input = scaled(Enclosure(2) * r.root5 + Enclosure(7) * both);
    sc_budget = scaled(k.a);
    bcc_budget = scaled(Enclosure(2) * k.b);
    neighbour = square(Enclosure(1) + k.a);
  }
  Roots r;
  Figure8Constants k{r};
  Enclosure lemma_10, lemma_11, lemma_11_type_2, to_coarse, to_incomplete, to_other_input, sc_budget,
      bcc_budget, neighbour;
};

/// What was watched over all runs, by name.
class Watch {
 public:
  explicit Watch(const Bounds& bounds) : bounds_(bounds) {}

  void over(const Figure8& run) {
    vertices_ = &run.vertices();
    for (const auto& [subcase, watched] : run.table_2()) table_2[subcase].include(watched);
    for (VertexId id = 1; id < vertices_->size(); ++id) {
      const Figure8Vertex& w = at(id);
      if (w.type == VertexType::kInput) continue;
      ++inserted;
      lemmas(w);
      inequality_1(w);
      if (w.type == VertexType::k2) chain(w);
    }
    neighbours();
  }

  std::map<std::string, Watched> table_2;
  Watched lemma_10, lemma_11, to_coarse, to_other_input, to_incomplete, budget, neighbour;
  int inserted = 0;
  bool chain_keeps_k = true, incomplete_ends_at_type_2 = true;

 private:
  const Figure8Vertex& at(VertexId id) const { return (*vertices_)[id]; }

  void lemmas(const Figure8Vertex& w) {
    const int k = w.exponent();
    if (w.parent != kNoVertex) lemma_10.see(at(w.parent).at, w.at, k, bounds_.lemma_10);
    if (w.nearby == kNoVertex) return;
    const bool is_type_2 = w.type == VertexType::k2;
    lemma_11.see(at(w.nearby).at, w.at, k, is_type_2 ? bounds_.lemma_11_type_2 : bounds_.lemma_11);
  }

  /// lfs_i(w)^2: the second nearest input vertex, or the nearest other one.
  std::int64_t lfs_sq(const Figure8Vertex& w) const {
    std::vector<std::int64_t> distances;
    for (const Figure8Vertex& u : *vertices_)
      if (&u != &vertices_->front() && u.type == VertexType::kInput)
        distances.push_back(dot(u.at - w.at, u.at - w.at));
    std::nth_element(distances.begin(), distances.begin() + 1, distances.end());
    return distances[1];
  }

  void inequality_1(const Figure8Vertex& w) {
    const bool is_sc = (w.level & 1) != 0;
    const Enclosure& bound_sq = is_sc ? bounds_.sc_budget : bounds_.bcc_budget;
    budget.see(Fraction{lfs_sq(w), std::int64_t{1} << (2 * w.exponent())}, bound_sq);
  }

  /// 5.2.5, for w of type 2.
  void chain(const Figure8Vertex& w) {
    const Figure8Vertex* last = &w;  // w'
    const auto continues = [&](const Figure8Vertex& p) {
      return (p.type == VertexType::k11 || p.type == VertexType::k2) && p.nearby == w.nearby;
    };
    const int k = w.exponent();
    while (continues(at(last->parent))) {
      last = &at(last->parent);
      chain_keeps_k &= last->exponent() == k;
    }
    const Figure8Vertex& end = at(last->parent);
    if (end.type != VertexType::k11 && end.type != VertexType::k2)
      to_coarse.see(end.at, w.at, k, bounds_.to_coarse);
    else if (end.nearby != kNoVertex)
      to_other_input.see(at(end.nearby).at, w.at, k, bounds_.to_other_input);
    else {
      to_incomplete.see(end.at, w.at, k, bounds_.to_incomplete);
      incomplete_ends_at_type_2 &= last->type == VertexType::k2;
    }
  }

  /// |vw| >= lfs(v)/(1 + a) for all vertices.
  void neighbours() {
    for (VertexId i = 1; i < vertices_->size(); ++i) {
      std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
      for (VertexId j = 1; j < vertices_->size(); ++j)
        if (i != j) nearest = std::min(nearest, dot(at(i).at - at(j).at, at(i).at - at(j).at));
      neighbour.see(Fraction{lfs_sq(at(i)), nearest}, bounds_.neighbour);
    }
  }

  const Bounds& bounds_;
  const std::vector<Figure8Vertex>* vertices_ = nullptr;
};

void add_table_2(Finding& finding, const Watch& watch) {
  for (const auto& [subcase, watched] : watch.table_2)
    finding.push_back(watched_part("Table 2, " + subcase, watched));
}

}  // namespace

Finding prove_figure_8_runs(const Figure8Runs& claim) {
  const Bounds bounds(claim.scale);
  Watch watch(bounds);
  std::string broken;
  for (int seed = 1; seed <= claim.runs; ++seed) {
    Figure8 run(random_inputs(std::uint64_t(seed)));
    try {
      run.run();
    } catch (const std::logic_error& error) {
      broken = fmt::format("{}, seed {}", error.what(), seed);
    }
    watch.over(run);
  }
  Finding finding{part("Lemmas 3, 5 and 6 and Corollary 9 give a point whenever Figure 8 asks for one",
                       broken.empty()
                           ? fmt::format("{} vertices inserted in {} runs", watch.inserted, claim.runs)
                           : "not " + broken,
                       broken.empty())};
  add_table_2(finding, watch);
  finding.push_back(watched_part("Lemma 10: |p(w) w| <= 2^k (sqrt 3 + rho)", watch.lemma_10));
  finding.push_back(
      watched_part("Lemma 11: |n(w) w| <= 2^k (sqrt 5 + 2 sqrt 3 + 2 rho); 2^k (2 sqrt 3 + 2 rho) for type 2",
                   watch.lemma_11));
  finding.push_back(part("5.2.5: all labels of a chain are SC_k or BCC_{k+1} with the same k",
                         watch.chain_keeps_k ? "for all" : "not for all", watch.chain_keeps_k));
  finding.push_back(watched_part(
      "5.2.5, p(w') of type 1.2 or 3: |p(w') w| <= 2^k (sqrt 5 + 5 sqrt 3 + 5 rho)", watch.to_coarse));
  finding.push_back(
      watched_part("5.2.5, else: |n(p(w')) w| <= 2^k (2 sqrt 5 + 7 sqrt 3 + 7 rho)", watch.to_other_input));
  finding.push_back(
      part("5.2.5: there n(p(w')) is an input vertex",
           fmt::format("{} times it is null: p(w') of type 1.1 whose parent is of type 1.2 or 3",
                       watch.to_incomplete.count),
           !claim.chain_ends_are_complete || watch.to_incomplete.count == 0, kDifferences));
  finding.push_back(watched_part("where it is null, w' is of type 2 and |p(w') w| <= 2^k (5 sqrt 3 + 5 rho)",
                                 watch.to_incomplete));
  finding.back().holds &= watch.incomplete_ends_at_type_2;
  finding.push_back(watched_part("(1): lfs(w) <= 2^k a for SC_k, 2^{k+1} b for BCC_{k+1}", watch.budget));
  finding.push_back(watched_part("nearest neighbours are at lfs/(1 + a) or more", watch.neighbour));
  return finding;
}

}  // namespace unsliver::prover
