#include "domain/ranges.hpp"

#include <fmt/format.h>

#include "unsliver/error.hpp"

namespace unsliver::domain {

std::string format_point(const Vec3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

void require_usable_range(const Box3& box, const std::string& what) {
  if (!is_finite(box.lo) || !is_finite(box.hi))
    throw Error(ErrorCode::kBadInput,
                fmt::format("{} has a coordinate that is not a finite number: it spans {} to {}", what,
                            format_point(box.lo), format_point(box.hi)));
  const double side = box.longest_side();
  double magnitude = 0;
  for (int axis = 0; axis < 3; ++axis)
    magnitude = std::max({magnitude, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
  if (!(side >= 1e-60 && side <= 1e60 && magnitude <= 1e75))
    throw Error(ErrorCode::kBadInput,
                fmt::format("{} spans {} to {}; its longest side must be between 1e-60 and 1e60 and its "
                            "coordinates below 1e75: scale it",
                            what, format_point(box.lo), format_point(box.hi)));
}

namespace {

void refuse(std::string message, std::size_t id) {
  Error error(ErrorCode::kBadInput, std::move(message));
  error.ids = {static_cast<std::int64_t>(id)};
  throw error;
}

}  // namespace

void require_valid_surface(const TriangleMesh& surface) {
  const std::string name = surface.name.empty() ? "the surface" : surface.name;
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    if (!is_finite(surface.points[i]))
      refuse(fmt::format("point {} of {} has a coordinate that is not a finite number: {}", i, name,
                         format_point(surface.points[i])),
             i);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const VertexId v : surface.triangles[t])
      if (v >= surface.points.size())
        refuse(fmt::format("triangle {} of {} refers to point {}, but there are {} points", t, name, v,
                           surface.points.size()),
               t);
}

}  // namespace unsliver::domain
