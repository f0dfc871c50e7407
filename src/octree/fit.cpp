#include "octree/fit.hpp"

#include <cmath>
#include <random>
#include <vector>

#include "octree/growth.hpp"
#include "octree/leaf_test.hpp"
#include "unsliver/error.hpp"

namespace unsliver::octree {
namespace {

constexpr int kCandidates = 12;
constexpr std::size_t kDraws = 4096, kSamples = 256;
/// A lower bound of s below this share of the domain comes from places outside the domain, where s may be
/// anything.
constexpr double kUnknownSize = 1e-12;
constexpr double kTwelfthRootOfHalf = 0.94387431268169353;

struct Sample {
  Vec3 at;
  double size;

  double ideal_density() const { return 1 / (size * size * size); }
};

std::vector<Sample> draw(const Domain& domain, const Sizing& sizing) {
  std::mt19937_64 random(1);
  const Box3 box = domain.bounds();
  const auto between = [&](double lo, double hi) {
    return lo + (hi - lo) * (double(random() >> 11) * 0x1p-53);
  };
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < kDraws; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = between(box.lo[axis], box.hi[axis]);
    if (domain.contains(p)) samples.push_back({p, std::min(box.diagonal(), sizing.at(p))});
  }
  return samples;
}

/// Some of the samples, each as often as vertices are expected there.
std::vector<Sample> where_vertices_are(const std::vector<Sample>& samples) {
  double total = 0;
  for (const Sample& s : samples) total += s.ideal_density();
  std::vector<Sample> chosen;
  double sum = 0;
  for (const Sample& s : samples) {
    sum += s.ideal_density();
    while (double(chosen.size()) + 0.5 < double(kSamples) * (sum / total) && chosen.size() < kSamples)
      chosen.push_back(s);
  }
  return chosen;
}

Cell child_at(const Cell& cell, const Vec3& q) {
  const int k = cell.exponent - 1;
  const Vec3 center = cell.center();
  return {kNoNode, k, cell.x + (std::int64_t(q.x >= center.x) << k),
          cell.y + (std::int64_t(q.y >= center.y) << k), cell.z + (std::int64_t(q.z >= center.z) << k)};
}

/// Vertices per volume (caller's units) in the leaf that holds x, balance left aside.
double vertex_density(LeafTest& test, int root_exponent, std::uint8_t root_flags, const Vec3& x) {
  const Vec3 q = test.world().to_world_real(x);
  const double side = std::ldexp(1.0, root_exponent);
  const auto lower = [side](double c) { return std::int64_t(std::floor(c / side) * side); };
  Cell cell{kNoNode, root_exponent, lower(q.x), lower(q.y), lower(q.z)};
  std::uint8_t flags = root_flags;
  for (;; cell = child_at(cell, q)) {
    flags = test.flags(cell, flags);
    const Verdict verdict = test.judge(cell, flags);
    if (verdict == Verdict::kSplit && cell.exponent > 1) continue;
    const double h = double(cell.side()) * test.world().unit();
    return (verdict == Verdict::kPlain ? 1 : 2) / (h * h * h);
  }
}

/// How many vertices are needed for each that the thinnest covering would take, but for a factor.
double surplus(LeafTest test, int root_exponent, std::uint8_t root_flags,
               const std::vector<Sample>& samples) {
  double sum = 0;
  for (const Sample& s : samples)
    sum += vertex_density(test, root_exponent, root_flags, s.at) / s.ideal_density();
  return sum;
}

double surplus(const Domain& domain, const Sizing& sizing, double radius,
               const std::vector<Sample>& samples) {
  const lattice::World world = lattice::World::fit(domain.bounds(), radius);
  const int root_exponent = brick_around(in_world(domain.bounds(), world)).exponent;
  return surplus(LeafTest(domain, sizing, world), root_exponent, 0, samples);
}

}  // namespace

double fit_radius(const Domain& domain, const Sizing& sizing) {
  const double least = sizing.lower_bound(domain.bounds());
  if (!std::isfinite(least) || least <= kUnknownSize * domain.bounds().diagonal()) return 0;
  const double finest = LeafTest::kSizeShare * least;
  if (sizing.lipschitz() == 0) return finest;
  const std::vector<Sample> samples = where_vertices_are(draw(domain, sizing));
  double best = finest, best_surplus = std::numeric_limits<double>::infinity(), radius = finest;
  for (int i = 0; i < kCandidates; ++i, radius *= kTwelfthRootOfHalf) {
    const double its_surplus = surplus(domain, sizing, radius, samples);
    if (its_surplus < best_surplus) best = radius, best_surplus = its_surplus;
  }
  return best;
}

const BoxLattice& fit_lattice(const std::vector<BoxLattice>& lattices, const Domain& box,
                              const Sizing& sizing) {
  if (lattices.size() == 1) return lattices.front();
  const std::vector<Sample> samples = where_vertices_are(draw(box, sizing));
  const BoxLattice* best = nullptr;
  double best_surplus = std::numeric_limits<double>::infinity();
  for (const BoxLattice& lattice : lattices) {
    const LeafTest test(box, sizing, lattice.world);
    const double its_surplus = surplus(test, lattice.brick.exponent, kWholeInside, samples);
    if (best == nullptr || its_surplus < best_surplus) best = &lattice, best_surplus = its_surplus;
  }
  return *best;
}

}  // namespace unsliver::octree
