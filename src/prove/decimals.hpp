/// \file
/// Exact comparison of angles with decimal degrees.
#pragma once

#include "prove/angle.hpp"
#include "prove/enclosure.hpp"

namespace unsliver::prover {

/// Is |angle - millidegrees / 1000| certainly below a thousandth of a degree? Papers round or truncate.
bool prints_as(const Angle& angle, int millidegrees);
/// The same for an angle given by sign(cos) cos^2.
bool prints_as(const Enclosure& signed_cos_sq, int millidegrees);
/// Is the angle certainly below?
bool is_below(const Enclosure& signed_cos_sq, int millidegrees);
/// Is |x - thousandths / 1000| certainly below a thousandth, for x^2 >= 0 given?
bool root_prints_as(const Enclosure& x_sq, int thousandths);

/// For people: "30", "19.47122".
std::string degrees_text(const Enclosure& signed_cos_sq);
/// "17.023"
std::string thousandths_text(int thousandths);

}  // namespace unsliver::prover
