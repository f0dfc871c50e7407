#include "verify/facets.hpp"

#include <algorithm>
#include <span>

namespace unsliver::verifier {
namespace {

/// A facet of a tetrahedron, its corners in cyclic order seen from outside, starting at the smallest, which
/// is implied by the bucket it lies in. The mate in a neighbour has `second` and `third` exchanged.
struct Half {
  VertexId second, third;
  std::uint32_t tet;

  VertexId low() const { return std::min(second, third); }
  VertexId high() const { return std::max(second, third); }
  std::uint64_t key() const { return std::uint64_t{low()} << 32 | high(); }
};

VertexId smallest_of_face(const std::array<VertexId, 4>& tet, int i) {
  return std::min({tet[kFace[i][0]], tet[kFace[i][1]], tet[kFace[i][2]]});
}

/// All halves, grouped by their smallest corner: halves[start[v]] to halves[start[v + 1]] are v's.
struct Buckets {
  std::vector<Half> halves;
  std::vector<std::size_t> start;
};

Buckets fill_buckets(const TetMesh& mesh, Pulse& pulse) {
  Buckets b;
  b.start.assign(mesh.points.size() + 2, 0);
  for (const auto& tet : mesh.tets) {
    for (int i = 0; i < 4; ++i) ++b.start[smallest_of_face(tet, i) + 2];
    pulse.beat();
  }
  for (std::size_t v = 2; v < b.start.size(); ++v) b.start[v] += b.start[v - 1];
  b.halves.resize(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (int i = 0; i < 4; ++i) {
      const Facet face = face_from_smallest(mesh.tets[t], i);
      b.halves[b.start[face[0] + 1]++] = {face[1], face[2], static_cast<std::uint32_t>(t)};
    }
    pulse.beat();
  }
  return b;
}

/// Matches the halves of one facet at a time.
class Matcher {
 public:
  Matcher(const TetMesh& mesh, Reporter* reporter) : mesh_(mesh), reporter_(reporter) {
    facets_.beyond.assign(4 * mesh.tets.size(), kNoVertex);
  }

  /// `group`: all halves of the facet (smallest, low, high), by tetrahedron.
  void match(VertexId smallest, std::span<const Half> group) {
    if (group.size() == 1) {
      facets_.boundary.push_back({smallest, group[0].second, group[0].third});
    } else if (group.size() == 2) {
      match_pair(smallest, group[0], group[1]);
    } else {
      blame(smallest, group, "belongs to " + std::to_string(group.size()) + " tetrahedra");
    }
  }

  Facets take() { return std::move(facets_); }

 private:
  VertexId opposite(VertexId smallest, const Half& h) const {
    const auto& v = mesh_.tets[h.tet];
    return v[0] ^ v[1] ^ v[2] ^ v[3] ^ smallest ^ h.second ^ h.third;
  }

  void match_pair(VertexId smallest, const Half& a, const Half& b) {
    const VertexId from = opposite(smallest, a), to = opposite(smallest, b);
    const Half both[2] = {a, b};
    if (from == to) return blame(smallest, both, "has the same tetrahedron behind it twice");
    if (a.second == b.second) return blame(smallest, both, "has two tetrahedra on the same side");
    const auto& v = mesh_.tets[a.tet];
    const auto corner = std::find(v.begin(), v.end(), from) - v.begin();
    facets_.beyond[4 * std::size_t{a.tet} + static_cast<std::size_t>(corner)] = to;
    ++facets_.interior;
  }

  void blame(VertexId smallest, std::span<const Half> group, const std::string& what) {
    if (reporter_ == nullptr) return;
    std::vector<std::int64_t> ids;
    for (const Half& h : group) ids.push_back(h.tet);
    reporter_->find("conformity", ids, [&] {
      std::string text = "facet " + std::to_string(smallest) + " " + std::to_string(group[0].low()) + " " +
                         std::to_string(group[0].high()) + " with its first corner at " +
                         full(mesh_.points[smallest]) + " " + what + ":";
      for (const std::int64_t t : ids) text += " " + std::to_string(t);
      return text;
    });
  }

  const TetMesh& mesh_;
  Reporter* reporter_;
  Facets facets_;
};

void sort_halves(std::span<Half> halves) {
  std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
    return a.key() != b.key() ? a.key() < b.key() : a.tet < b.tet;
  });
}

}  // namespace

Facets match_facets(const TetMesh& mesh, Reporter* reporter, Pulse& pulse) {
  Buckets buckets = fill_buckets(mesh, pulse);
  Matcher matcher(mesh, reporter);
  const std::span<Half> all(buckets.halves);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto bucket = all.subspan(buckets.start[v], buckets.start[v + 1] - buckets.start[v]);
    sort_halves(bucket);
    for (std::size_t i = 0, end = 0; i < bucket.size(); i = end) {
      while (end < bucket.size() && bucket[end].key() == bucket[i].key()) ++end;
      matcher.match(static_cast<VertexId>(v), bucket.subspan(i, end - i));
    }
    pulse.beat();
  }
  return matcher.take();
}

}  // namespace unsliver::verifier
