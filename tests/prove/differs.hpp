// Every claim must be able to fail: the same computation against other numbers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "prove/finding.hpp"

namespace unsliver::prover {

inline int count_of_differences(const Finding& finding) {
  return int(std::count_if(finding.begin(), finding.end(), [](const ProofPart& p) { return !p.holds; }));
}

inline void expect_as_recorded(const Finding& finding) {
  EXPECT_FALSE(finding.empty());
  for (const ProofPart& part : finding)
    EXPECT_TRUE(part.is_as_recorded()) << part.claimed << "\nfound: " << part.found;
}

/// As many parts differ as `expected`.
inline void expect_differences(int expected, const Finding& finding) {
  EXPECT_EQ(count_of_differences(finding), expected);
  if (count_of_differences(finding) == expected) return;
  for (const ProofPart& part : finding)
    ADD_FAILURE() << (part.holds ? "holds: " : "differs: ") << part.claimed << "\nfound: " << part.found;
}

}  // namespace unsliver::prover
