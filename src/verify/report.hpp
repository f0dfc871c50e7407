/// \file
/// Collects findings and lines of a report; words for numbers, points and tetrahedra.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "unsliver/verify.hpp"

namespace unsliver::verifier {

class Reporter {
 public:
  /// Keeps a reference to `report`.
  Reporter(VerifyReport& report, std::size_t max_findings) : report_(report), max_findings_(max_findings) {}

  /// Counts a finding. `describe` is called only for the first max_findings of its check.
  void find(std::string_view check, std::vector<std::int64_t> ids,
            const std::function<std::string()>& describe);
  /// How many findings a check has had.
  std::uint64_t count(std::string_view check) const;
  void line(std::string text) { report_.checks.push_back(std::move(text)); }
  VerifyReport& report() { return report_; }

 private:
  VerifyReport& report_;
  std::size_t max_findings_;
  std::vector<std::pair<std::string, std::uint64_t>> counts_;
};

/// 1980000 as "1,980,000".
std::string grouped(std::uint64_t n);
/// Enough digits to read the same double back.
std::string full(double x);
std::string full(const Vec3& p);
/// Up to 12 significant digits, for measures.
std::string brief(double x);
/// "tetrahedron 7 (vertex 1 at (0, 0, 0), ...)". Requires: indices in range.
std::string describe_tet(const TetMesh& mesh, std::size_t t);

}  // namespace unsliver::verifier
