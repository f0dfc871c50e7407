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

/// The mesh's vertices: new index of each vertex of the kernel, kNoVertex for those that are not used.
struct Numbering {
  Numbering(const Refinement& r, const PodVector<TetId>& kept) {
    index.resize(r.mesh().vertex_count() + 1, kNoVertex);
    for (TetId t : kept)
      for (VertexId v : r.mesh().tet(t).v) index[v] = 0;
    used = static_cast<VertexId>(r.inputs().places().size());
    for (VertexId v = 1; v < index.size(); ++v)
      if (r.is_input(v))
        index[v] = r.site(v);
      else if (index[v] != kNoVertex)
        index[v] = used++;
  }
  PodVector<VertexId> index;
  VertexId used;
};

void copy_points(const Refinement& r, const Numbering& numbering, TetMesh& mesh) {
  mesh.points.resize(numbering.used);
  mesh.levels.resize(numbering.used);
  for (VertexId v = 1; v < numbering.index.size(); ++v) {
    if (numbering.index[v] == kNoVertex) continue;
    mesh.points[numbering.index[v]] = r.output_position(v);
    mesh.levels[numbering.index[v]] = static_cast<std::uint8_t>(r.label(v));
  }
  const auto& first_points = r.inputs().sites().first_point;
  if (first_points.empty()) return;
  mesh.point_source.assign(first_points.begin(), first_points.end());
  mesh.point_source.resize(mesh.points.size(), -1);
}

}  // namespace

bool want_dropped_proofs(Refinement& r) {
  const PodVector<TetId> kept = kept_tets(r);
  const Numbering numbering(r, kept);
  bool any = false;
  for (VertexId v = 1; v < numbering.index.size(); ++v) {
    if (!r.is_relied_on(v) || numbering.index[v] != kNoVertex) continue;
    r.want(v);
    any = true;
  }
  return any;
}

TetMesh extract_superset(Refinement& r) {
  const PodVector<TetId> kept = kept_tets(r);
  const Numbering numbering(r, kept);
  TetMesh mesh;
  mesh.frame = r.world().frame();
  copy_points(r, numbering, mesh);
  mesh.tets.reserve(kept.size());
  const auto& index = numbering.index;
  for (TetId t : kept) {
    const auto& v = r.mesh().tet(t).v;
    mesh.tets.push_back({index[v[0]], index[v[1]], index[v[2]], index[v[3]]});
  }
  return mesh;
}

}  // namespace unsliver::refine
