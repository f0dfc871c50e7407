#include "prove/watched.hpp"

#include <algorithm>
#include <cmath>

namespace unsliver::prover {

void Watched::see(const Enclosure& x_sq, const Enclosure& bound_sq) {
  ++count;
  holds &= x_sq.hi() <= bound_sq.lo();
  worst_share = std::max(worst_share, std::sqrt(middle(x_sq) / middle(bound_sq)));
}

void Watched::include(const Watched& other) {
  count += other.count;
  holds &= other.holds;
  worst_share = std::max(worst_share, other.worst_share);
}

ProofPart watched_part(const std::string& claimed, const Watched& watched) {
  return part(claimed,
              fmt::format("{} times, at most {:.2f} of the bound", watched.count, watched.worst_share),
              watched.count > 0 && watched.holds);
}

}  // namespace unsliver::prover
