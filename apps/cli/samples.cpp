#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace unsliver::cli {
namespace {

constexpr std::uint64_t kSeed = 20060605;

/// Uniform in [0, 1), the same on every standard library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

Vec3 point_in(const Box3& box, std::mt19937_64& random) {
  const Vec3 size = box.size();
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return {box.lo.x + x * size.x, box.lo.y + y * size.y, box.lo.z + z * size.z};
}

/// The last point inside the domain on the way from `inside` to `outside`.
Vec3 boundary_point(const Domain& domain, Vec3 inside, Vec3 outside) {
  for (int step = 0; step < 60; ++step) {
    const Vec3 middle = 0.5 * (inside + outside);
    (domain.contains(middle) ? inside : outside) = middle;
  }
  return inside;
}

std::vector<double> cumulative_areas(const TriangleMesh& surface) {
  std::vector<double> sums;
  sums.reserve(surface.triangles.size());
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3& p = surface.points[a];
    sum += norm(cross(surface.points[b] - p, surface.points[c] - p));
    sums.push_back(sum);
  }
  return sums;
}

Vec3 point_in_triangle(const Vec3& a, const Vec3& b, const Vec3& c, std::mt19937_64& random) {
  constexpr std::uint64_t kSteps = 1 << 16;
  std::uint64_t u = random() % (kSteps + 1), v = random() % (kSteps + 1);
  if (u + v > kSteps) {
    u = kSteps - u;
    v = kSteps - v;
  }
  return a + static_cast<double>(u) / kSteps * (b - a) + static_cast<double>(v) / kSteps * (c - a);
}

}  // namespace

std::vector<Vec3> domain_samples(const Domain& domain, std::size_t count) {
  std::mt19937_64 random(kSeed);
  std::vector<Vec3> samples;
  std::optional<Vec3> last_inside, last_outside;
  const Box3 bounds = domain.bounds();
  for (std::size_t draw = 0; draw < count; ++draw) {
    const Vec3 p = point_in(bounds, random);
    const bool inside = domain.contains(p);
    (inside ? last_inside : last_outside) = p;
    if (inside) samples.push_back(p);
    if (last_inside && last_outside) samples.push_back(boundary_point(domain, *last_inside, *last_outside));
  }
  return samples;
}

std::vector<Vec3> surface_vertices(const TriangleMesh& surface) {
  std::vector<bool> used(surface.points.size(), false);
  for (const auto& triangle : surface.triangles)
    for (const VertexId v : triangle) used[v] = true;
  std::vector<Vec3> vertices;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) vertices.push_back(surface.points[v]);
  return vertices;
}

std::vector<Vec3> surface_samples(const TriangleMesh& surface, std::size_t count) {
  const std::vector<double> sums = cumulative_areas(surface);
  if (sums.empty() || !(sums.back() > 0)) return {};
  std::mt19937_64 random(kSeed);
  std::vector<Vec3> samples;
  samples.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = std::upper_bound(sums.begin(), sums.end() - 1, uniform(random) * sums.back());
    const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(found - sums.begin())];
    samples.push_back(point_in_triangle(surface.points[a], surface.points[b], surface.points[c], random));
  }
  return samples;
}

double sample_rounding(const std::vector<Vec3>& samples) {
  constexpr double kFewRoundings = 2e-15;
  double largest = 0;
  for (const Vec3& p : samples) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return kFewRoundings * largest;
}

}  // namespace unsliver::cli
