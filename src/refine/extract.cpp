#include "refine/extract.hpp"

namespace unsliver::refine {

namespace {

PodVector<TetId> kept_tets(Refinement& r) {
  PodVector<TetId> kept;
  for (TetId t = 0; t < r.mesh().slot_count(); ++t) {
    r.mesh().prefetch_ahead(t);
    if (r.mesh().is_finite(t) && r.meets_domain(t)) kept.push_back(t);
  }
  return kept;
}

/// New index of each used vertex, kNoVertex for the rest; in order of insertion.
PodVector<VertexId> renumber(const Refinement& r, const PodVector<TetId>& kept, std::size_t& used) {
  PodVector<VertexId> index;
  index.resize(r.mesh().vertex_count() + 1, kNoVertex);
  for (TetId t : kept)
    for (VertexId v : r.mesh().tet(t).v) index[v] = 0;
  used = 0;
  for (VertexId& i : index)
    if (i != kNoVertex) i = static_cast<VertexId>(used++);
  return index;
}

}  // namespace

TetMesh extract_superset(Refinement& r) {
  const PodVector<TetId> kept = kept_tets(r);
  std::size_t used = 0;
  const PodVector<VertexId> index = renumber(r, kept, used);
  TetMesh mesh;
  mesh.frame = r.world().frame();
  mesh.points.reserve(used);
  mesh.levels.reserve(used);
  for (VertexId v = 1; v < index.size(); ++v) {
    if (index[v] == kNoVertex) continue;
    mesh.points.push_back(r.world().to_caller(r.mesh().point(v)));
    mesh.levels.push_back(static_cast<std::uint8_t>(r.label(v)));
  }
  mesh.tets.reserve(kept.size());
  for (TetId t : kept) {
    const auto& v = r.mesh().tet(t).v;
    mesh.tets.push_back({index[v[0]], index[v[1]], index[v[2]], index[v[3]]});
  }
  return mesh;
}

}  // namespace unsliver::refine
