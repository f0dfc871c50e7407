/// \file
/// The generator: Labelle's Figures 5 and 8 on a domain with a sizing function and, for Figure 8, input
/// vertices.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "unsliver/domain.hpp"
#include "unsliver/mesh.hpp"
#include "unsliver/progress.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {

enum class Strategy {
  kAuto,     ///< see choose_strategy
  kLiteral,  ///< the figure to the letter: SC for size, first point found, first in first out
  kThrifty,  ///< same guarantees, fewer vertices: both lattices, fitted unit, chosen candidates
  kOctree,   ///< closure under parents in place of Figure 5: no angle test, by far the fastest, but where s
             ///< varies its vertices are more. Input vertices must lie in the domain's box
  kClosure,  ///< size enforcement and closure under parents with the kernel: no angle test. No input vertices
};
const char* to_string(Strategy strategy);

struct MeshOptions {
  Strategy strategy = Strategy::kAuto;
  /// What counts as bad. Stricter than 30 / 135 / least_radius_edge() is refused: no theorem backs it.
  double min_dihedral_deg = 30;
  double max_dihedral_deg = 135;
  double max_radius_edge = 0;  ///< 0 = the least that is backed
  std::uint64_t max_tets =
      0;  ///< 0 = no cap. Tetrahedra held, outside ones included; checked every 64 insertions
  std::uint64_t max_memory_bytes = 0;  ///< 0 = no cap. Bytes held while refining; checked every 64 insertions
  unsigned threads =
      0;  ///< of kOctree, 0 = one for each core: the mesh does not depend on it. Others use one
};

/// The least radius-edge ratio that theorems back: sqrt(5)/2 (Figure 5), or 1.368 with input vertices (Figure
/// 8).
constexpr double least_radius_edge(bool with_input_vertices) {
  return with_input_vertices ? 1.368 : 1.118033988749895;
}

/// The subcases of Figure 8. Those that only lead on to the next case are counted too; 1.1.3 never happens.
enum class Subcase { k111, k112, k113, k121, k122, k123, k21, k22, k23, k3 };
inline constexpr std::array<const char*, 10> kSubcaseNames = {"1.1.1", "1.1.2", "1.1.3", "1.2.1", "1.2.2",
                                                              "1.2.3", "2.1",   "2.2",   "2.3",   "3"};

enum class MeshStatus { kDone, kTetCap, kMemoryCap, kCancelled };
const char* to_string(MeshStatus status);

struct PhaseTime {
  std::string name;
  double seconds = 0;
};

/// What happened, for reports. Counts are of events, seconds of wall time.
struct MeshStats {
  Strategy strategy = Strategy::kThrifty;  ///< the one used, never kAuto
  std::string strategy_reason;             ///< why, see choose_strategy
  unsigned threads = 1;
  std::vector<PhaseTime> phases;
  std::uint64_t size_insertions = 0, quality_insertions = 0;
  std::uint64_t lemma_6_insertions = 0;  ///< Case 2 of Figure 5 with a small circumradius
  std::array<std::uint64_t, kSubcaseNames.size()> figure_8{};  ///< by Subcase
  std::uint64_t candidates = 0;  ///< thrifty Figure 8: certified candidates inserted, no case needed
  std::uint64_t total_vertices = 0, total_tets = 0;  ///< before extraction
  std::uint64_t peak_bytes = 0;                      ///< held by the generator
  std::uint64_t insphere_filter = 0, insphere_small = 0, insphere_wide = 0, insphere_tie = 0;
  std::uint64_t orient_filter = 0, orient_small = 0, orient_wide = 0;
  std::uint64_t domain_tests = 0;
};

struct MeshResult {
  MeshStatus status = MeshStatus::kDone;  ///< other than kDone: a valid Delaunay superset mesh, guarantees
                                          ///< not reached; empty with kOctree and no points
  TetMesh mesh;
  MeshStats stats;
  std::vector<std::string> notes;  ///< on the input vertices: duplicates, points outside the domain
};

struct SizeEstimate {
  double vertices = 0, tets = 0;
  double bytes = 0;
  double ideal_vertices = 0;  ///< integral of 1 / (2.862 s^3) over the domain
};

/// From the integral of 1/s^3 over the domain, before anything is meshed; good to a factor of about 1.5.
SizeEstimate estimate_size(const Domain& domain, const Sizing& sizing, const MeshOptions& options);
/// The same with input vertices: they and what their bad Delaunay tetrahedra cost come on top; good to a
/// factor of about 2. Takes as long as tetrahedralizing them. \throws Error as mesh_domain does.
SizeEstimate estimate_size(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                           const MeshOptions& options);

/// A superset mesh of the domain: the Delaunay tetrahedra whose interiors meet it.
///
/// Ensures (status kDone): every tetrahedron has dihedral angles in [min, max] and radius-edge ratio at most
/// its bound; every closed ball B(p, s(p)), p in the domain, holds a vertex; the union covers the domain.
/// Deterministic. \throws Error kBadOption, kBadInput (from the sizing function), kLimit (coordinate range).
MeshResult mesh_domain(const Domain& domain, const Sizing& sizing, const MeshOptions& options = {},
                       const Control& control = {});

/// The same with input vertices: each of `inputs` (the caller's coordinates) is a vertex of the mesh, bit for
/// bit. The mesh's first points are the inputs in the caller's order, equal ones merged; point_source tells
/// which. Tetrahedra with an input vertex outside the domain are kept too.
/// \throws Error as above, and kBadInput where inputs are not finite or closer together than 1e-11 of the
/// extent.
MeshResult mesh_domain(const Domain& domain, const Sizing& sizing, std::span<const Vec3> inputs,
                       const MeshOptions& options = {}, const Control& control = {});

/// A mesh that fills a box exactly: its faces are flat, and all its tetrahedra are inside. By kOctree, which
/// is the only strategy that can.
///
/// Ensures (status kDone): what mesh_domain ensures, for every point of the box; the union of the tetrahedra
/// is the box, bit for bit; mesh.triangles are the boundary's, outward, labelled 1 to 6: x low, x high, y
/// low, y high, z low, z high. The sides leave the choice among few lattices: notes say how much finer than
/// asked a mesh of constant size is. The sides must be whole multiples of one length m * 2^e, m < 128, the
/// corners multiples of some m * 2^e. \throws Error kUnsupported for boxes that are not so, kLimit where it
/// takes more than 2^20 cubes of one side to fill the box: both name a box near it that will do, in the
/// message and as two places. And as mesh_domain does, kBadOption for other strategies among it.
MeshResult mesh_box(const Box3& box, const Sizing& sizing, const MeshOptions& options = {},
                    const Control& control = {});

/// What kAuto stands for: thrifty beside input vertices; else octree where s varies slowly or not at all,
/// thrifty where limits are relaxed, and closure.
struct StrategyChoice {
  Strategy strategy;   ///< never kAuto
  const char* reason;  ///< in a few words
};
StrategyChoice choose_strategy(const MeshOptions& options, const Sizing& sizing, bool with_input_vertices);

/// The grading guarantee of Theorem 7: each vertex v is at distance `share` * lfs(v) or more from its nearest
/// neighbour, lfs taken with the constant c of Definition 2.
struct GradingGuarantee {
  double c = 0;
  double largest_size = 1;  ///< sizes beyond this share of the domain's diagonal count as that
  double share = 0;         ///< 1 / 6.701 for Figure 5, 1 / 109.8 for Figure 8, 1 / 4.15 for closure; 0 for
                            ///< octrees: none is claimed
};
/// Requires: not kAuto.
GradingGuarantee grading_guarantee(Strategy strategy, bool with_input_vertices = false);

/// A sound lower bound of lfs_s(p) = inf over a in the domain of c s(a) + |pa|, from a lower bound and the
/// Lipschitz constant of s. 0 where s is not defined. The domain and the sizing function must outlive the
/// function.
std::function<double(const Vec3&)> lfs_lower_bound(const Domain& domain, const Sizing& sizing,
                                                   const GradingGuarantee& grading);
/// The smaller of that and lfs_i, the distance to the second nearest of the inputs (equal ones count as one).
std::function<double(const Vec3&)> lfs_lower_bound(const Domain& domain, const Sizing& sizing,
                                                   const GradingGuarantee& grading, std::vector<Vec3> inputs);

}  // namespace unsliver
