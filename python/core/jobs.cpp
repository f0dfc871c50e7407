#include "jobs.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include "arrays.hpp"
#include "callbacks.hpp"
#include "check_mesh.hpp"
#include "errors.hpp"
#include "generator_options.hpp"
#include "geometry.hpp"
#include "mesh_job.hpp"
#include "unsliver/embed.hpp"
#include "unsliver/quality.hpp"

namespace unsliver::python {
namespace {

using cli::MeshReport;

/// Everything else that `mesh` and `refine` are asked, from their keyword arguments.
struct Request {
  MeshOptions options;
  cli::SizeRequest size;
  std::optional<cli::InputVertices> inputs;
  bool keep_partial = false, verify = true;
};

template <typename Value>
Value get(const py::dict& keywords, const char* name) {
  return keywords[name].cast<Value>();
}

MeshOptions options_of(const py::dict& keywords, const cli::RunKind& kind) {
  MeshOptions options;
  options.strategy = cli::strategy_of(get<std::string>(keywords, "strategy"), kind);
  options.min_dihedral_deg = get<double>(keywords, "min_angle");
  options.max_dihedral_deg = get<double>(keywords, "max_angle");
  cli::check_angles(options);
  options.max_radius_edge =
      cli::radius_edge_bound(get<std::optional<double>>(keywords, "max_radius_edge"), kind.has_inputs);
  options.max_tets = get<std::optional<std::uint64_t>>(keywords, "max_tets").value_or(0);
  options.max_memory_bytes = get<std::optional<std::uint64_t>>(keywords, "max_memory").value_or(0);
  options.threads = get<std::optional<unsigned>>(keywords, "threads").value_or(0);
  return options;
}

cli::SizeRequest size_of(const py::dict& keywords) {
  cli::SizeRequest size;
  size.size = get<std::optional<std::string>>(keywords, "size");
  size.edge_length = get<std::optional<std::string>>(keywords, "edge_length");
  for (const py::handle function : keywords["sizings"])
    size.functions.push_back(function.cast<const SizeObject&>().sizing);
  size.gradation = get<std::optional<double>>(keywords, "size_gradation");
  size.size_max = get<std::optional<double>>(keywords, "size_max");
  cli::check_size_request(size);
  return size;
}

std::optional<cli::InputVertices> inputs_of(const py::dict& keywords) {
  const py::object points = keywords["points"], sizes = keywords["point_sizes"];
  if (points.is_none()) return std::nullopt;
  cli::InputVertices inputs{"points", {to_points(points, "points"), {}, {}}, {}};
  if (!sizes.is_none()) inputs.set.sizes = to_numbers(sizes, "point_sizes", inputs.count());
  return inputs;
}

Request request_of(const DomainObject& domain, const py::dict& keywords) {
  Request request;
  request.inputs = inputs_of(keywords);
  if (request.inputs && domain.source.exact_box)
    throw Error(
        ErrorCode::kBadOption,
        "a box that is filled exactly (conform) takes no points: its vertices are the lattice's alone");
  request.size = size_of(keywords);
  request.keep_partial = get<bool>(keywords, "keep_partial");
  request.options = options_of(keywords, {.keep_partial = request.keep_partial,
                                          .has_inputs = request.inputs || domain.source.inputs,
                                          .conform = domain.source.exact_box.has_value()});
  request.verify = get<bool>(keywords, "verify");
  return request;
}

/// As `unsliver mesh` goes about it, without the files. The mesh is empty where the run was cancelled and
/// nothing is to be kept.
TetMesh run(MeshReport& report, const Request& request, Callbacks& callbacks) {
  const Control control = callbacks.control();
  add_options(report, request.options);
  plan_mesh(report, request.size);
  if (!request.keep_partial) check_estimate(report, request.options);
  MeshResult result = make_mesh(report, control);
  add_outcome(report, result.status, result.stats);
  if (result.status == MeshStatus::kCancelled && !request.keep_partial) return {};
  add_counts(report, result.mesh);
  report.quality = summarize_quality(result.mesh);
  if (request.verify && report.counts->tets > 0 && !callbacks.stopped()) {
    judge_mesh(report, result, control);
    conclude(report, callbacks.stopped());
  }
  if (report.source->inputs) restore_ids(*report.source->inputs, result.mesh);
  return std::move(result.mesh);
}

/// (arrays of the mesh, report as JSON).
py::tuple mesh(const std::string& command, const DomainObject& domain, const py::dict& keywords) {
  MeshReport report;
  const Request request = request_of(domain, keywords);
  report.command = command;
  report.source = domain.source;
  if (request.inputs) report.source->inputs = request.inputs;
  Callbacks callbacks(keywords["on_progress"], keywords["cancelled"]);
  TetMesh made;
  {
    const py::gil_scoped_release unlocked;
    made = run(report, request, callbacks);
  }
  callbacks.rethrow();
  return py::make_tuple(from_tet_mesh(std::move(made)), with_keywords(to_json(report).dump()));
}

std::string check(const py::handle& mesh, const py::object& against, const cli::CheckDemands& demands,
                  py::object on_progress, py::object cancelled) {
  cli::check_demands(demands);
  const TetMesh tets = to_tet_mesh(mesh);
  std::optional<TriangleMesh> surface;
  if (!against.is_none()) surface = to_surface(against);
  Callbacks callbacks(std::move(on_progress), std::move(cancelled));
  cli::CheckReport report;
  {
    const py::gil_scoped_release unlocked;
    report = check_mesh(tets, surface ? &*surface : nullptr, demands, callbacks.control());
  }
  callbacks.rethrow();
  return to_json(report).dump();
}

std::string quality(const py::handle& mesh, std::size_t worst) {
  const TetMesh tets = to_tet_mesh(mesh);
  const py::gil_scoped_release unlocked;
  return cli::to_json(summarize_quality(tets, worst)).dump();
}

py::array min_dihedral_angles(const py::handle& mesh) {
  const TetMesh tets = to_tet_mesh(mesh);
  return array_of<float>(min_dihedral_angles_deg(tets));
}

py::tuple embed(const py::handle& points, const py::handle& mesh) {
  const std::vector<Vec3> places = to_points(points, "points");
  const TetMesh tets = to_tet_mesh(mesh);
  Embedding embedding;
  {
    const py::gil_scoped_release unlocked;
    embedding = embed_points(tets, places);
  }
  return py::make_tuple(array_of<std::int64_t>(std::move(embedding.tets)),
                        array_of<std::int64_t>(std::move(embedding.vertices)),
                        array_of<double>(std::move(embedding.weights)));
}

}  // namespace

void add_jobs(py::module_& module) {
  py::class_<Progress>(module, "Progress")
      .def_property_readonly("phase", [](const Progress& p) { return std::string(p.phase); })
      .def_readonly("done", &Progress::done)
      .def_readonly("expected", &Progress::expected)
      .def_readonly("vertices", &Progress::vertices)
      .def_readonly("tets", &Progress::tets);
  py::class_<cli::CheckDemands>(module, "CheckDemands")
      .def(py::init<>([](std::optional<double> min_angle, std::optional<double> max_angle,
                         std::optional<double> max_radius_edge, std::size_t worst) {
             return cli::CheckDemands{min_angle, max_angle, max_radius_edge, worst};
           }),
           py::arg("min_angle"), py::arg("max_angle"), py::arg("max_radius_edge"), py::arg("worst"));
  module.def("mesh", mesh);
  module.def("check", check);
  module.def("quality", quality);
  module.def("embed", embed, py::arg("points"), py::arg("mesh"));
  module.def("min_dihedral_angles", min_dihedral_angles);
}

}  // namespace unsliver::python
