/// \file
/// Superset meshes from a balanced forest of octrees: no predicate at run time, no angle test, no repair.
///
/// The vertices are corners of leaves, and centres where the size or a hanging vertex asks for them. Balance
/// across faces and edges makes such a set closed under parents, and then each Delaunay tetrahedron has
/// dihedral angles in [30, 135] degrees and a radius-edge ratio of at most sqrt(5)/2 (docs/CLOSURE.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geom/point_tree.hpp"
#include "lattice/world.hpp"
#include "octree/box_lattice.hpp"
#include "octree/guest.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/mesh_sink.hpp"
#include "unsliver/progress.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver::octree {

struct OctreeOptions {
  unsigned threads = 1;         ///< the result does not depend on it
  std::uint64_t max_tets = 0;   ///< of the result; 0 = no cap
  std::uint64_t max_bytes = 0;  ///< held at the peak, result included; 0 = no cap
  bool all_centers = false;     ///< give every leaf its centre: more vertices, angles of the same range
};

enum class OctreeStatus { kDone, kTetCap, kMemoryCap, kCancelled };

struct OctreePhase {
  std::string name;
  double seconds = 0;  ///< wall time
};

struct OctreeStats {
  std::vector<OctreePhase> phases;  ///< "size", "balance", "choose", "number", "emit"
  std::uint64_t nodes = 0, balance_splits = 0;
  std::uint64_t leaves = 0;       ///< that may own kept tetrahedra
  std::uint64_t tested_tets = 0;  ///< asked for, one by one, whether they meet the domain
  std::uint64_t templates = 0;    ///< distinct neighbourhoods
  std::uint64_t domain_tests = 0, size_evaluations = 0;
  std::uint64_t vertices = 0;     ///< of the result
  std::uint64_t needed_tets = 0;  ///< of the result, known also where max_tets ended the run
  std::uint64_t peak_bytes = 0;   ///< held by the generator, result included
  double radius = 0;  ///< of the largest empty ball, in a box filled exactly with s constant; else 0
};

struct OctreeResult {
  OctreeStatus status = OctreeStatus::kDone;  ///< other than kDone: the mesh is empty
  TetMesh mesh;
  OctreeStats stats;
};

/// A superset mesh of the domain: the Delaunay tetrahedra, of the vertices that the forest gives, whose
/// interiors meet the domain.
///
/// Ensures (status kDone): the angles and the ratio named above; every closed ball B(p, s(p)), p in the
/// domain, holds a vertex of the mesh; the union covers the domain; labels are canonical levels; the
/// tetrahedra are those of delaunay::Triangulation on the same points, ties included. Deterministic.
/// \throws Error kBadOption (no thread), kBadInput (from the sizing function), kLimit (coordinate range, 2^31
/// nodes or vertices).
OctreeResult mesh_domain_octree(const Domain& domain, const Sizing& sizing, const OctreeOptions& options = {},
                                const Control& control = {});

/// The same piece by piece: the result's mesh is empty, its arrays go to the sink. \throws what that throws.
OctreeResult stream_domain_octree(const Domain& domain, const Sizing& sizing, MeshSink& sink,
                                  const OctreeOptions& options = {}, const Control& control = {});

/// Where vertices of others are (world), and who speaks for them.
struct GuestList {
  const geom::PointTree& places;
  Guest& guest;
};

/// The same in a given world and with a guest, who answers for the tetrahedra with vertices of his.
OctreeResult mesh_domain_octree(const Domain& domain, const Sizing& sizing, const lattice::World& world,
                                const OctreeOptions& options, const Control& control,
                                const GuestList& guests);

/// A mesh that fills a box exactly, its vertices those of a forest whose brick is the box.
///
/// Ensures (status kDone): all of the above; the union of the tetrahedra is the box, bit for bit; triangles
/// are the boundary's, outward, labelled 1 to 6: x low, x high, y low, y high, z low, z high.
/// \throws Error as above; kUnsupported and kLimit for a box that cubes do not fill, with the nearest one
/// that they do (octree/box_lattice.hpp).
OctreeResult mesh_box_octree(const Box3& box, const Sizing& sizing, const OctreeOptions& options = {},
                             const Control& control = {});

/// The torus that a box becomes when its opposite faces are one: a forest whose neighbours go on at the other
/// end. Points are at home, in the half-open cell, and tetrahedra name them whatever copies they mean. `s` is
/// asked in the cell, must not jump across its faces, and must be below a quarter of its shortest side.
/// Ensures and \throws as mesh_domain_octree, the lattice being one of lattices_of(cell).
OctreeResult mesh_torus_octree(const Box3& cell, const BoxLattice& lattice, const Sizing& sizing,
                               const OctreeOptions& options = {}, const Control& control = {});

}  // namespace unsliver::octree
