#include "domain_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <set>

#include "files.hpp"
#include "formula_error.hpp"
#include "text.hpp"
#include "union_of_tets.hpp"
#include "unsliver/error.hpp"
#include "unsliver/hull.hpp"
#include "unsliver/io.hpp"
#include "unsliver/periodic.hpp"

namespace unsliver::cli {
namespace {

/// The axes, such as "x, z", along which `refused` holds of the lower and the upper coordinate.
template <typename Refused>
std::string axes_where(const Box3& box, Refused refused) {
  std::vector<char> axes;
  for (int axis = 0; axis < 3; ++axis)
    if (refused(box.lo[axis], box.hi[axis])) axes.push_back("xyz"[axis]);
  return fmt::format("{}", fmt::join(axes, ", "));
}

/// The lower corner comes first. \throws Error kBadOption that shows the box to type instead.
Box3 parse_box(const std::string& text, const std::string& option) {
  const auto n = parse_numbers(text, 6, option);
  const Box3 box{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  const std::string told = fmt::format("{} \"{}\": ", option, text);
  if (const std::string flat = axes_where(box, std::equal_to<>()); !flat.empty())
    throw Error(ErrorCode::kBadOption, told + "the box has no extent along " + flat);
  const std::string turned = axes_where(box, std::greater<>());
  if (turned.empty()) return box;
  Box3 meant;
  meant.extend(box.lo);
  meant.extend(box.hi);
  throw Error(ErrorCode::kBadOption,
              fmt::format("{}the first corner must be below the second, but it is above it along {}; "
                          "type {} \"{} {} {} {} {} {}\"",
                          told, turned, option, meant.lo.x, meant.lo.y, meant.lo.z, meant.hi.x, meant.hi.y,
                          meant.hi.z));
}

/// \throws Error kBadOption for a file that another command or option reads.
void check_is_surface(const std::string& path) {
  if (is_tet_mesh_file(path))
    throw Error(ErrorCode::kBadOption,
                fmt::format("{0}: this is a mesh, not a surface. `unsliver refine {0}` refines its slivers "
                            "away; --points {0} takes its vertices alone",
                            path));
  if (is_point_file(path))
    throw Error(ErrorCode::kBadOption,
                fmt::format("{0}: these are points, not a surface: say --points {0}", path));
}

void check_is_mesh(const std::string& path) {
  if (is_surface_file(path))
    throw Error(ErrorCode::kBadOption,
                fmt::format("{0}: this is a surface, not a mesh: say `unsliver mesh {0}`", path));
  if (is_point_file(path) && !is_tet_mesh_file(path))
    throw Error(ErrorCode::kBadOption,
                fmt::format("{0}: these are points, not a mesh: say `unsliver mesh --points {0}`", path));
}

DomainSource from_file(const std::string& path) {
  check_readable(path);
  check_is_surface(path);
  return source_of_surface(io::read_surface(path), path);
}

DomainSource from_ball(const std::string& text) {
  const auto n = parse_numbers(text, 4, "--ball");
  return {.kind = "ball", .label = "ball " + text, .domain = make_ball({n[0], n[1], n[2]}, n[3])};
}

DomainSource from_box(const DomainRequest& request) {
  const Box3 box = parse_box(*request.box, "--box");
  DomainSource source{.kind = "box", .label = "box " + *request.box, .domain = make_box(box)};
  if (request.periodic) source.label += ", periodic", source.periodic_cell = box;
  if (request.conform) source.label += ", filled exactly", source.exact_box = box;
  return source;
}

DomainSource from_formula(const std::string& formula, const Box3& bounds) {
  const auto make = [&](const std::string& text) { return make_implicit(text, bounds); };
  return {.kind = "implicit", .label = formula + " <= 0", .domain = of_formula("--implicit", formula, make)};
}

DomainSource from_points(const InputVertices& inputs) {
  DomainSource source{.kind = "points", .label = inputs.file};
  source.domain = make_box(box_with_volume(inputs.set.points, source.notes));
  return source;
}

TriangleMesh hull_of(const InputVertices& inputs) {
  try {
    return convex_hull(inputs.set.points);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kUnsupported) throw;
    throw Error(error.code(), fmt::format("{}: {}; without --hull their bounding box is meshed", inputs.file,
                                          error.what()));
  }
}

DomainSource from_hull(const InputVertices& inputs) {
  DomainSource source{.kind = "hull", .label = "convex hull of " + inputs.file, .surface = hull_of(inputs)};
  source.domain = make_surface(*source.surface);
  return source;
}

std::set<std::int32_t> regions_of(const TetMesh& mesh) { return {mesh.regions.begin(), mesh.regions.end()}; }

/// What a mesh has and its refinement does not keep, or what is odd about it.
std::vector<std::string> notes_on(const TetMesh& mesh, const QualitySummary& quality, std::size_t used) {
  std::vector<std::string> notes;
  if (used < mesh.points.size())
    notes.push_back(fmt::format("left out: {} of {}, in no tetrahedron",
                                with_separators(mesh.points.size() - used),
                                plural(mesh.points.size(), "vertex", "vertices")));
  if (quality.inverted + quality.flat > 0)
    notes.push_back(fmt::format("{} of {} {} inverted, {} flat", with_separators(quality.inverted),
                                plural(quality.tets, "tetrahedron", "tetrahedra"),
                                quality.tets == 1 ? "is" : "are", with_separators(quality.flat)));
  if (const std::size_t regions = regions_of(mesh).size(); regions > 1)
    notes.push_back(fmt::format("the result has no regions: the union of all {} is refined", regions));
  return notes;
}

InputVertices vertices_of(const std::string& path, const TetMesh& mesh) {
  InputVertices inputs{path, {}, used_vertices(mesh)};
  for (const VertexId v : inputs.ids) inputs.set.points.push_back(mesh.points[v]);
  if (inputs.ids.size() == mesh.points.size()) inputs.ids.clear();
  return inputs;
}

DomainSource from_tets(const std::string& path) {
  check_readable(path);
  check_is_mesh(path);
  return source_of_tets(io::read_tet_mesh(path), path);
}

DomainSource named_domain(const DomainRequest& request) {
  if (request.surface_file) return from_file(*request.surface_file);
  if (request.mesh_file) return from_tets(*request.mesh_file);
  if (request.ball) return from_ball(*request.ball);
  if (request.box) return from_box(request);
  return from_formula(*request.implicit, parse_box(*request.bounds, "--bounds"));
}

/// Of the ways to say where to mesh.
int count_named(const DomainRequest& r) {
  int count = 0;
  for (const auto* name : {&r.surface_file, &r.box, &r.ball, &r.implicit, &r.mesh_file})
    count += name->has_value();
  return count;
}

DomainSource domain_around(const InputVertices& inputs, const DomainRequest& request) {
  return count_named(request) > 0 ? named_domain(request) : source_around(inputs, request.hull);
}

void check_hull(const DomainRequest& request) {
  if (!request.hull) return;
  if (!request.points_file)
    throw Error(ErrorCode::kBadOption, "--hull meshes the convex hull of points: it needs --points FILE");
  if (count_named(request) > 0)
    throw Error(ErrorCode::kBadOption,
                "--hull says what to mesh, the convex hull of the points: leave it out, or the other domain");
}

/// Only cubes can be stacked so that all tetrahedra are good and the outside is flat.
void check_conform(const DomainRequest& request) {
  if (request.conform && !request.box)
    throw Error(ErrorCode::kBadOption, "--conform fills a box exactly: it needs --box \"x0 y0 z0 x1 y1 z1\"");
  if (request.conform && request.points_file)
    throw Error(
        ErrorCode::kBadOption,
        "--conform takes no --points: a box can be filled exactly with vertices of the lattice alone");
}

void check_periodic(const DomainRequest& request) {
  if (!request.periodic) return;
  if (!request.box)
    throw Error(ErrorCode::kBadOption, "--periodic meshes a cell: it needs --box \"x0 y0 z0 x1 y1 z1\"");
  if (request.conform)
    throw Error(ErrorCode::kBadOption,
                "--periodic and --conform contradict each other: a periodic mesh has no flat faces");
}

}  // namespace

void check_domain_request(const DomainRequest& request) {
  check_hull(request);
  const int count = count_named(request);
  if (count == 0 && !request.points_file)
    throw Error(ErrorCode::kBadOption,
                "nothing to mesh: give a surface file, --box, --ball, --implicit or --points");
  if (count > 1)
    throw Error(ErrorCode::kBadOption,
                fmt::format("{} inputs: give one of a surface file, --box, --ball and --implicit", count));
  if (request.implicit && !request.bounds)
    throw Error(ErrorCode::kBadOption, "--implicit needs --bounds \"x0 y0 z0 x1 y1 z1\": the box to look in");
  if (request.bounds && !request.implicit)
    throw Error(ErrorCode::kBadOption, "--bounds has no effect without --implicit");
  check_conform(request);
  check_periodic(request);
}

std::vector<std::string> all_notes(const DomainSource& source) {
  std::vector<std::string> notes = source.notes;
  const std::vector<std::string> more = source.domain->notes();
  notes.insert(notes.end(), more.begin(), more.end());
  return notes;
}

DomainSource source_of_surface(TriangleMesh surface, const std::string& label) {
  DomainSource source{.kind = "surface", .label = label, .surface = std::move(surface)};
  source.domain = make_surface(*source.surface);
  return source;
}

DomainSource source_of_tets(const TetMesh& mesh, const std::string& label) {
  DomainSource source{.kind = "tetrahedra", .label = label, .surface = boundary_surface(mesh)};
  source.surface->name = label;
  source.inputs = vertices_of(label, mesh);
  source.before = summarize_quality(mesh);
  source.notes = notes_on(mesh, *source.before, source.inputs->count());
  source.domain = make_surface(*source.surface);
  return source;
}

DomainSource source_around(const InputVertices& inputs, bool hull) {
  return hull ? from_hull(inputs) : from_points(inputs);
}

DomainSource make_domain(const DomainRequest& request) {
  if (!request.points_file) return named_domain(request);
  InputVertices inputs = read_input_vertices(*request.points_file);
  DomainSource source = domain_around(inputs, request);
  if (source.periodic_cell) inputs.set.points = points_in_cell(*source.periodic_cell, inputs.set.points);
  source.inputs = std::move(inputs);
  return source;
}

}  // namespace unsliver::cli
