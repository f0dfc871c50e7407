#include "picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "raster.hpp"
#include "text.hpp"
#include "unsliver/quality.hpp"

namespace unsliver::cli {
namespace {

constexpr Colour kPaper{250, 250, 248}, kInk{40, 44, 52}, kFaint{205, 207, 210}, kGuarantee{200, 60, 50};
constexpr int kOversampling = 2;
/// No tetrahedron has a smallest dihedral angle above that of the regular one, arccos(1/3).
constexpr double kRegularDegrees = 70.528779365509308;

struct Stop {
  double degrees;
  Colour colour;
};
/// Slivers glow; what the guarantee allows is cool.
constexpr std::array kStops = {Stop{0, {110, 0, 20}},
                               Stop{15, {214, 40, 40}},
                               Stop{29.9, {247, 150, 30}},
                               Stop{30, {238, 214, 90}},
                               Stop{45, {90, 180, 120}},
                               Stop{60, {60, 120, 190}},
                               Stop{kRegularDegrees, {70, 60, 150}}};

Colour colour_of(double degrees) {
  degrees = std::clamp(degrees, kStops.front().degrees, kStops.back().degrees);
  std::size_t i = 1;
  while (kStops[i].degrees < degrees) ++i;
  const Stop &low = kStops[i - 1], &high = kStops[i];
  return mix(low.colour, high.colour, (degrees - low.degrees) / (high.degrees - low.degrees));
}

int panel_width(const PictureOptions& options) { return std::clamp(options.width * 3 / 10, 120, 420); }

/// A cut is looked at a little from the side and from above, so that its steps stand out.
View make_view(const PictureOptions& options) {
  const Vec3 front = options.cut ? 1 / norm(options.cut->normal) * options.cut->normal : Vec3{0.5, -0.8, 0.2};
  const View straight = look_from(front, options.up);
  return look_from(straight.toward + 0.35 * straight.right + 0.3 * straight.up, options.up);
}

/// Moves and scales the view so that the faces fill a picture of this size.
void fit(View& view, const TetMesh& mesh, const std::vector<VisibleFace>& faces, int width, int height) {
  Box3 seen;
  for (const VisibleFace& face : faces)
    for (const VertexId v : face.vertices) {
      const Vec3& p = mesh.points[v];
      seen.extend(Vec3{dot(p, view.right), dot(p, view.up), dot(p, view.toward)});
    }
  if (seen.empty()) return;
  const Vec3 middle = seen.center(), size = seen.size();
  view.center = middle.x * view.right + middle.y * view.up + middle.z * view.toward;
  view.scale = 0.92 * std::min(width / std::max(size.x, 1e-300), height / std::max(size.y, 1e-300));
}

Image draw_mesh(const TetMesh& mesh, const PictureOptions& options, int width, int height) {
  const std::vector<VisibleFace> faces = visible_faces(mesh, options.cut);
  View view = make_view(options);
  fit(view, mesh, faces, width * kOversampling, height * kOversampling);
  Raster raster(width * kOversampling, height * kOversampling, kPaper, view);
  const std::vector<float> angles = min_dihedral_angles_deg(mesh);
  for (const VisibleFace& face : faces) {
    const auto [a, b, c] = face.vertices;
    const Colour colour = colour_of(angles[face.tet]);
    raster.draw({mesh.points[a], mesh.points[b], mesh.points[c]},
                face.inside ? colour : mix(colour, kFaint, 0.35), 0.6 * kOversampling);
  }
  return raster.image().reduced(kOversampling);
}

/// The panel beside the picture, written from top to bottom.
class Panel {
 public:
  Panel(Image& image, int left, int width)
      : image_(image), left_(left), width_(width), scale_(width >= 250 ? 2 : 1), y_(8 * scale_) {}

  void text(const std::string& line) {
    const auto fits = static_cast<std::size_t>(width_ / text_width(" ", scale_));
    image_.write(left_, y_, line.substr(0, fits), kInk, scale_);
    y_ += 11 * scale_;
  }
  void gap() { y_ += 8 * scale_; }

  void legend() {
    const int height = 10 * scale_;
    for (int x = 0; x < width_; ++x)
      image_.fill(left_ + x, y_, 1, height, colour_of(kRegularDegrees * (x + 0.5) / width_));
    y_ += height;
    ticks({0, 15, 30, 45, 60}, kRegularDegrees);
  }

  void histogram(const QualitySummary& quality, int height) {
    const auto& bins = quality.histogram;
    const auto most = static_cast<double>(*std::max_element(bins.begin(), bins.end()));
    const auto edge = [&](std::size_t bin) {
      return left_ + width_ * static_cast<int>(bin) / static_cast<int>(bins.size());
    };
    mark(30, height);
    mark(135, height);
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
      const auto bar =
          static_cast<int>(std::ceil(height * static_cast<double>(bins[bin]) / std::max(most, 1.0)));
      const double middle = 5 * (static_cast<double>(bin) + 0.5);
      image_.fill(edge(bin), y_ + height - bar, std::max(edge(bin + 1) - edge(bin) - 1, 1), bar,
                  middle < kRegularDegrees ? colour_of(middle) : kInk);
    }
    y_ += height;
    image_.fill(left_, y_, width_, 1, kInk);
    ticks({0, 30, 60, 90, 135, 180}, 180);
  }

 private:
  int place(double degrees, double full) const {
    return left_ + static_cast<int>(std::lround((width_ - 1) * degrees / full));
  }
  void mark(double degrees, int height) { image_.fill(place(degrees, 180), y_, 1, height, kGuarantee); }
  void ticks(std::initializer_list<int> values, double full) {
    for (const int value : values) {
      const std::string label = std::to_string(value);
      const int x = place(value, full), half = text_width(label, scale_) / 2;
      image_.fill(x, y_, 1, 3 * scale_, kInk);
      image_.write(std::clamp(x - half, left_, left_ + width_ - 2 * half), y_ + 4 * scale_, label, kInk,
                   scale_);
    }
    y_ += 16 * scale_;
  }

  Image& image_;
  int left_, width_, scale_, y_;
};

void draw_panel(Image& image, const TetMesh& mesh, const PictureOptions& options) {
  const QualitySummary quality = summarize_quality(mesh, 0);
  const int margin = 12, width = panel_width(options) - 2 * margin;
  Panel panel(image, options.width - width - margin, width);
  panel.text(options.title);
  panel.text(with_separators(mesh.points.size()) + " vertices");
  panel.text(with_separators(mesh.tets.size()) + " tetrahedra");
  panel.gap();
  panel.text("Smallest angle of each");
  panel.legend();
  panel.gap();
  panel.text("All dihedral angles");
  panel.text(fmt::format("{:.3f} to {:.3f}", quality.min_dihedral_deg, quality.max_dihedral_deg));
  panel.histogram(quality, std::clamp(options.height / 4, 40, 300));
}

}  // namespace

Image draw_picture(const TetMesh& mesh, const PictureOptions& options) {
  Image picture(options.width, options.height, kPaper);
  const int mesh_width = options.width - panel_width(options);
  const Image scene = draw_mesh(mesh, options, mesh_width, options.height);
  for (int y = 0; y < scene.height(); ++y)
    for (int x = 0; x < scene.width(); ++x) picture.set(x, y, scene.at(x, y));
  draw_panel(picture, mesh, options);
  return picture;
}

}  // namespace unsliver::cli
