#include "prove/constants.hpp"

#include <algorithm>

#include "prove/decimals.hpp"

namespace unsliver::prover {
namespace {

Enclosure thousandths(int n) { return Fraction{n, 1000}; }

Enclosure half(const Enclosure& x) { return x / Enclosure(2); }

Enclosure lesser(const Enclosure& x, const Enclosure& y) {
  return Enclosure::between(std::min(x.lo(), y.lo()), std::min(x.hi(), y.hi()));
}

/// Does x print as n / 1000, rounded or truncated?
ProofPart decimals_part(const std::string& name, int n, const Enclosure& x) {
  return part(fmt::format("{} = {}...", name, thousandths_text(n)), text(x),
              thousandths(n - 1).is_certainly_below(x) && x.is_certainly_below(thousandths(n + 1)));
}

/// Is x certainly below n / 1000?
ProofPart bound_part(const std::string& name, int n, const Enclosure& x) {
  return part(fmt::format("{} < {}", name, thousandths_text(n)), text(x),
              x.is_certainly_below(thousandths(n)));
}

ProofPart below_part(const std::string& claimed, const Enclosure& lesser, const Enclosure& greater) {
  return part(claimed, fmt::format("{} < {}", text(lesser), text(greater)),
              lesser.is_certainly_below(greater));
}

/// Numbers of the form x sqrt 2 + y sqrt 3 + z sqrt 5 with x, y, z in halves: equal if these are.
struct RootSum {
  int two, three, five;
  friend RootSum operator+(const RootSum& p, const RootSum& q) {
    return {p.two + q.two, p.three + q.three, p.five + q.five};
  }
  friend bool operator==(const RootSum&, const RootSum&) = default;
  Enclosure value(const Roots& r) const {
    return half(Enclosure(two) * r.root2 + Enclosure(three) * r.root3 + Enclosure(five) * r.root5);
  }
};

constexpr RootSum kFigure5A{0, 4, 2}, kFigure5B{0, 2, 2};
constexpr RootSum kClosureA{2, 2, 0}, kClosureB{2, 1, 0};

ProofPart equal_part(const std::string& claimed, const RootSum& left, const RootSum& right) {
  return part(claimed, left == right ? "equal, root by root" : "not equal", left == right);
}

/// Theorem 7: max(1 + a, 1 + 2 b / sqrt 3).
Enclosure theorem_7(const Enclosure& a, const Enclosure& b, const Roots& r) {
  const Enclosure x = Enclosure(1) + a, y = Enclosure(1) + Enclosure(2) * b / r.root3;
  return Enclosure::between(std::max(x.lo(), y.lo()), std::max(x.hi(), y.hi()));
}

/// The coarsest level of either lattice that fits is taken: s < r(BCC_{j+1}) for SC_j, s < r(SC_j) for BCC_j.
Enclosure two_lattice_c(const Enclosure& a, const Enclosure& b, const Roots& r) {
  return lesser((a - half(r.root3)) * Enclosure(2) / r.root5,
                (b - r.root5 / Enclosure(4)) * Enclosure(2) / r.root3);
}

}  // namespace

Figure8Constants::Figure8Constants(const Roots& r)
    : alpha((Enclosure(2) * r.root3 + Enclosure(4) * r.rho) *
                (Enclosure(2) * r.root3 + Enclosure(2) * r.rho) +
            Enclosure(3) * half(r.root3) + Enclosure(2) * r.rho),
      a(alpha + r.root5 + Enclosure(5) * r.root3 + Enclosure(5) * r.rho),
      b(half(a + r.root5)) {}

Finding prove_grading_figure_5(const GradingFigure5& claim) {
  const Roots r;
  constexpr RootSum kRoot5{0, 0, 2}, kRoot3{0, 2, 0};
  return {equal_part("type 1: a + sqrt 5 <= 2b", kFigure5A + kRoot5, kFigure5B + kFigure5B),
          equal_part("type 2: b + sqrt 3 <= a", kFigure5B + kRoot3, kFigure5A),
          bound_part("max(1 + a, 1 + 2b/sqrt 3)", claim.grading,
                     theorem_7(kFigure5A.value(r), kFigure5B.value(r), r))};
}

Finding prove_size_step(const SizeStep& claim) {
  const Roots r;
  const Enclosure a = kFigure5A.value(r), b = kFigure5B.value(r);
  // s(q) = 1.73 + |q - p| / c with p in the middle of a cube of SC_0, so that c s(q) varies as distance does:
  // lfs(w) = c 1.73 + |pw|. 1.73 < 2 r(SC_0), and each w of SC_0 is at least sqrt(3)/2 from p.
  const Enclosure paper_c = thousandths(claim.paper), lfs = paper_c * Fraction{173, 100} + half(r.root3);
  return {part(fmt::format("c = a/sqrt 3 = {}: lfs(w) <= 2^j a for each w inserted",
                           thousandths_text(claim.paper)),
               fmt::format("no: lfs(w) = {} > a = {} for s(q) = 1.73 + |q - p|/c, p in the middle of a cube",
                           text(lfs), text(a)),
               !a.is_certainly_below(lfs), kDifferences),
          decimals_part("w in SC_j within r(SC_j) of p: c = a/sqrt 3 - 1/2", claim.sc_only,
                        a / r.root3 - Fraction{1, 2}),
          decimals_part("w in the coarsest lattice that fits, SC or BCC: c", claim.both_lattices,
                        two_lattice_c(a, b, r))};
}

Finding prove_grading_figure_8(const GradingFigure8& claim) {
  const Roots r;
  const Figure8Constants k(r);
  const Enclosure ratio = Enclosure(1) + Enclosure(2) * k.b / r.sigma, neighbour = Enclosure(1) + k.a;
  return {decimals_part("alpha", claim.alpha, k.alpha),
          decimals_part("a", claim.a, k.a),
          decimals_part("b", claim.b, k.b),
          below_part("type 1.2: b + sqrt 3 <= a", k.b + r.root3, k.a),
          below_part("type 3, two inputs: 3 sqrt(3)/2 + 2 rho <= a",
                     Enclosure(3) * half(r.root3) + Enclosure(2) * r.rho, k.a),
          below_part("type 2, the chain's end: max(b + sqrt 3, alpha) = alpha", k.b + r.root3, k.alpha),
          below_part("type 2, another input: 2 sqrt 5 + 7 sqrt 3 + 7 rho <= a",
                     Enclosure(2) * r.root5 + Enclosure(7) * (r.root3 + r.rho), k.a),
          bound_part("1 + a", claim.grading, neighbour),
          bound_part("1 + 2b/sigma", claim.grading, ratio),
          decimals_part("the size step with an empty region: c = (alpha - sqrt(3)/2)/(sqrt 3 + 2 rho)",
                        claim.c, (k.alpha - half(r.root3)) / (r.root3 + Enclosure(2) * r.rho))};
}

Finding prove_grading_closure(const GradingClosure& claim) {
  const Roots r;
  constexpr RootSum kRoot2{2, 0, 0}, kHalfRoot3{0, 1, 0};
  const Enclosure a = kClosureA.value(r), b = kClosureB.value(r);
  return {
      equal_part("a parent sqrt(2) 2^k from SC_k: a + sqrt 2 <= 2b", kClosureA + kRoot2,
                 kClosureB + kClosureB),
      equal_part("a parent sqrt(3)/2 2^k from BCC_k: b + sqrt(3)/2 <= a", kClosureB + kHalfRoot3, kClosureA),
      bound_part("max(1 + a, 1 + 2b/sqrt 3)", claim.grading, theorem_7(a, b, r)),
      decimals_part("c", claim.c, two_lattice_c(a, b, r))};
}

Finding prove_figure_8_size_step(const Figure8SizeStep& claim) {
  const Point p{50, 50, 50};
  const auto length_sq = [](const Point& q) { return dot(q, q); };
  const std::int64_t size_sq = std::int64_t(claim.size) * claim.size;
  const Enclosure half_side = Enclosure(100) * Roots().sigma;
  int within = 0, blocked = 0;
  for (const Point& q : points_around_origin(3, [](const Point&) { return true; })) {
    const Point w = 100 * (q - Point{1, 1, 1});
    if (length_sq(w - p) > size_sq) continue;
    ++within;
    const Point d = claim.u - w;
    const std::int64_t distance = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    blocked += Enclosure(int(distance)).is_certainly_below(half_side);
  }
  const bool applies =
      length_sq(claim.u - p) > size_sq && 4 * size_sq > 3 * 100 * 100 && size_sq < 3 * 100 * 100;
  return {part(
      "around p = (1/2, 1/2, 1/2), s = 0.9, some point of SC_0 within s has no input vertex in its region",
      fmt::format(
          "none, with an input vertex at (-.05, -.05, -.05): B(p, s) is {}, {} points are within, {} have it "
          "in their regions",
          applies ? "empty" : "not empty", within, blocked),
      !applies || blocked < within, kDifferences)};
}

}  // namespace unsliver::prover
