/// \file
/// The claims that the guarantees rest on, decided again by exact computation.
///
/// Each claim of Labelle's paper, or of docs/CLOSURE.md, whose proof has a finite part is enumerated in
/// integers and fractions, or enclosed by intervals with exact ends: no floating-point number decides
/// anything.
#pragma once

#include <string>
#include <vector>

namespace unsliver {

/// One statement of a claim against what was found.
struct ProofPart {
  std::string claimed;
  std::string found;
  bool holds = false;
  /// Where a difference that is known is explained, a file of docs/; empty elsewhere.
  std::string explained_in;

  bool is_as_recorded() const { return holds == explained_in.empty(); }
};

struct Claim {
  std::string id;         ///< "lemma-5"
  std::string source;     ///< "Lemma 5", "docs/CLOSURE.md (A)"
  std::string statement;  ///< in one sentence
};

struct Proof {
  Claim claim;
  std::vector<ProofPart> parts;
  double seconds = 0;

  bool holds() const;
  /// All parts hold but for the differences that the documents explain, and those are still there.
  bool is_as_recorded() const;
};

/// All claims, in the order in which they build on each other.
std::vector<Claim> provable_claims();

/// Decides one. \throws Error kBadOption if there is no such claim.
Proof decide_claim(const std::string& id);

}  // namespace unsliver
