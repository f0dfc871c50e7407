/// \file
/// The judgement behind `unsliver check`, of meshes that fit into memory, without a terminal or files. Shared
/// with the Python package.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "check_report.hpp"
#include "unsliver/progress.hpp"

namespace unsliver::cli {

/// What to hold a mesh to, beyond what it promises itself.
struct CheckDemands {
  std::optional<double> min_angle, max_angle, max_radius_edge;
  std::size_t worst = 5;  ///< tetrahedra to list
};

/// \throws Error kBadOption for a bound that no angle or ratio can meet.
void check_demands(const CheckDemands& demands);

/// What is due of a mesh (what its maker says; may be nothing), each limit replaced by what is demanded.
std::optional<QualityLimits> limits_to_hold(const CheckDemands& demands,
                                            const std::optional<QualityLimits>& due);

/// Is a point in the solid that the surface bounds?
std::function<bool(const Vec3&)> inside_of(const TriangleMesh& surface);

/// Exit code and rounded extremes, once the report is filled in.
void conclude(CheckReport& report);

/// With `against`, the surface's vertices must be covered, by meshes of unsliver all of the solid. The names
/// of files are left to the caller.
CheckReport check_mesh(const TetMesh& mesh, const TriangleMesh* against, const CheckDemands& demands,
                       const Control& control);

}  // namespace unsliver::cli
