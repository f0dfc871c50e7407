#include "verify/tetrahedra_check.hpp"

#include <algorithm>

#include "verify/judge.hpp"

namespace unsliver::verifier {
namespace {

/// A running sum that carries what rounding drops (Neumaier).
class Sum {
 public:
  void add(double x) {
    const double next = total_ + x;
    lost_ += std::abs(total_) >= std::abs(x) ? (total_ - next) + x : (x - next) + total_;
    total_ = next;
  }
  double value() const { return total_ + lost_; }

 private:
  double total_ = 0, lost_ = 0;
};

/// The tetrahedra with the extreme qualities so far.
struct Extremes {
  double largest_cot = -INFINITY, smallest_cot = INFINITY, ratio_sq = 0;
  std::size_t min_tet = 0, max_tet = 0, ratio_tet = 0;
  FineMeasures fine{180, 0, 0};  ///< of tetrahedra that doubles could not measure

  void add(const Measures& m, std::size_t t) {
    if (m.largest_cot > largest_cot) largest_cot = m.largest_cot, min_tet = t;
    if (m.smallest_cot < smallest_cot) smallest_cot = m.smallest_cot, max_tet = t;
    if (m.ratio_sq > ratio_sq) ratio_sq = m.ratio_sq, ratio_tet = t;
  }
  void add(const FineMeasures& m) {
    fine = {std::min(fine.min_deg, m.min_deg), std::max(fine.max_deg, m.max_deg),
            std::max(fine.ratio, m.ratio)};
  }
};

class Pass {
 public:
  Pass(const Context& c, const Sites& sites, const std::vector<VertexId>& beyond)
      : c_(c),
        sites_(sites),
        beyond_(beyond),
        bounds_(c.options.guarantee ? make_bounds(*c.options.guarantee) : Bounds{}),
        judge_(sites, bounds_) {}

  void run() {
    for (std::size_t t = 0; t < c_.mesh.tets.size(); ++t) {
      check(t);
      c_.pulse.beat();
    }
    conclude();
  }

 private:
  void check(std::size_t t) {
    const Candidate candidate = judge_.candidate(c_.mesh.tets[t]);
    if (candidate.orientation <= 0) find_orientation(t, candidate.orientation);
    if (candidate.orientation == 0) return extremes_.add(FineMeasures{0, 180, INFINITY});
    volume_.add(candidate.shape.det);
    measure(t, candidate);
    if (c_.options.guarantee) check_quality(t, judge_.quality(candidate));
    if (!beyond_.empty()) check_delaunay(t, candidate);
  }

  void find_orientation(std::size_t t, int orientation) {
    c_.reporter.find("orientation", {static_cast<std::int64_t>(t)}, [&] {
      return describe_tet(c_.mesh, t) + (orientation < 0 ? " is negatively oriented" : " is flat");
    });
  }

  void measure(std::size_t t, const Candidate& candidate) {
    const Measures m = judge_.measures(candidate);
    if (std::isfinite(m.largest_cot) && std::isfinite(m.smallest_cot) && std::isfinite(m.ratio_sq)) {
      extremes_.add(m, t);
      measured_ = true;
    } else {
      extremes_.add(judge_.fine_measures(candidate.v));
    }
  }

  void check_quality(std::size_t t, const Verdict& verdict) {
    const QualityGuarantee& g = *c_.options.guarantee;
    at_min_ += verdict.min_angle == 0;
    at_max_ += verdict.max_angle == 0;
    at_ratio_ += verdict.ratio == 0;
    const auto find = [&](const char* check, const auto& what) {
      c_.reporter.find(check, {static_cast<std::int64_t>(t)}, [&] {
        return describe_tet(c_.mesh, t) + " has " + what(judge_.fine_measures(c_.mesh.tets[t]));
      });
    };
    if (verdict.min_angle > 0) {
      find("dihedral", [&](const FineMeasures& m) {
        return "a dihedral angle of " + full(m.min_deg) + " degrees, below " + brief(g.min_dihedral_deg);
      });
    }
    if (verdict.max_angle > 0) {
      find("dihedral", [&](const FineMeasures& m) {
        return "a dihedral angle of " + full(m.max_deg) + " degrees, above " + brief(g.max_dihedral_deg);
      });
    }
    if (verdict.ratio > 0) {
      find("radius-edge", [&](const FineMeasures& m) {
        return "radius-edge ratio " + full(m.ratio) + ", above " + full(g.max_radius_edge);
      });
    }
  }

  void check_delaunay(std::size_t t, const Candidate& candidate) {
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId e = beyond_[4 * t + i];
      if (e == kNoVertex) continue;
      ++facets_;
      const int side = judge_.in_sphere(candidate, e);
      cospherical_ += side == 0;
      if (side <= 0) continue;
      c_.reporter.find("delaunay", {static_cast<std::int64_t>(t), e}, [&] {
        return "vertex " + std::to_string(e) + " at " + full(c_.mesh.points[e]) +
               " of a neighbour is strictly inside the circumsphere of " + describe_tet(c_.mesh, t);
      });
    }
  }

  void conclude() {
    settle_extremes();
    report_orientation();
    report_quality();
    if (!beyond_.empty()) report_delaunay();
    VerifyReport& r = c_.reporter.report();
    r.exact_decisions += judge_.exact_decisions();
    r.filtered_decisions += judge_.filtered_decisions();
  }

  void settle_extremes() {
    if (measured_) {
      const auto fine = [&](std::size_t t) { return judge_.fine_measures(c_.mesh.tets[t]); };
      extremes_.add(fine(extremes_.min_tet));
      extremes_.add(fine(extremes_.max_tet));
      extremes_.add(fine(extremes_.ratio_tet));
    }
    VerifyReport& r = c_.reporter.report();
    r.volume = volume_.value() / 6 * sites_.unit() * sites_.unit() * sites_.unit();
    if (c_.mesh.tets.empty()) return;
    r.min_dihedral_deg = extremes_.fine.min_deg;
    r.max_dihedral_deg = extremes_.fine.max_deg;
    r.max_radius_edge = extremes_.fine.ratio;
  }

  void report_orientation() {
    const std::uint64_t wrong = c_.reporter.count("orientation");
    const std::string all = grouped(c_.mesh.tets.size());
    c_.reporter.line(wrong == 0
                         ? "orientation: " + all + " tetrahedra positive (exact)"
                         : "orientation: " + grouped(wrong) + " of " + all + " tetrahedra NOT positive");
    c_.reporter.line("volume: " + brief(c_.reporter.report().volume));
  }

  void report_quality() {
    const VerifyReport& r = c_.reporter.report();
    std::string angles =
        "dihedral angles: in [" + brief(r.min_dihedral_deg) + ", " + brief(r.max_dihedral_deg) + "] degrees";
    std::string ratio = std::isfinite(r.max_radius_edge)
                            ? "radius-edge ratio: at most " + brief(r.max_radius_edge)
                            : "radius-edge ratio: unbounded";
    const auto& g = c_.options.guarantee;
    if (g && (bounds_.min_angle || bounds_.max_angle)) angles += "; guarantee " + angles_of(*g);
    if (g && bounds_.ratio)
      ratio += "; guarantee " + brief(g->max_radius_edge) + " " + outcome("radius-edge") + ", attained by " +
               grouped(at_ratio_) + " tetrahedra";
    c_.reporter.line(angles);
    c_.reporter.line(ratio);
  }

  /// Only those that are bounds.
  std::string angles_of(const QualityGuarantee& g) const {
    std::string bounds, attained;
    if (bounds_.min_angle) bounds = "at least " + brief(g.min_dihedral_deg), attained = grouped(at_min_);
    if (bounds_.min_angle && bounds_.max_angle) bounds += " and ", attained += " and ";
    if (bounds_.max_angle) bounds += "at most " + brief(g.max_dihedral_deg), attained += grouped(at_max_);
    return bounds + " " + outcome("dihedral") + ", attained by " + attained + " tetrahedra";
  }

  std::string outcome(const char* check) const {
    const std::uint64_t wrong = c_.reporter.count(check);
    return wrong == 0 ? "holds (exact)" : "is VIOLATED " + grouped(wrong) + " times";
  }

  void report_delaunay() {
    const std::uint64_t wrong = c_.reporter.count("delaunay");
    const std::string verdict =
        wrong == 0 ? "locally Delaunay (exact)" : "checked, " + grouped(wrong) + " NOT locally Delaunay";
    c_.reporter.line("Delaunay: " + grouped(facets_) + " facets " + verdict + ", " + grouped(cospherical_) +
                     " ties");
  }

  const Context& c_;
  const Sites& sites_;
  const std::vector<VertexId>& beyond_;
  Bounds bounds_;
  Judge judge_;
  Sum volume_;
  Extremes extremes_;
  bool measured_ = false;
  std::uint64_t at_min_ = 0, at_max_ = 0, at_ratio_ = 0, facets_ = 0, cospherical_ = 0;
};

}  // namespace

void check_tetrahedra(const Context& context, const Sites& sites, const std::vector<VertexId>& beyond) {
  Pass(context, sites, beyond).run();
}

}  // namespace unsliver::verifier
