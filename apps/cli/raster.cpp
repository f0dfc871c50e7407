#include "raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace unsliver::cli {
namespace {

constexpr Colour kEdge{25, 30, 40};
constexpr double kAmbient = 0.6;
/// A triangle this low (in pixels) shows no edges, one twice as high shows them fully.
constexpr double kFadeHeight = 5;

Vec3 normalized(const Vec3& v) { return 1 / norm(v) * v; }

/// The barycentric coordinates over the picture plane as affine functions of the pixel.
struct Barycentric {
  Vec3 a, b, c;
  double area;  ///< twice the area, signed

  explicit Barycentric(const std::array<Vec3, 3>& p)
      : a(p[0]), b(p[1]), c(p[2]), area((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) {}

  std::array<double, 3> at(double x, double y) const {
    const double u = ((b.x - x) * (c.y - y) - (c.x - x) * (b.y - y)) / area;
    const double v = ((c.x - x) * (a.y - y) - (a.x - x) * (c.y - y)) / area;
    return {u, v, 1 - u - v};
  }

  /// Heights of the corners above the opposite sides, in pixels.
  std::array<double, 3> heights() const {
    const auto above = [this](const Vec3& p, const Vec3& q) {
      return std::abs(area) / std::max(std::hypot(q.x - p.x, q.y - p.y), 1e-12);
    };
    return {above(b, c), above(c, a), above(a, b)};
  }
};

struct PixelRange {
  int begin, end;
  PixelRange(double p, double q, double r, int size)
      : begin(clamped(std::floor(std::min({p, q, r})), size)),
        end(clamped(std::ceil(std::max({p, q, r})) + 1, size)) {}
  static int clamped(double value, int size) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
  }
};

}  // namespace

View look_from(const Vec3& toward, const Vec3& up) {
  View view;
  view.toward = normalized(toward);
  Vec3 right = cross(up, view.toward);
  if (norm(right) < 1e-6 * norm(up)) right = cross({up.y, up.z, up.x}, view.toward);
  view.right = normalized(right);
  view.up = cross(view.toward, view.right);
  return view;
}

Raster::Raster(int width, int height, Colour background, View view)
    : image_(width, height, background),
      view_(view),
      depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
             -std::numeric_limits<float>::infinity()) {}

Vec3 Raster::project(const Vec3& p) const {
  const Vec3 d = p - view_.center;
  return {0.5 * image_.width() + view_.scale * dot(d, view_.right),
          0.5 * image_.height() - view_.scale * dot(d, view_.up), view_.scale * dot(d, view_.toward)};
}

/// Lit from over the right shoulder, both sides alike.
Colour Raster::lit(const std::array<Vec3, 3>& triangle, Colour colour) const {
  const Vec3 normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double length = norm(normal);
  if (!(length > 0)) return colour;
  const Vec3 light = normalized(view_.toward + 0.4 * view_.right + 0.6 * view_.up);
  const double facing = std::abs(dot(normal, light)) / length;
  return mix({0, 0, 0}, colour, kAmbient + (1 - kAmbient) * facing);
}

void Raster::draw(const std::array<Vec3, 3>& triangle, Colour colour, double edge_pixels) {
  const std::array p = {project(triangle[0]), project(triangle[1]), project(triangle[2])};
  const Barycentric barycentric(p);
  if (barycentric.area == 0) return;
  const Colour face = lit(triangle, colour);
  const auto heights = barycentric.heights();
  const double visible =
      std::clamp(*std::min_element(heights.begin(), heights.end()) / kFadeHeight - 1, 0.0, 1.0);
  const Colour edge = mix(face, kEdge, 0.8 * visible);
  const PixelRange columns(p[0].x, p[1].x, p[2].x, image_.width()),
      rows(p[0].y, p[1].y, p[2].y, image_.height());
  for (int y = rows.begin; y < rows.end; ++y)
    for (int x = columns.begin; x < columns.end; ++x) {
      const auto [u, v, w] = barycentric.at(x + 0.5, y + 0.5);
      if (!(u >= 0 && v >= 0 && w >= 0)) continue;
      const auto z = static_cast<float>(u * p[0].z + v * p[1].z + w * p[2].z);
      float& depth = depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width()) +
                            static_cast<std::size_t>(x)];
      if (z <= depth) continue;
      depth = z;
      const bool near_edge = std::min({u * heights[0], v * heights[1], w * heights[2]}) < edge_pixels;
      image_.set(x, y, near_edge ? edge : face);
    }
}

}  // namespace unsliver::cli
