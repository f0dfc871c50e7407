/// \file
/// `unsliver view`: a still picture of a mesh, cut open.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>

#include "commands.hpp"
#include "files.hpp"
#include "picture.hpp"
#include "png.hpp"
#include "terminal.hpp"
#include "text.hpp"
#include "unsliver/io.hpp"
#include "usage.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  unsliver view mesh.vtu -o mesh.png
  unsliver view mesh.vtu -o half.png --cut "1 1 0 0.5" --size 1600x1200
  unsliver view spot.vtu -o whole.png --cut none --up y
Whole tetrahedra are shown on the side of the plane where nx x + ny y + nz z <= d, coloured by their
smallest dihedral angle: red below 30 degrees, yellow to blue above.)text";

struct ViewOptions {
  std::string mesh, output, size = "1200x900", cut = "auto", up = "z";
};

/// \throws Error kBadOption.
std::pair<int, int> parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto side = [&](const std::string& part) {
    const auto number = parse_number(part);
    if (!number || !(*number >= 240 && *number <= 8192) || *number != static_cast<int>(*number))
      throw Error(ErrorCode::kBadOption,
                  fmt::format("--size is \"{}\": give WIDTHxHEIGHT in pixels, each from 240 to 8192", text));
    return static_cast<int>(*number);
  };
  return {side(text.substr(0, cross)), side(cross == std::string::npos ? "" : text.substr(cross + 1))};
}

Vec3 axis(const std::string& name) {
  Vec3 direction;
  direction[name.front() - 'x'] = 1;
  return direction;
}

/// Every tetrahedron has corners, and they are finite. \throws Error kBadInput.
void check_drawable(const std::string& name, const TetMesh& mesh) {
  if (mesh.tets.empty()) throw Error(ErrorCode::kBadInput, name + ": there is no tetrahedron to show");
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const VertexId v : mesh.tets[t])
      if (v >= mesh.points.size() || !is_finite(mesh.points[v]))
        throw Error(ErrorCode::kBadInput,
                    fmt::format("{}: tetrahedron {} has no finite corner at vertex {}", name, t, v));
}

/// Something remains of the mesh and something is cut off. \throws Error kBadOption.
void check_cut(const ViewOptions& options, const std::optional<CutPlane>& cut, const TetMesh& mesh) {
  if (!cut || options.cut == "auto") return;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Vec3& p : mesh.corners(t)) {
      low = std::min(low, dot(cut->normal, p));
      high = std::max(high, dot(cut->normal, p));
    }
  if (low < cut->offset && cut->offset < high) return;
  throw Error(
      ErrorCode::kBadOption,
      fmt::format("--cut \"{}\": the plane misses the mesh. With this normal, d must lie between {:.6g} "
                  "and {:.6g}; --cut none shows the whole mesh",
                  options.cut, low, high));
}

ExitCode run(const ViewOptions& options) {
  PictureOptions picture;
  std::tie(picture.width, picture.height) = parse_size(options.size);
  picture.up = axis(options.up);
  picture.title = std::filesystem::path(options.mesh).filename().string();
  if (options.cut != "auto" && options.cut != "none") picture.cut = parse_plane(options.cut);
  if (extension_of(options.output) != "png")
    throw Error(ErrorCode::kBadOption, options.output + ": a picture is written as .png only");
  check_writable(options.output, "the output");
  check_distinct({options.output}, {options.mesh});
  check_readable(options.mesh);
  const TetMesh mesh = io::read_tet_mesh(options.mesh);
  check_drawable(options.mesh, mesh);
  if (options.cut == "auto") {
    Box3 box;
    for (const Vec3& p : mesh.points) box.extend(p);
    picture.cut = middle_plane(box);
  }
  check_cut(options, picture.cut, mesh);
  write_file(options.output, encode_png(draw_picture(mesh, picture)));
  return ExitCode::kDone;
}

}  // namespace

Command add_view(CLI::App& app) {
  const auto options = std::make_shared<ViewOptions>();
  CLI::App* const parser = app.add_subcommand("view", "Draw a still picture of a mesh, cut open");
  parser->add_option("MESH", options->mesh, "mesh file: .vtu .msh .mesh .node .ele")->required();
  parser->add_option("-o,--output", options->output, "picture file: .png")->required();
  parser->add_option("--size", options->size, "WIDTHxHEIGHT in pixels (default 1200x900)");
  parser->add_option("--cut", options->cut,
                     "\"nx ny nz d\", auto (default: through the middle, across\n"
                     "the shortest side) or none");
  parser->add_option("--up", options->up, "the axis that points up: x, y or z (default)")
      ->check(one_of({"x", "y", "z"}));
  parser->footer(kExamples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace unsliver::cli
