/// \file
/// Circumspheres that decisions may rest on, however flat the tetrahedron is.
#pragma once

#include "geom/tetrahedron.hpp"

namespace unsliver::refine {

/// The circumsphere of a tetrahedron that is not flat, with integer corners, differences below 2^49: centre
/// and radius to 1e-9 of the radius. (Two close corners far from two others cancel all digits of plain
/// doubles.)
geom::Sphere circumsphere(const Tet& t);

}  // namespace unsliver::refine
