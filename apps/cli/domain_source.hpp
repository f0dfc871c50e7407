/// \file
/// From the command line to a domain.
#pragma once

#include <optional>
#include <string>

#include "unsliver/domain.hpp"

namespace unsliver::cli {

/// The ways to say where to mesh, as typed. Exactly one of the first four.
struct DomainRequest {
  std::optional<std::string> surface_file, box, ball, implicit;
  std::optional<std::string> bounds;  ///< with implicit, and only there
};

struct DomainSource {
  std::string kind;   ///< "surface", "box", "ball" or "implicit"
  std::string label;  ///< what the report calls the input: a file, "box 0 0 0 1 1 1", ...
  DomainPtr domain;
  std::optional<TriangleMesh> surface;
};

/// \throws Error kBadOption unless exactly one way was chosen.
void check_domain_request(const DomainRequest& request);

/// Reads and prepares the domain. \throws Error.
DomainSource make_domain(const DomainRequest& request);

}  // namespace unsliver::cli
