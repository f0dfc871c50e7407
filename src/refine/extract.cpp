#include "refine/extract.hpp"

namespace unsliver::refine {

namespace {

void copy_points(const Refinement& r, const Extraction& extraction, TetMesh& mesh) {
  mesh.points.resize(extraction.used);
  mesh.levels.resize(extraction.used);
  for (VertexId v = 1; v < extraction.number.size(); ++v) {
    const VertexId number = extraction.number[v];
    if (number == kNoVertex) continue;
    mesh.points[number] = r.output_position(v);
    mesh.levels[number] = static_cast<std::uint8_t>(r.label(v));
  }
  const auto& first_points = r.inputs().sites().first_point;
  if (first_points.empty()) return;
  mesh.point_source.assign(first_points.begin(), first_points.end());
  mesh.point_source.resize(mesh.points.size(), -1);
}

}  // namespace

Extraction::Extraction(Refinement& r) {
  for (TetId t = 0; t < r.mesh().slot_count(); ++t) {
    r.mesh().prefetch_ahead(t);
    if (r.mesh().is_finite(t) && r.meets_domain(t)) kept.push_back(t);
  }
  number.resize(r.mesh().vertex_count() + 1, kNoVertex);
  for (TetId t : kept)
    for (VertexId v : r.mesh().tet(t).v) number[v] = 0;
  used = static_cast<VertexId>(r.inputs().places().size());
  for (VertexId v = 1; v < number.size(); ++v)
    if (r.is_input(v))
      number[v] = r.site(v);
    else if (number[v] != kNoVertex)
      number[v] = used++;
}

bool want_dropped_proofs(Refinement& r, const Extraction& extraction) {
  bool any = false;
  for (VertexId v = 1; v < extraction.number.size(); ++v) {
    if (!r.is_relied_on(v) || extraction.number[v] != kNoVertex) continue;
    r.want(v);
    any = true;
  }
  return any;
}

TetMesh extract_superset(const Refinement& r, const Extraction& extraction) {
  TetMesh mesh;
  mesh.frame = r.world().frame();
  copy_points(r, extraction, mesh);
  mesh.tets.reserve(extraction.kept.size());
  const auto& number = extraction.number;
  for (TetId t : extraction.kept) {
    const auto& v = r.mesh().tet(t).v;
    mesh.tets.push_back({number[v[0]], number[v[1]], number[v[2]], number[v[3]]});
  }
  return mesh;
}

}  // namespace unsliver::refine
