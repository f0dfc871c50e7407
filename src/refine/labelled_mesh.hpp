/// \file
/// A tetrahedralization whose vertices carry labels and certificates, and all that happens to it: judged,
/// refined within the caps, reported on. What Figures 5 and 8 do to a domain and to a torus alike.
#pragma once

#include <chrono>
#include <span>

#include "base/pod_vector.hpp"
#include "delaunay/triangulation.hpp"
#include "exact/quality_signs.hpp"
#include "lattice/level.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::refine {

using delaunay::TetId;
using lattice::Level;

/// The run was ended early by a cap or by the caller; the mesh is valid as it is.
struct Stopped {
  MeshStatus status;
};

/// Input vertices have no label.
inline constexpr Level kNoLabel = lattice::kMinLevel - 1;

/// Kernel: delaunay::Triangulation or PeriodicTriangulation. Wherever a vertex is asked for, a corner of it
/// (delaunay/space.hpp) will do.
template <class Kernel>
class LabelledMesh {
 public:
  LabelledMesh(const LabelledMesh&) = delete;
  LabelledMesh& operator=(const LabelledMesh&) = delete;

  const Kernel& mesh() const { return mesh_; }
  Kernel& mesh() { return mesh_; }
  const exact::QualityBounds& bounds() const { return bounds_; }
  Strategy strategy() const { return options_.strategy; }
  MeshStats& stats() { return stats_; }

  bool is_input(VertexId v) const { return label(v) == kNoLabel; }
  Level label(VertexId v) const { return notes(v).label; }
  /// A certified upper bound of lfs(v): inequality (1) holds with it. Infinite for input vertices.
  double lfs_bound(VertexId v) const { return notes(v).lfs_bound; }
  /// t's refinement vertex with the finest label; kNoVertex where all corners are input vertices.
  VertexId finest_corner(TetId t) const;

  /// Dihedral angle or radius-edge ratio out of bounds, decided exactly.
  bool is_bad(TetId t) { return judge(t).is_bad; }
  exact::Judgement judge(TetId t) { return exact::judge(mesh_.corners(t), bounds_, quality_counts_); }
  void judge(std::span<const Tet> tets, std::span<exact::Judgement> judgements) {
    exact::judge(tets, bounds_, quality_counts_, judgements);
  }

  /// The vertex nearest to the integer point p, seen from the frame of tetrahedron t, in which p lies or from
  /// which it is not far.
  struct Nearest {
    VertexId v;
    Vec3 place;  ///< seen from that frame
  };
  Nearest nearest_vertex(const Vec3& p, TetId t);

  /// Inserts lattice point w. `near` is a tetrahedron in conflict with w or not far from it.
  /// \throws Stopped when a cap is met or the run is cancelled (before the insertion).
  void insert(const Vec3& w, Level label, double lfs_bound, TetId near);
  /// The same where t is known to be in conflict with w, which is none of its corners.
  void insert_in_conflict(const Vec3& w, Level label, double lfs_bound, TetId t);
  std::span<const TetId> created() const { return mesh_.created(); }
  /// Asks for what is known of t's corners ahead of use.
  void prefetch_corners(TetId t) const {
    mesh_.prefetch_corners(t);
    for (const VertexId v : mesh_.tet(t).v) __builtin_prefetch(&notes(v));
  }

  /// Reports progress, and ends the run when a cap is met or the caller cancelled it. Called often by long
  /// searches. \throws Stopped
  void poll();

  /// Names the phase for progress reports and closes the timing of the one before, if it is another.
  void enter_phase(const char* name);
  void finish_phases();

 protected:
  /// Options and control must outlive this.
  LabelledMesh(Kernel mesh, const exact::QualityBounds& bounds, const MeshOptions& options,
               const Control& control);
  ~LabelledMesh() = default;

  /// What is known of a vertex, in one place: its tetrahedra ask for all of it, and it is in no cache.
  struct VertexNotes {
    float lfs_bound;
    float clearance;  ///< signed, see Domain::clearance; NaN = not asked yet
    std::uint8_t label;
    std::uint8_t proofs;  ///< bits of Refinement's
  };
  VertexNotes& notes(VertexId v) { return notes_[Kernel::vertex_of(v)]; }
  const VertexNotes& notes(VertexId v) const { return notes_[Kernel::vertex_of(v)]; }
  /// To follow each insertion into the kernel.
  void add_notes(Level label, double lfs_bound);

  Kernel mesh_;
  const MeshOptions& options_;
  MeshStats stats_;

 private:
  void report_progress();
  std::uint64_t bytes() const { return mesh_.bytes() + notes_.bytes(); }

  const Control& control_;
  exact::QualityBounds bounds_;
  PodVector<VertexNotes> notes_;  ///< by vertex
  exact::StageCounts quality_counts_;
  const char* phase_ = nullptr;
  std::chrono::steady_clock::time_point phase_start_, last_report_;
  std::uint64_t insertions_ = 0;
};

extern template class LabelledMesh<delaunay::Triangulation>;
extern template class LabelledMesh<delaunay::PeriodicTriangulation>;

}  // namespace unsliver::refine
