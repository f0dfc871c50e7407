/// \file
/// Options of the generator, checked in the words of the command line. The Python package uses them too.
#pragma once

#include <optional>
#include <string>

#include "unsliver/refine.hpp"

namespace unsliver::cli {

/// \throws Error kBadOption unless the angles are among those that can be guaranteed.
void check_angles(const MeshOptions& mesh);

/// The bound to use, the least that is proven where none was typed. \throws Error kBadOption.
double radius_edge_bound(const std::optional<double>& typed, bool with_inputs);

/// What else bears on the choice of a strategy.
struct RunKind {
  bool keep_partial = false, has_inputs = false, conform = false;
};

/// An octree run without points that is ended early has no mesh to keep: then kAuto gives way to kThrifty.
/// \throws Error kBadOption for a name that is none, or a strategy that cannot do it.
Strategy strategy_of(const std::string& name, const RunKind& run);

}  // namespace unsliver::cli
