/// \file
/// From the command line to a sizing function.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "domain_source.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver::cli {

/// s / (mean edge length) of the Delaunay mesh of a BCC lattice. With cubes of side a a vertex has 6
/// neighbours at distance a and 8 at a sqrt(3)/2, so the mean edge is a (3 + 2 sqrt(3)) / 7; the largest
/// empty ball has radius a sqrt(5)/4, and that is s.
extern const double kSizePerEdge;

/// How fast sizes given at points grow away from them where nothing else is asked.
inline constexpr double kDefaultGradation = 0.3;

/// The ways to say how fine, as typed. Those given combine by minimum, sizes of input points among them.
struct SizeRequest {
  std::optional<std::string> size, edge_length;  ///< a number or a formula in x, y, z
  std::optional<std::string> size_mesh;          ///< a file of nodal values of s
  std::vector<SizingPtr> functions;              ///< the caller's own
  std::optional<double> gradation, size_max;
};

struct SizeSource {
  SizingPtr sizing;
  /// Nothing was asked: domain diagonal / 40, or nothing (s infinite) where there are input vertices.
  bool by_default = false;
  std::optional<double> constant;  ///< s, where it is the same everywhere and finite

  bool demands() const { return !by_default || constant; }
};

/// \throws Error kBadOption for numbers that are not positive.
void check_size_request(const SizeRequest& request);

/// \throws Error, kBadOption for options without effect among them.
SizeSource make_sizing(const SizeRequest& request, const DomainSource& source);

}  // namespace unsliver::cli
