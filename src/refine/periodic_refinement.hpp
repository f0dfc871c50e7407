/// \file
/// The state that Figures 5 and 8 work on in the paper's first reading: a periodic cell, in which nothing is
/// outside and every tetrahedron counts.
///
/// Notation. p = the shortest period; cap = the largest size: a bit less than p/4, so that no empty ball has
/// a diameter of half a period (delaunay/space.hpp), and than r(coarsest + 1), so that no label asks for a
/// lattice that the periods do not leave unchanged. The cell is brick.count cubes of side 2^K, so SC_K and
/// all finer lattices are unchanged, and SC_K is the coarsest.
///
/// Coordinates. World points are counted from the point of SC_K below the first input vertex: a problem that
/// is shifted by a vector of SC_K is the same problem in here, and gives the same mesh, shifted.
#pragma once

#include <memory>
#include <optional>

#include "octree/box_lattice.hpp"
#include "refine/circumsphere.hpp"
#include "refine/labelled_mesh.hpp"
#include "refine/periodic_inputs.hpp"
#include "sizing/periodic.hpp"

namespace unsliver::refine {

/// Where the torus lies in the caller's space.
class PeriodicWorld {
 public:
  /// `inputs`: the caller's points, from anywhere.
  PeriodicWorld(const Box3& cell, const octree::BoxLattice& lattice, std::span<const Vec3> inputs);

  const lattice::World& world() const { return lattice_.world; }
  const Box3& cell() const { return cell_; }
  delaunay::Torus torus() const { return delaunay::Torus(period()); }
  Vec3 period() const;
  const octree::BoxLattice& lattice() const { return lattice_; }
  Level coarsest_level() const { return 2 * lattice_.brick.exponent + 1; }
  /// The cap, in units.
  double largest_size() const;

  /// The caller's points, each at its copy in the cell.
  const std::vector<Vec3>& wrapped() const { return wrapped_; }
  /// A point of the caller's, at home.
  Vec3 home(const Vec3& x) const;
  /// From the coordinates in here to those of the frame, still anywhere.
  Vec3 in_frame(const Vec3& p) const { return p + shift_; }
  /// p's copy in the cell, in the caller's coordinates.
  Vec3 to_caller(const Vec3& p) const;

 private:
  void meet_moved(std::span<const Vec3> inputs);

  Box3 cell_;
  octree::BoxLattice lattice_;
  Vec3 shift_;  ///< a vector of the coarsest lattice
  std::vector<Vec3> wrapped_;
};

/// What Refinement is for domains.
class PeriodicRefinement : public LabelledMesh<delaunay::PeriodicTriangulation> {
 public:
  PeriodicRefinement(const PeriodicWorld& place, const Sizing& sizing, const MeshOptions& options,
                     const Control& control);

  const lattice::World& world() const { return place_.world(); }
  const PeriodicWorld& place() const { return place_; }
  const PeriodicInputs& inputs() const { return inputs_; }
  /// The site of an input vertex.
  VertexId site(VertexId input) const { return site_of_vertex_[input]; }
  /// Labels may be as coarse as this.
  Level coarsest_level() const { return place_.coarsest_level(); }
  Vec3 to_caller(const Vec3& p) const { return place_.to_caller(p); }

  /// --- Nothing is outside.
  static Box3 domain_box();
  static bool meets_domain(TetId) { return true; }
  static bool contains(const Vec3&) { return true; }
  static double clearance(VertexId) { return -std::numeric_limits<double>::infinity(); }
  static int side_of_ball(const Vec3&, double) { return -1; }
  static bool plainly_outside(const Tet&) { return false; }
  static void rely_on(VertexId) {}

  double size_at(const Vec3& p) const;
  double size_lower_bound(const Box3& box) const;
  std::optional<double> size_if_defined(const Vec3& p) const {
    return constant_size_ > 0 ? constant_size_ : size_at(p);
  }
  double lipschitz() const { return sizing_.lipschitz(); }
  double largest_size() const { return size_cap_; }
  double smallest_size() const { return size_floor_; }

  /// What there is before the first step: points of one lattice, and input vertices.
  struct Start {
    delaunay::PeriodicTriangulation mesh;
    Level level;
  };

 private:
  PeriodicRefinement(const PeriodicWorld& place, const Sizing& sizing, PeriodicInputs inputs,
                     const MeshOptions& options, const Control& control);
  PeriodicRefinement(const PeriodicWorld& place, const Sizing& sizing, Start start, PeriodicInputs inputs,
                     const MeshOptions& options, const Control& control);
  void insert_inputs();
  void label_vertices(Level level);

  PeriodicWorld place_;
  sizing::Periodic sizing_;
  PeriodicInputs inputs_;
  double size_cap_, size_floor_, constant_size_ = 0;
  std::vector<VertexId> site_of_vertex_;  ///< of the vertices before refinement; kNoVertex where none
};

}  // namespace unsliver::refine
