#include "verify/holes.hpp"

#include <cmath>

namespace unsliver::verifier {

std::array<Vec3, 4> points_beyond(const std::array<Vec3, 3>& corners) {
  constexpr double kBeyond = 1e-6;
  const auto& [a, b, c] = corners;
  const Vec3 normal = cross(b - a, c - a);
  const double edge = std::sqrt(std::hypot(normal.x, normal.y, normal.z));  // no squares: they may overflow
  const Vec3 center = (1.0 / 3) * (a + b + c), beyond = center + kBeyond / edge * normal;
  return {beyond, beyond + 0.5 * (a - center), beyond + 0.5 * (b - center), beyond + 0.5 * (c - center)};
}

void find_hole(Reporter& reporter, const Facet& facet, const Vec3& p) {
  reporter.find("cover", {facet[0], facet[1], facet[2]}, [&] {
    return "the domain is on both sides of " + name_of(facet) + " near " + full(p) +
           ", and only one tetrahedron is there";
  });
}

void report_holes(Reporter& reporter, std::uint64_t facets, std::uint64_t holes) {
  reporter.line("cover: beyond " + grouped(facets) + " facets in one tetrahedron the mesh leaves out " +
                (holes == 0 ? "nothing of the domain" : "some of the domain " + grouped(holes) + " times") +
                ", by " + grouped(4 * facets) + " samples");
}

}  // namespace unsliver::verifier
