/// \file
/// Meshes larger than memory: handed over piece by piece as they are made.
#pragma once

#include "unsliver/mesh_sink.hpp"
#include "unsliver/refine.hpp"

namespace unsliver {

struct StreamResult {
  MeshStatus status = MeshStatus::kDone;  ///< other than kDone: the sink has part of the mesh, or nothing
  std::uint64_t vertices = 0, tets = 0;   ///< of the whole mesh
  QualityLimits limits;                   ///< guaranteed where the status is kDone
  MeshStats stats;
};

/// The mesh that mesh_domain makes of the same arguments, array by array the same, into a sink. Memory: about
/// one byte a tetrahedron, and some megabytes for each thread. \throws Error as mesh_domain does, and
/// kBadOption where the strategy is not, or kAuto does not stand for, kOctree; what the sink throws.
StreamResult stream_domain(const Domain& domain, const Sizing& sizing, MeshSink& sink,
                           const MeshOptions& options = {}, const Control& control = {});

}  // namespace unsliver
