#include <algorithm>
#include <random>

#include "verify/sampling_checks.hpp"

namespace unsliver::verifier {
namespace {

/// Uniform points from one generator, the same on every compiler.
class Sampler {
 public:
  Sampler(const TetMesh& mesh, const std::vector<VertexId>& used, std::uint64_t seed)
      : mesh_(mesh), engine_(seed) {
    for (const VertexId v : used) box_.extend(mesh.points[v]);
    volume_up_to_.reserve(mesh.tets.size());
    double total = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      const Tet c = mesh.corners(t);
      total += std::abs(dot(c[1] - c[0], cross(c[2] - c[0], c[3] - c[0])));
      volume_up_to_.push_back(total);
    }
  }

  Vec3 in_box() {
    const Vec3 s = box_.size();
    const double x = unit(), y = unit(), z = unit();
    return {box_.lo.x + x * s.x, box_.lo.y + y * s.y, box_.lo.z + z * s.z};
  }

  /// A tetrahedron by volume, then three sorted numbers as barycentric cuts.
  Vec3 in_mesh() {
    const double at = unit() * volume_up_to_.back();
    auto found = std::upper_bound(volume_up_to_.begin(), volume_up_to_.end(), at);
    if (found == volume_up_to_.end()) --found;
    const Tet c = mesh_.corners(static_cast<std::size_t>(found - volume_up_to_.begin()));
    double cut[3] = {unit(), unit(), unit()};
    std::sort(std::begin(cut), std::end(cut));
    return c[0] + cut[0] * (c[1] - c[0]) + (cut[1] - cut[0]) * (c[2] - c[0]) +
           (cut[2] - cut[1]) * (c[3] - c[0]);
  }

 private:
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  const TetMesh& mesh_;
  std::mt19937_64 engine_;
  Box3 box_;
  std::vector<double> volume_up_to_;
};

class SizeCheck {
 public:
  SizeCheck(const Context& c, const KdTree& vertices) : c_(c), vertices_(vertices) {}

  void run(Sampler& sampler) {
    const std::size_t half = c_.options.size_samples / 2;
    // A thin domain fills little of its box: give up on the box after a few rejections a sample.
    for (std::size_t tries = 0; done_ < half && tries < 20 * half; ++tries) try_point(sampler.in_box());
    for (std::size_t tries = 0; done_ < c_.options.size_samples && tries < 20 * c_.options.size_samples;
         ++tries) {
      try_point(sampler.in_mesh());
    }
    // Random points miss a domain of nearly no volume; the caller may know some of it.
    if (done_ == 0)
      for (const Vec3& p : c_.options.must_cover) try_point(p);
    if (done_ == 0 && c_.options.size_samples > 0) {
      c_.reporter.find("size", {},
                       [] { return std::string("no sample lies in the domain: nothing was tested"); });
    }
    c_.reporter.report().worst_size_ratio = worst_;
    const std::uint64_t wrong = c_.reporter.count("size");
    c_.reporter.line("size: " + grouped(done_) + " random points of the domain, nearest vertex at most " +
                     brief(worst_) + " times s away; the bound " +
                     (wrong == 0 ? "holds at all of them" : "is VIOLATED " + grouped(wrong) + " times"));
  }

 private:
  void try_point(const Vec3& p) {
    c_.pulse.beats(0);
    if (!c_.options.inside(p)) return;
    ++done_;
    const double size = c_.options.size(p);
    const double distance = std::sqrt(vertices_.nearest(p).dist_sq);
    if (!(size > 0)) {
      return c_.reporter.find(
          "size", {}, [&] { return "s" + full(p) + " = " + full(size) + " is not a positive length"; });
    }
    worst_ = std::max(worst_, distance / size);
    if (distance <= size * (1 + 1e-12)) return;
    c_.reporter.find("size", {vertices_.nearest(p).id}, [&] {
      return "the vertex nearest to " + full(p) + " is " + full(distance) + " away, but s = " + full(size);
    });
  }

  const Context& c_;
  const KdTree& vertices_;
  std::size_t done_ = 0;
  double worst_ = 0;
};

}  // namespace

void check_size(const Context& context, const KdTree& vertices, const std::vector<VertexId>& used) {
  if (context.mesh.tets.empty()) return;
  Sampler sampler(context.mesh, used, context.options.seed);
  SizeCheck(context, vertices).run(sampler);
}

}  // namespace unsliver::verifier
