// The list of claims: what each says, and what decides it.
#include <algorithm>
#include <chrono>

#include "prove/cells.hpp"
#include "prove/closure.hpp"
#include "prove/closure_runs.hpp"
#include "prove/constants.hpp"
#include "prove/figure_8_runs.hpp"
#include "prove/lattices.hpp"
#include "prove/small_forest.hpp"
#include "prove/theorem_8.hpp"
#include "unsliver/error.hpp"
#include "unsliver/prove.hpp"

namespace unsliver {
namespace prover {
namespace {

struct Entry {
  Claim claim;
  Finding (*decide)();
};

/// In the order in which they build on each other.
const std::vector<Entry>& entries() {
  static const std::vector<Entry> list = {
      {{"nesting", "Proposition 2", "BCC_{k+1} < SC_k < BCC_k for all k."}, [] { return prove_nesting(); }},
      {{"lattice-lengths", "Proposition 4, section 3",
        "The shortest distances and covering radii of SC and BCC; the Delaunay tetrahedra of BCC have angles "
        "of 60 and 90 "
        "degrees."},
       [] { return prove_lattice_lengths(); }},
      {{"lemma-5", "Lemma 5, Figure 3",
        "A tetrahedron with corners in SC_k and a circumradius of r(BCC_{k+1}) or less has its angles in "
        "[30, 135]."},
       [] { return prove_lemma_5(); }},
      {{"lemma-6", "Lemma 6, Figure 4",
        "A tetrahedron with corners in BCC_k, a circumradius of r(SC_k) or less and an angle outside "
        "[35.264, 125.264] "
        "has a point of SC_k inside its circumsphere."},
       [] { return prove_lemma_6(); }},
      {{"closure-a", "docs/CLOSURE.md (A)",
        "A tetrahedron whose finest corner is in SC_k and has its parents is as Lemma 5 says."},
       [] { return prove_closure_a(); }},
      {{"closure-b", "docs/CLOSURE.md (B)",
        "A tetrahedron whose finest corner is in BCC_k only and has its parents has angles in [45, 120]."},
       [] { return prove_closure_b(); }},
      {{"closure-brick", "docs/CLOSURE.md, bricks",
        "The same where v is on the boundary of a brick and parents beyond it are missing."},
       [] { return prove_closure_brick(); }},
      {{"octree-keys", "docs/CLOSURE.md, Octrees",
        "In an octree balanced across faces and edges, with centres where vertices hang, all angles are in "
        "[30, 135]."},
       [] { return prove_octree_keys(); }},
      {{"counterexamples", "docs/CLOSURE.md, Octrees",
        "Without balance across edges, or without centres, there are angles outside [30, 135]."},
       [] { return prove_counterexamples(); }},
      {{"balanced-octree", "Section 4",
        "The Delaunay tetrahedralization of a balanced octree has angles in [19.471, 135] and ratios up to "
        "1.347."},
       [] { return prove_balanced_octree(); }},
      {{"theorem-8", "Theorem 8, Figure 6",
        "In SC_k with one input vertex p and without the points of R(p, k), p joins the hull of the box face "
        "vertices."},
       [] { return prove_theorem_8(); }},
      {{"table-1", "Theorem 8 and Corollary 9, Table 1, Figure 7",
        "The Delaunay tetrahedra there have angles in [30, 127.903] and ratios of at most 1.368."},
       [] { return prove_table_1(); }},
      {{"single-lattices", "Section 6",
        "With one lattice and its double alone the least angles would be about 17.023 (SC), 14.312 (BCC) and "
        "14.197 "
        "(FCC) degrees."},
       [] { return prove_single_lattices(); }},
      {{"grading-figure-5", "Section 4.2.4",
        "Figure 5: each vertex's nearest neighbour is at lfs/6.701 or more."},
       [] { return prove_grading_figure_5(); }},
      {{"size-step", "Section 4.2.1",
        "A vertex inserted for its size keeps inequality (1) for c = a/sqrt 3."},
       [] { return prove_size_step(); }},
      {{"grading-closure", "docs/GUARANTEES.md, Strategies",
        "Parent closure: each vertex's nearest neighbour is at lfs/4.15 or more."},
       [] { return prove_grading_closure(); }},
      {{"closure-runs", "docs/GUARANTEES.md, Strategies", "The same, measured on random graded sizes."},
       [] { return prove_closure_runs(); }},
      {{"grading-figure-8", "Section 5.2.6",
        "Figure 8: each vertex's nearest neighbour is at lfs/109.8 or more."},
       [] { return prove_grading_figure_8(); }},
      {{"figure-8-size-step", "Figure 8, size enforcement",
        "The size step keeps the invariant that no forbidden region holds an input vertex."},
       [] { return prove_figure_8_size_step(); }},
      {{"figure-8-runs", "Table 2, Lemmas 10 and 11, Corollary 9, section 5.2.5",
        "Distances in Figure 8, and the chain of parents, on runs with random input vertices."},
       [] { return prove_figure_8_runs(); }},
  };
  return list;
}

}  // namespace
}  // namespace prover

bool Proof::holds() const {
  return std::all_of(parts.begin(), parts.end(), [](const ProofPart& p) { return p.holds; });
}

bool Proof::is_as_recorded() const {
  return std::all_of(parts.begin(), parts.end(), [](const ProofPart& p) { return p.is_as_recorded(); });
}

std::vector<Claim> provable_claims() {
  std::vector<Claim> claims;
  for (const prover::Entry& entry : prover::entries()) claims.push_back(entry.claim);
  return claims;
}

Proof decide_claim(const std::string& id) {
  for (const prover::Entry& entry : prover::entries()) {
    if (entry.claim.id != id) continue;
    const auto start = std::chrono::steady_clock::now();
    Proof proof{entry.claim, entry.decide(), 0};
    proof.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return proof;
  }
  throw Error(ErrorCode::kBadOption, "there is no claim named '" + id + "'");
}

}  // namespace unsliver
