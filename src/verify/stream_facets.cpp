#include "verify/stream_facets.hpp"

#include <numeric>

#include "verify/holes.hpp"
#include "verify/shape.hpp"

namespace unsliver::verifier {
namespace {

constexpr std::uint64_t kBlock = 1024;                           // vertices
constexpr std::uint64_t kMostInMemory = std::uint64_t{1} << 22;  // facets, 24 bytes each; vertices

/// Corners in cyclic order seen from outside, the smallest first.
struct Half {
  VertexId smallest, second, third;

  VertexId low() const { return std::min(second, third); }
  Facet facet() const { return {smallest, second, third}; }
  std::uint64_t key() const { return std::uint64_t{low()} << 32 | std::max(second, third); }
};

/// Calls visit(half) for the four facets.
template <class Visit>
void for_each_half(const std::array<VertexId, 4>& tet, const Visit& visit) {
  for (int i = 0; i < 4; ++i) {
    const Facet f = face_from_smallest(tet, i);
    visit(Half{f[0], f[1], f[2]});
  }
}

class Matcher {
 public:
  Matcher(const StreamContext& context, PointPages& points)
      : c_(context), points_(points), origin_(points[0]) {}

  /// Requires: their smallest vertices are in the range.
  void match(const FacetMap::Range& range, const std::vector<Half>& halves) {
    bucket(range, halves);
    for (std::size_t v = 0, start = 0; v < end_.size(); start = end_[v++])
      match_bucket({sorted_.data() + start, end_[v] - start});
  }

  FacetCounts counts() const { return counts_; }

 private:
  /// Sorts by the smallest vertex: those of vertex range.first + v end before end_[v].
  void bucket(const FacetMap::Range& range, const std::vector<Half>& halves) {
    std::vector<std::uint32_t> next(static_cast<std::size_t>(range.last - range.first) + 1);
    for (const Half& h : halves) ++next[h.smallest - range.first + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    end_.assign(next.begin() + 1, next.end());
    sorted_.resize(halves.size());
    for (const Half& h : halves) sorted_[next[h.smallest - range.first]++] = h;
  }

  void match_bucket(std::span<Half> halves) {
    std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) { return a.key() < b.key(); });
    for (std::size_t i = 0, end = 0; i < halves.size(); i = end) {
      while (end < halves.size() && halves[end].key() == halves[i].key()) ++end;
      match_facet(halves.subspan(i, end - i));
    }
  }

  void match_facet(std::span<const Half> group) {
    if (group.size() == 1) {
      ++counts_.boundary;
      counts_.six_volumes += cone(group[0]);
      if (c_.options.inside) check_cover(group[0]);
    } else if (group.size() > 2) {
      find(group[0], "belongs to " + std::to_string(group.size()) + " tetrahedra");
    } else if (group[0].second == group[1].second) {
      find(group[0], "has two tetrahedra on the same side");
    } else {
      ++counts_.interior;
    }
  }

  /// The caller's coordinates.
  Vec3 point(VertexId v) {
    const auto q = points_[v];
    return c_.head.frame.origin + c_.head.frame.unit * Vec3{double(q[0]), double(q[1]), double(q[2])};
  }

  void check_cover(const Half& h) {
    const auto beyond = points_beyond({point(h.smallest), point(h.second), point(h.third)});
    const auto p =
        std::find_if(beyond.begin(), beyond.end(), [&](const Vec3& q) { return c_.options.inside(q); });
    if (p != beyond.end()) find_hole(c_.reporter, h.facet(), *p);
  }

  /// Six times the volume between the facet and some one point.
  BigInt cone(const Half& h) {
    std::array<Row<BigInt>, 3> rows;
    const std::array<VertexId, 3> corners{h.smallest, h.second, h.third};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto q = points_[corners[i]];
      for (std::size_t axis = 0; axis < 3; ++axis) rows[i][axis] = q[axis] - origin_[axis];
    }
    return dot(rows[0], cross(rows[1], rows[2]));
  }

  void find(const Half& h, const std::string& fault) {
    c_.reporter.find("conformity", {h.smallest, h.second, h.third},
                     [&] { return name_of(h.facet()) + " " + fault; });
  }

  const StreamContext& c_;
  PointPages& points_;
  Row<std::int64_t> origin_;
  std::vector<Half> sorted_;
  std::vector<std::uint32_t> end_;
  FacetCounts counts_;
};

void find_crowd(const StreamContext& c, const FacetMap::Range& range) {
  c.reporter.find("conformity", {}, [&] {
    return "the vertices " + std::to_string(range.first) + " to " + std::to_string(range.last - 1) +
           " are the smallest of " + grouped(range.facets) + " facets, more than can be held to be matched";
  });
}

}  // namespace

FacetMap::FacetMap(const StreamContext& context)
    : facets_(static_cast<std::size_t>(context.head.vertices / kBlock + 1)) {}

void FacetMap::add_chunk(const TetChunk& tets) {
  Extent extent{kNoVertex, 0};
  for (const auto& tet : tets)
    for_each_half(tet, [&](const Half& half) {
      ++facets_[half.smallest / kBlock];
      extent = {std::min(extent.low, half.smallest), std::max(extent.high, half.smallest)};
    });
  chunks_.push_back(extent);
}

std::vector<FacetMap::Range> FacetMap::ranges() const {
  std::vector<Range> ranges;
  for (std::uint64_t block = 0; block < facets_.size(); ++block) {
    const std::uint64_t more = facets_[block];
    if (ranges.empty() || ranges.back().facets + more > kMostInMemory ||
        ranges.back().last - ranges.back().first >= kMostInMemory)
      ranges.push_back({block * kBlock, block * kBlock, 0});
    ranges.back().last = (block + 1) * kBlock;
    ranges.back().facets += more;
  }
  return ranges;
}

bool FacetMap::meets(std::uint64_t chunk, const Range& range) const {
  return chunks_[chunk].low < range.last && chunks_[chunk].high >= range.first;
}

FacetCounts match_stream_facets(const StreamContext& c, const FacetMap& map, PointPages& points) {
  Matcher matcher(c, points);
  std::vector<Half> halves;
  TetChunk tets;
  for (const FacetMap::Range& range : map.ranges()) {
    if (range.facets > kMostInMemory) {
      find_crowd(c, range);
      continue;
    }
    halves.clear();
    halves.reserve(range.facets);
    for (std::uint64_t chunk = 0; chunk < chunk_count(c.head.tets); ++chunk) {
      if (!map.meets(chunk, range)) continue;
      read_chunk(c, chunk, tets);
      for (const auto& tet : tets)
        for_each_half(tet, [&](const Half& half) {
          if (range.first <= half.smallest && half.smallest < range.last) halves.push_back(half);
        });
    }
    matcher.match(range, halves);
  }
  return matcher.counts();
}

}  // namespace unsliver::verifier
