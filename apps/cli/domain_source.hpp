/// \file
/// From the command line to a domain, and to the points that are to be vertices of its mesh.
#pragma once

#include <optional>
#include <string>

#include "input_vertices.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/quality.hpp"

namespace unsliver::cli {

/// The ways to say where to mesh, as typed. One of the first five; none is needed beside points.
struct DomainRequest {
  std::optional<std::string> surface_file, box, ball, implicit;
  std::optional<std::string> mesh_file;    ///< tetrahedra: their union, and their vertices as points
  std::optional<std::string> bounds;       ///< with implicit, and only there
  std::optional<std::string> points_file;  ///< alone: their bounding box is meshed
  bool hull = false;                       ///< with points alone: not the box, the convex hull
  bool conform = false;                    ///< with box, and only there: fill it exactly
  bool periodic = false;                   ///< with box, and only there: its opposite faces are one

  bool has_inputs() const { return mesh_file || points_file; }
};

struct DomainSource {
  std::string kind;   ///< "surface", "box", "ball", "implicit", "points", "hull" or "tetrahedra"
  std::string label;  ///< what the report calls the input: a file, "box 0 0 0 1 1 1", ...
  DomainPtr domain = nullptr;
  std::optional<TriangleMesh> surface = std::nullopt;   ///< the boundary, where it is triangles
  std::optional<InputVertices> inputs = std::nullopt;   ///< what must be vertices of the mesh
  std::optional<Box3> exact_box = std::nullopt;         ///< to be filled exactly
  std::optional<Box3> periodic_cell = std::nullopt;     ///< a torus; inputs are in it
  std::optional<QualitySummary> before = std::nullopt;  ///< of the tetrahedra given
  std::vector<std::string> notes = {};                  ///< on how the domain was made of the input
};

/// The source's own and the domain's.
std::vector<std::string> all_notes(const DomainSource& source);

/// From geometry in memory; reports and messages call it `label`. \throws Error, as make_surface does.
DomainSource source_of_surface(TriangleMesh surface, const std::string& label);
/// The union of the tetrahedra, whose vertices become inputs.
DomainSource source_of_tets(const TetMesh& mesh, const std::string& label);
/// The bounding box or the convex hull of points, which it does not take as inputs yet.
DomainSource source_around(const InputVertices& inputs, bool hull);

/// \throws Error kBadOption unless exactly one way was chosen.
void check_domain_request(const DomainRequest& request);

/// Reads and prepares the domain. \throws Error.
DomainSource make_domain(const DomainRequest& request);

}  // namespace unsliver::cli
