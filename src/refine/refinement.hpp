/// \file
/// The state that Figures 5 and 8 work on: the labelled tetrahedralization, the domain and the size seen from
/// the integer world.
///
/// All points, sizes and radii in here are in world units (lattice/world.hpp).
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "geom/tetrahedron.hpp"
#include "lattice/world.hpp"
#include "refine/circumsphere.hpp"
#include "refine/inputs.hpp"
#include "refine/labelled_mesh.hpp"

namespace unsliver::refine {

class Refinement : public LabelledMesh<delaunay::Triangulation> {
 public:
  /// Starts from the corners of a huge lattice cube around the domain, which stand in for the paper's empty
  /// half-spaces, and from the input vertices.
  Refinement(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
             const MeshOptions& options, const Control& control);

  const lattice::World& world() const { return world_; }
  /// The domain's bounding box, in world units, not rounded to integers.
  const Box3& domain_box() const { return domain_box_; }

  const Inputs& inputs() const { return inputs_; }
  /// The site of an input vertex.
  VertexId site(VertexId input) const { return site_of_vertex_[input - first_input_]; }
  /// How many sites lie outside the domain. Tetrahedra there count as meeting it.
  std::size_t outside_count() const { return outside_count_; }

  /// A size proof rests on v: then v must be a vertex of the result, or the proof speaks of another mesh.
  void rely_on(VertexId v) { notes(v).proofs |= kReliedOn; }
  bool is_relied_on(VertexId v) const { return (notes(v).proofs & kReliedOn) != 0; }
  /// Tetrahedra at v count as meeting the domain from now on.
  void want(VertexId v) {
    notes(v).proofs |= kWanted;
    any_wanted_ = true;
  }

  /// Labels may be as coarse as this.
  static constexpr Level coarsest_level() { return lattice::kMaxLevel; }
  Vec3 to_caller(const Vec3& p) const { return world_.to_caller(p); }
  /// v in the caller's coordinates, as it is written: input vertices bit for bit.
  Vec3 output_position(VertexId v) const {
    return is_input(v) ? given_[inputs_.sites().first_point[site(v)]] : world_.to_caller(mesh_.point(v));
  }
  /// Could the interior of t, as it is written, meet the domain? No is certain.
  bool meets_domain(TetId t);
  bool contains(const Vec3& p) const { return domain_.contains(to_caller(p)); }
  /// See Domain::clearance; asked once a vertex.
  double clearance(VertexId v);
  /// See Domain::side_of_ball.
  int side_of_ball(const Vec3& p, double radius) const {
    return domain_.side_of_ball(world_.to_caller(p), radius * (1 + 1e-12) * world_.unit());
  }
  /// See Domain::plainly_outside.
  bool plainly_outside(const Tet& world_tet) const { return domain_.plainly_outside(to_caller(world_tet)); }

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

 private:
  enum Proof : std::uint8_t { kReliedOn = 1, kWanted = 2 };  ///< in VertexNotes

  Refinement(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
             lattice::InputSites sites, const MeshOptions& options, const Control& control);
  Tet to_caller(const Tet& t) const;
  std::optional<double> varying_size_if_defined(const Vec3& p) const;
  void start_from_cube();
  void insert_inputs();
  bool lies_outside(VertexId site) const;
  bool has_outside_input(TetId t) const;
  bool has_wanted(TetId t) const;

  const Domain& domain_;
  const Sizing& sizing_;
  lattice::World world_;
  Box3 caller_bounds_, domain_box_;
  double lipschitz_, constant_size_ = 0, size_cap_, size_floor_;
  std::span<const Vec3> given_;  ///< the caller's input vertices
  Inputs inputs_;
  VertexId first_input_ = 0;              ///< input vertices are numbered in a row from here
  std::vector<VertexId> site_of_vertex_;  ///< by vertex - first_input_
  std::vector<bool> outside_;             ///< by vertex - first_input_: not in the domain
  std::size_t outside_count_ = 0;

  bool any_wanted_ = false;
};

}  // namespace unsliver::refine
