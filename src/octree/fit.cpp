#include "octree/fit.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "octree/growth.hpp"
#include "octree/leaf_test.hpp"
#include "octree/parallel.hpp"
#include "unsliver/error.hpp"

namespace unsliver::octree {
namespace {

constexpr std::size_t kCandidates = 12;
constexpr std::size_t kDraws = 4096, kRow = 64, kSamples = 256;
/// A lower bound of s below this share of the domain comes from places outside the domain, where s may be
/// anything.
constexpr double kUnknownSize = 1e-12;
constexpr double kTwelfthRootOfHalf = 0.94387431268169353;

struct Sample {
  Vec3 at;
  double size;

  double ideal_density() const { return 1 / (size * size * size); }
};

std::vector<Vec3> draw_points(const Box3& box) {
  std::mt19937_64 random(1);
  const auto between = [&](double lo, double hi) {
    return lo + (hi - lo) * (double(random() >> 11) * 0x1p-53);
  };
  std::vector<Vec3> points(kDraws);
  for (Vec3& p : points)
    for (int axis = 0; axis < 3; ++axis) p[axis] = between(box.lo[axis], box.hi[axis]);
  return points;
}

std::vector<Sample> draw(const Domain& domain, const Sizing& sizing, unsigned threads) {
  const Box3 box = domain.bounds();
  const std::vector<Vec3> points = draw_points(box);
  std::vector<std::vector<Sample>> rows(kDraws / kRow);
  for_each_task(rows.size(), threads, [&](std::size_t row, unsigned) {
    for (std::size_t i = row * kRow; i < (row + 1) * kRow; ++i)
      if (domain.contains(points[i]))
        rows[row].push_back({points[i], std::min(box.diagonal(), sizing.at(points[i]))});
  });
  std::vector<Sample> samples;
  for (const auto& row : rows) samples.insert(samples.end(), row.begin(), row.end());
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

/// The first number in 0..count-1 of the least surplus.
template <class Surplus>
std::size_t best_of(std::size_t count, unsigned threads, const Surplus& surplus) {
  std::vector<double> surpluses(count);
  for_each_task(count, threads, [&](std::size_t i, unsigned) { surpluses[i] = surplus(i); });
  return std::size_t(std::min_element(surpluses.begin(), surpluses.end()) - surpluses.begin());
}

}  // namespace

double fit_radius(const Domain& domain, const Sizing& sizing, unsigned threads) {
  const double least = sizing.lower_bound(domain.bounds());
  if (!std::isfinite(least) || least <= kUnknownSize * domain.bounds().diagonal()) return 0;
  const double finest = LeafTest::kSizeShare * least;
  if (sizing.lipschitz() == 0) return finest;
  const std::vector<Sample> samples = where_vertices_are(draw(domain, sizing, threads));
  std::vector<double> radii = {finest};
  while (radii.size() < kCandidates) radii.push_back(radii.back() * kTwelfthRootOfHalf);
  return radii[best_of(radii.size(), threads,
                       [&](std::size_t i) { return surplus(domain, sizing, radii[i], samples); })];
}

const BoxLattice& fit_lattice(const std::vector<BoxLattice>& lattices, const Domain& box,
                              const Sizing& sizing, unsigned threads) {
  if (lattices.size() == 1) return lattices.front();
  const std::vector<Sample> samples = where_vertices_are(draw(box, sizing, threads));
  return lattices[best_of(lattices.size(), threads, [&](std::size_t i) {
    const LeafTest test(box, sizing, lattices[i].world);
    return surplus(test, lattices[i].brick.exponent, kWholeInside, samples);
  })];
}

}  // namespace unsliver::octree
