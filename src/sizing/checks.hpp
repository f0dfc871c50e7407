/// \file
/// What every sizing function checks and says in the same words.
#pragma once

#include <string>
#include <string_view>

#include "unsliver/types.hpp"

namespace unsliver::sizing {

/// "(1, 2.5, -3)".
std::string to_text(const Vec3& p);
std::string to_text(const Box3& box);

/// s itself if s > 0 (infinity included). \throws Error kBadInput naming p and s.
double checked_size(double s, const Vec3& p, std::string_view origin);

/// \throws Error kBadOption unless value is finite and > 0; `name` says what it is.
void require_positive(double value, std::string_view name);
/// \throws Error kBadOption unless gradation is finite and >= 0, and cap > 0 (it may be infinite).
void require_grading(double gradation, double cap);
/// \throws Error kBadInput unless the box is finite with positive sides.
void require_bounds(const Box3& bounds);

/// The nearest point of the box.
Vec3 clamped(const Vec3& p, const Box3& box);
/// The nearest points of `bounds` to all points of the box.
Box3 clamped(const Box3& box, const Box3& bounds);
/// The box with every face moved outwards by `margin`.
Box3 inflated(const Box3& box, double margin);

}  // namespace unsliver::sizing
