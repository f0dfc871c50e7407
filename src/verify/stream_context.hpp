/// \file
/// What every check of a streamed mesh is given.
#pragma once

#include <algorithm>
#include <vector>

#include "unsliver/verify_stream.hpp"
#include "verify/numbers.hpp"
#include "verify/pulse.hpp"
#include "verify/report.hpp"

namespace unsliver::verifier {

struct StreamContext {
  MeshSource& source;
  MeshHead head;
  const StreamVerifyOptions& options;
  StreamVerifyReport& report;
  Reporter& reporter;  ///< of that report
  Pulse& pulse;
};

/// How many vertices or tetrahedra are read at once.
inline constexpr std::uint64_t kChunk = std::uint64_t{1} << 16;

using TetChunk = std::vector<std::array<VertexId, 4>>;

/// Reads chunk number `chunk` of the tetrahedra, the last of which is shorter.
inline void read_chunk(const StreamContext& c, std::uint64_t chunk, TetChunk& tets) {
  const std::uint64_t first = chunk * kChunk;
  tets.resize(static_cast<std::size_t>(std::min(kChunk, c.head.tets - first)));
  c.source.read_tets(first, tets);
  c.pulse.beats(tets.size());
}

inline std::uint64_t chunk_count(std::uint64_t items) { return (items + kChunk - 1) / kChunk; }

}  // namespace unsliver::verifier
