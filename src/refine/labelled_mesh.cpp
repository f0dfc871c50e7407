#include "refine/labelled_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <string_view>

#include "refine/rounded.hpp"
#include "unsliver/error.hpp"

namespace unsliver::refine {

namespace {

constexpr std::uint64_t kCheckInterval = 64;

}  // namespace

template <class Kernel>
LabelledMesh<Kernel>::LabelledMesh(Kernel mesh, const exact::QualityBounds& bounds,
                                   const MeshOptions& options, const Control& control)
    : mesh_(std::move(mesh)), options_(options), control_(control), bounds_(bounds) {
  last_report_ = phase_start_ = std::chrono::steady_clock::now();
  add_notes(0, 0);  // the vertex at infinity
}

template <class Kernel>
void LabelledMesh<Kernel>::add_notes(Level label, double lfs_bound) {
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
  notes_.push_back({rounded_up(lfs_bound), kUnknown, static_cast<std::uint8_t>(label), 0});
}

template <class Kernel>
VertexId LabelledMesh<Kernel>::finest_corner(TetId t) const {
  VertexId finest = kNoVertex;
  for (const VertexId v : mesh_.tet(t).v)
    if (!is_input(v) && (finest == kNoVertex || label(v) < label(finest))) finest = v;
  return finest;
}

template <class Kernel>
auto LabelledMesh<Kernel>::nearest_vertex(const Vec3& p, TetId t) -> Nearest {
  Vec3 q = p;
  t = mesh_.walk_to(q, t);
  if (const VertexId there = mesh_.corner_at(t, q); there != kNoVertex) return {there, p};
  mesh_.carve(q, t);
  Nearest nearest{kNoVertex, {}};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh_.cavity().size(); ++i)
    for (const VertexId v : mesh_.tet(mesh_.cavity()[i]).v) {
      if (v == delaunay::kInfinite) continue;
      const Vec3 place = mesh_.position_in_cavity(i, v);
      if (const double d = dist_sq(q, place); d < least) least = d, nearest = {v, place + (p - q)};
    }
  mesh_.abandon();
  return nearest;
}

template <class Kernel>
void LabelledMesh<Kernel>::insert(const Vec3& w, Level label, double lfs_bound, TetId near) {
  Vec3 p = w;
  if (!mesh_.in_conflict(near, w)) near = mesh_.walk_to(p, near);
  if (mesh_.corner_at(near, p) != kNoVertex)
    throw Error(ErrorCode::kInternal,
                "a vertex was to be inserted twice: this is a bug in unsliver, please report it");
  insert_in_conflict(p, label, lfs_bound, near);
}

template <class Kernel>
void LabelledMesh<Kernel>::insert_in_conflict(const Vec3& w, Level label, double lfs_bound, TetId t) {
  assert(mesh_.in_conflict(t, w) && mesh_.corner_at(t, w) == kNoVertex);
  if (insertions_++ % kCheckInterval == 0) poll();
  mesh_.insert_in_conflict(w, t);
  add_notes(label, lfs_bound);
}

template <class Kernel>
void LabelledMesh<Kernel>::poll() {
  stats_.peak_bytes = std::max(stats_.peak_bytes, bytes());
  if (options_.max_tets != 0 && mesh_.tet_count() > options_.max_tets) throw Stopped{MeshStatus::kTetCap};
  if (options_.max_memory_bytes != 0 && stats_.peak_bytes > options_.max_memory_bytes)
    throw Stopped{MeshStatus::kMemoryCap};
  if (control_.cancelled && control_.cancelled()) throw Stopped{MeshStatus::kCancelled};
  report_progress();
}

template <class Kernel>
void LabelledMesh<Kernel>::report_progress() {
  if (!control_.on_progress) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_report_ < std::chrono::milliseconds(100)) return;
  last_report_ = now;
  Progress progress;
  progress.phase = phase_ != nullptr ? phase_ : "start";
  progress.vertices = mesh_.vertex_count();
  progress.tets = mesh_.tet_count();
  progress.done = mesh_.tet_count();
  control_.on_progress(progress);
}

template <class Kernel>
void LabelledMesh<Kernel>::enter_phase(const char* name) {
  if (phase_ != nullptr && std::string_view(phase_) == name) return;
  finish_phases();
  phase_ = name;
  phase_start_ = std::chrono::steady_clock::now();
}

template <class Kernel>
void LabelledMesh<Kernel>::finish_phases() {
  if (phase_ == nullptr) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - phase_start_;
  stats_.phases.push_back({phase_, elapsed.count()});
  phase_ = nullptr;
}

template class LabelledMesh<delaunay::Triangulation>;
template class LabelledMesh<delaunay::PeriodicTriangulation>;

}  // namespace unsliver::refine
