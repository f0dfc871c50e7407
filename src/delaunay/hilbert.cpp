#include "delaunay/hilbert.hpp"

#include <algorithm>
#include <numeric>
#include <random>

namespace unsliver::delaunay {

namespace {

constexpr int kBits = 21;
constexpr std::size_t kFirstRound = 1024;  // below this, sorting gains nothing over the walk
constexpr std::size_t kGrowth = 8;

std::uint32_t cell(double x, double lo, double hi) {
  if (!(hi > lo)) return 0;
  const double last = double((1u << kBits) - 1);
  return static_cast<std::uint32_t>(std::clamp((x - lo) / (hi - lo) * last, 0.0, last));
}

// Interleaves the three axes' bits, most significant first, x before y before z.
std::uint64_t interleave(const std::uint32_t (&axes)[3]) {
  std::uint64_t index = 0;
  for (int bit = kBits - 1; bit >= 0; --bit)
    for (std::uint32_t axis : axes) index = index << 1 | (axis >> bit & 1);
  return index;
}

void sort_along_curve(std::span<std::uint32_t> ids, std::span<const Vec3> points, const Box3& box) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) keyed[i] = {hilbert_index(points[ids[i]], box), ids[i]};
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = keyed[i].second;
}

}  // namespace

std::uint64_t hilbert_index(const Vec3& p, const Box3& box) {
  std::uint32_t axes[3] = {cell(p.x, box.lo.x, box.hi.x), cell(p.y, box.lo.y, box.hi.y),
                           cell(p.z, box.lo.z, box.hi.z)};
  // Coordinates to Hilbert transpose (Skilling 2004): undo the rotations level by level, then Gray-encode.
  for (std::uint32_t q = 1u << (kBits - 1); q > 1; q >>= 1) {
    const std::uint32_t low = q - 1;
    for (std::uint32_t& axis : axes) {
      if (axis & q) {
        axes[0] ^= low;
      } else {
        const std::uint32_t exchange = (axes[0] ^ axis) & low;
        axes[0] ^= exchange;
        axis ^= exchange;
      }
    }
  }
  axes[1] ^= axes[0];
  axes[2] ^= axes[1];
  std::uint32_t gray = 0;
  for (std::uint32_t q = 1u << (kBits - 1); q > 1; q >>= 1)
    if (axes[2] & q) gray ^= q - 1;
  for (std::uint32_t& axis : axes) axis ^= gray;
  return interleave(axes);
}

std::vector<std::uint32_t> insertion_order(std::span<const Vec3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937_64 random(20060605);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);

  Box3 box;
  for (const Vec3& p : points) box.extend(p);
  std::size_t end = order.size();
  while (end > 0) {  // the last round holds 7/8 of the points, the one before 7/8 of the rest, ...
    const std::size_t begin = end > kFirstRound ? end / kGrowth : 0;
    sort_along_curve(std::span(order).subspan(begin, end - begin), points, box);
    end = begin;
  }
  return order;
}

}  // namespace unsliver::delaunay
