/// \file
/// Facets of a streamed mesh, matched a range of vertices at a time.
#pragma once

#include "verify/point_pages.hpp"

namespace unsliver::verifier {

/// Where the facets are by their smallest vertices: so that a range of those can be looked at without reading
/// all tetrahedra.
class FacetMap {
 public:
  explicit FacetMap(const StreamContext& context);

  /// Tetrahedra of the next chunk, in order. Requires: indices in range.
  void add_chunk(const TetChunk& tets);

  /// [first, last) of the smallest vertices of few enough facets to be held at once.
  struct Range {
    std::uint64_t first, last;
    std::uint64_t facets;  ///< each counted once for each of its tetrahedra
  };
  std::vector<Range> ranges() const;
  /// Has a chunk a facet in that range, perhaps?
  bool meets(std::uint64_t chunk, const Range& range) const;

 private:
  struct Extent {
    VertexId low, high;
  };
  std::vector<std::uint64_t> facets_;  ///< by block of vertices
  std::vector<Extent> chunks_;
};

struct FacetCounts {
  std::uint64_t interior = 0, boundary = 0;
  BigInt six_volumes = 0;  ///< enclosed by the facets in one tetrahedron, as in ShapeCensus
};

/// Findings "conformity": a facet in three tetrahedra or more, or in two on its same side; "cover": the
/// domain goes on beyond a facet in one.
FacetCounts match_stream_facets(const StreamContext& context, const FacetMap& map, PointPages& points);

}  // namespace unsliver::verifier
