// A domain of your own: a torus, by its distance function, and points that become vertices. The mesh is
// judged by the independent checker, and progress is shown.
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "unsliver/refine.hpp"
#include "unsliver/verify.hpp"

namespace {

using unsliver::Box3;
using unsliver::Tet;
using unsliver::Vec3;

/// All that meshing asks for follows from the distance to the surface, which a torus has in closed form.
class Torus final : public unsliver::Domain {
 public:
  Torus(double ring, double tube) : ring_(ring), tube_(tube) {}

  Box3 bounds() const override {
    const double r = ring_ + tube_;
    return {{-r, -r, -tube_}, {r, r, tube_}};
  }
  bool contains(const Vec3& p) const override { return distance(p) <= 0; }
  /// A little less than the distance: rounding must not make it too large.
  double clearance(const Vec3& p) const override { return (1 - 1e-12) * distance(p); }
  /// Not if the ball around it is outside; else its halves decide, down to a size below which it is kept.
  /// That may keep a tetrahedron too many near the surface, and never drops one that is needed.
  bool meets(const Tet& t) const override {
    const Vec3 center = 0.25 * (t[0] + t[1] + t[2] + t[3]);
    double radius = 0;
    for (const Vec3& corner : t) radius = std::max(radius, unsliver::dist(center, corner));
    if (clearance(center) >= radius) return false;
    if (contains(center) || radius < 0.02 * tube_) return true;
    const auto [half, other] = halves(t);
    return meets(half) || meets(other);
  }
  double volume() const override { return 2 * M_PI * M_PI * ring_ * tube_ * tube_; }
  std::string describe() const override { return "torus"; }

 private:
  /// Cut across the longest edge.
  static std::array<Tet, 2> halves(const Tet& t) {
    std::size_t a = 0, b = 1;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (unsliver::dist_sq(t[i], t[j]) > unsliver::dist_sq(t[a], t[b])) a = i, b = j;
    std::array<Tet, 2> parts = {t, t};
    parts[0][a] = parts[1][b] = 0.5 * (t[a] + t[b]);
    return parts;
  }
  double distance(const Vec3& p) const { return std::hypot(std::hypot(p.x, p.y) - ring_, p.z) - tube_; }

  double ring_, tube_;
};

}  // namespace

int main() {
  const Torus torus(1, 0.4);
  const auto size = unsliver::constant_size(0.2);
  const std::vector<Vec3> sensors = {{1, 0, 0}, {0, 1.1, 0.1}, {-0.9, 0, 0}};

  unsliver::Control control;
  control.on_progress = [](const unsliver::Progress& progress) {
    std::printf("%s: %llu tetrahedra\n", std::string(progress.phase).c_str(),
                static_cast<unsigned long long>(progress.tets));
  };
  const unsliver::MeshResult result = unsliver::mesh_domain(torus, *size, sensors, {}, control);

  unsliver::VerifyOptions due;
  due.guarantee = {30, 135, unsliver::least_radius_edge(true)};
  due.inside = [&](const Vec3& p) { return torus.contains(p); };
  due.size = [&](const Vec3& p) { return size->at(p); };
  const unsliver::VerifyReport verdict = unsliver::verify(result.mesh, due);
  for (const std::string& line : verdict.checks) std::printf("%s\n", line.c_str());
  return verdict.ok && result.mesh.points[0] == sensors[0] ? 0 : 1;
}
