/// \file
/// Exact comparison of angles with decimal degrees.
#pragma once

#include "prove/angle.hpp"

namespace unsliver::prover {

/// Is |angle - millidegrees / 1000| certainly below a thousandth of a degree? Papers round or truncate.
bool prints_as(const Angle& angle, int millidegrees);

}  // namespace unsliver::prover
