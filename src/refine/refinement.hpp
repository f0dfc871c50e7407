/// \file
/// The state that Figures 5 and 8 work on: the tetrahedralization, the labels, the domain and the size seen
/// from the integer world.
///
/// All points, sizes and radii in here are in world units (lattice/world.hpp).
#pragma once

#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

#include "base/pod_vector.hpp"
#include "delaunay/triangulation.hpp"
#include "exact/quality_signs.hpp"
#include "geom/tetrahedron.hpp"
#include "lattice/level.hpp"
#include "lattice/world.hpp"
#include "refine/circumsphere.hpp"
#include "refine/inputs.hpp"
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

class Refinement {
 public:
  /// Starts from the corners of a huge lattice cube around the domain, which stand in for the paper's empty
  /// half-spaces, and from the input vertices.
  Refinement(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
             const MeshOptions& options, const Control& control);

  const delaunay::Triangulation& mesh() const { return mesh_; }
  delaunay::Triangulation& mesh() { return mesh_; }
  const lattice::World& world() const { return world_; }
  /// The domain's bounding box, in world units, not rounded to integers.
  const Box3& domain_box() const { return domain_box_; }
  const exact::QualityBounds& bounds() const { return bounds_; }
  Strategy strategy() const { return options_.strategy; }
  MeshStats& stats() { return stats_; }

  const Inputs& inputs() const { return inputs_; }
  bool is_input(VertexId v) const { return label(v) == kNoLabel; }
  /// The site of an input vertex.
  VertexId site(VertexId input) const { return site_of_vertex_[input - first_input_]; }
  /// How many sites lie outside the domain. Tetrahedra there count as meeting it.
  std::size_t outside_count() const { return outside_count_; }

  Level label(VertexId v) const { return notes_[v].label; }
  /// A certified upper bound of lfs(v): inequality (1) holds with it. Infinite for input vertices.
  double lfs_bound(VertexId v) const { return notes_[v].lfs_bound; }
  /// t's refinement vertex with the finest label; kNoVertex where all corners are input vertices.
  VertexId finest_corner(TetId t) const;

  /// A size proof rests on v: then v must be a vertex of the result, or the proof speaks of another mesh.
  void rely_on(VertexId v) { notes_[v].proofs |= kReliedOn; }
  bool is_relied_on(VertexId v) const { return (notes_[v].proofs & kReliedOn) != 0; }
  /// Tetrahedra at v count as meeting the domain from now on.
  void want(VertexId v) {
    notes_[v].proofs |= kWanted;
    any_wanted_ = true;
  }

  /// v in the caller's coordinates, as it is written: input vertices bit for bit.
  Vec3 output_position(VertexId v) const {
    return is_input(v) ? given_[inputs_.sites().first_point[site(v)]] : world_.to_caller(mesh_.point(v));
  }
  /// Could the interior of t, as it is written, meet the domain? No is certain.
  bool meets_domain(TetId t);
  bool contains(const Vec3& p) const { return domain_.contains(world_.to_caller(p)); }
  /// See Domain::clearance; asked once a vertex.
  double clearance(VertexId v);
  /// See Domain::side_of_ball.
  int side_of_ball(const Vec3& p, double radius) const {
    return domain_.side_of_ball(world_.to_caller(p), radius * (1 + 1e-12) * world_.unit());
  }
  /// See Domain::plainly_outside.
  bool plainly_outside(const Tet& world_tet) const { return domain_.plainly_outside(to_caller(world_tet)); }
  /// Dihedral angle or radius-edge ratio out of bounds, decided exactly.
  bool is_bad(TetId t) { return judge(t).is_bad; }
  exact::Judgement judge(TetId t) { return exact::judge(mesh_.corners(t), bounds_, quality_counts_); }
  void judge(std::span<const Tet> tets, std::span<exact::Judgement> judgements) {
    exact::judge(tets, bounds_, quality_counts_, judgements);
  }

  /// s at p, capped (an infinite size means: as coarse as the domain).
  double size_at(const Vec3& p) const;
  /// A lower bound of s over the part of the box inside the domain's bounds; infinity if there is none.
  double size_lower_bound(const Box3& box) const;
  /// s at p, or nothing where s need not be defined (outside the domain's bounds) or fails.
  std::optional<double> size_if_defined(const Vec3& p) const {
    return constant_size_ > 0 ? constant_size_ : varying_size_if_defined(p);
  }
  /// |s(p) - s(q)| <= lipschitz() |p - q| inside the domain's bounds; may be infinite.
  double lipschitz() const { return lipschitz_; }
  double largest_size() const { return size_cap_; }
  double smallest_size() const { return size_floor_; }

  /// The vertex nearest to the integer point p, which lies in tetrahedron t or not far from it.
  VertexId nearest_vertex(const Vec3& p, TetId t);

  /// Inserts lattice point w. `near` is a tetrahedron in conflict with w or not far from it.
  /// \throws Stopped when a cap is met or the run is cancelled (before the insertion).
  void insert(const Vec3& w, Level label, double lfs_bound, TetId near);
  /// The same where t is known to be in conflict with w, which is none of its corners.
  void insert_in_conflict(const Vec3& w, Level label, double lfs_bound, TetId t);
  std::span<const TetId> created() const { return mesh_.created(); }
  /// Asks for what is known of t's corners ahead of use.
  void prefetch_corners(TetId t) const {
    mesh_.prefetch_corners(t);
    for (const VertexId v : mesh_.tet(t).v) __builtin_prefetch(notes_.begin() + v);
  }

  /// Reports progress, and ends the run when a cap is met or the caller cancelled it. Called often by long
  /// searches. \throws Stopped
  void poll();

  /// Names the phase for progress reports and closes the timing of the one before, if it is another.
  void enter_phase(const char* name);
  void finish_phases();

 private:
  enum Proof : std::uint8_t { kReliedOn = 1, kWanted = 2 };
  /// What is known of a vertex, in one place: its tetrahedra ask for all of it, and it is in no cache.
  struct VertexNotes {
    float lfs_bound;
    float clearance;  ///< signed, see Domain::clearance; NaN = not asked yet
    std::uint8_t label;
    std::uint8_t proofs;  ///< of Proof
  };

  Refinement(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
             lattice::InputSites sites, const MeshOptions& options, const Control& control);
  Tet to_caller(const Tet& t) const;
  std::optional<double> varying_size_if_defined(const Vec3& p) const;
  void start_from_cube();
  void insert_inputs();
  bool lies_outside(VertexId site) const;
  bool has_outside_input(TetId t) const;
  bool has_wanted(TetId t) const;
  void add_notes(Level label, double lfs_bound);
  void report_progress();
  std::uint64_t bytes() const;

  const Domain& domain_;
  const Sizing& sizing_;
  const MeshOptions& options_;
  const Control& control_;
  lattice::World world_;
  Box3 caller_bounds_, domain_box_;
  double lipschitz_, constant_size_ = 0, size_cap_, size_floor_;
  exact::QualityBounds bounds_;
  std::span<const Vec3> given_;  ///< the caller's input vertices
  Inputs inputs_;
  VertexId first_input_ = 0;              ///< input vertices are numbered in a row from here
  std::vector<VertexId> site_of_vertex_;  ///< by vertex - first_input_
  std::vector<bool> outside_;             ///< by vertex - first_input_: not in the domain
  std::size_t outside_count_ = 0;

  delaunay::Triangulation mesh_;
  PodVector<VertexNotes> notes_;  ///< by vertex
  bool any_wanted_ = false;

  exact::StageCounts quality_counts_;
  MeshStats stats_;
  const char* phase_ = nullptr;
  std::chrono::steady_clock::time_point phase_start_, last_report_;
  std::uint64_t insertions_ = 0;
};

}  // namespace unsliver::refine
