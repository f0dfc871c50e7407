/// \file
/// Figure 8 in the kernel, for input vertices among those of a forest: see figure_8_octree.hpp.
#pragma once

#include "refine/point_lookup.hpp"
#include "refine/queued.hpp"
#include "refine/refinement.hpp"
#include "refine/size_enforcement.hpp"
#include "refine/surroundings.hpp"

namespace unsliver::refine {

/// Notation: B, Q, removed and lifted vertices as in figure_8_octree.hpp. A *guest* is a vertex of Q.
class OctreeRefinement {
 public:
  /// The arguments must outlive this. Marks leaves, see gather_surroundings.
  OctreeRefinement(Refinement& refinement, octree::Forest& forest);

  /// --- In this order, each may throw Stopped:
  /// Puts the surroundings of the input vertices into the kernel.
  void lift_surroundings();
  /// Enforces size and quality where guests and removed vertices are.
  void refine();

  /// --- Then:
  /// The kernel's tetrahedra that are part of the mesh, ascending.
  const std::vector<TetId>& kept() const { return kept_; }
  bool is_guest(VertexId v) const { return notes_[v].is_guest; }
  VertexId home(VertexId guest) const { return notes_[guest].home; }
  const std::vector<BulkVertex>& removed() const { return surroundings_.removed; }
  /// The kernel's vertex at the place of one of the forest's; kNoVertex where none was lifted.
  VertexId lifted_at(const Vec3& p) const {
    const VertexId v = known_.find(p);
    return v == kRemoved ? kNoVertex : v;
  }
  /// The label of a vertex of B that was not lifted, `coarse` if it may be.
  Level label_of(const Vec3& p, Level coarse) const;

  std::uint64_t bytes() const;

 private:
  struct Note {
    VertexId home;  ///< the site of an input vertex nearby; kNoVertex for corners of the world
    bool is_guest;
  };
  static constexpr VertexId kRemoved = kNoVertex - 1;

  void lift(const Vec3& p, TetId near);
  void insert_lifted(const BulkVertex& v, TetId near);
  Level label_of(const BulkVertex& v) const;
  bool is_missing(const Vec3& p) const { return known_.find(p) == kNoVertex; }
  template <class Accept>
  std::optional<Vec3> nearest_missing(const Vec3& center, double radius, VertexId home,
                                      const Accept& accept) const;
  std::optional<Vec3> missing_in_conflict(const Tet& t, VertexId home) const;

  void push(TetId t) { fresh_.push_back(queued(r_, t)); }
  void push_all();
  void settle();
  void settle(const Queued& entry);
  void judge_fresh();
  void enforce_size(const EmptyBall& ball, TetId t);
  void note_guest(VertexId home);
  void enforce_quality_everywhere();

  void complete_star(const BulkVertex& removed);
  std::optional<Vec3> missing_in_star(const BulkVertex& removed) const;

  void choose();
  bool adopt_dropped_proofs();
  bool has_guest(TetId t) const;
  VertexId home_of(TetId t) const;

  Refinement& r_;
  octree::Forest& forest_;
  BulkPoints bulk_;
  EmptyBallSearch<Refinement> search_;
  Surroundings surroundings_;
  PointLookup known_;                    ///< of the forest's vertices: kRemoved, or the kernel's vertex
  std::vector<Note> notes_;              ///< by vertex of the kernel
  std::vector<Queued> fresh_, pending_;  ///< not judged yet; good, but not settled
  std::vector<Tet> corners_;             ///< scratch of judge_fresh, as the next
  std::vector<exact::Judgement> judgements_;
  RadiusQueue queue_;
  std::vector<TetId> kept_;
};

}  // namespace unsliver::refine
