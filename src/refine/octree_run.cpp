#include "refine/octree_run.hpp"

#include <algorithm>
#include <thread>

namespace unsliver::refine {

namespace {

MeshStatus status_of(octree::OctreeStatus status) {
  switch (status) {
    case octree::OctreeStatus::kDone:
      return MeshStatus::kDone;
    case octree::OctreeStatus::kTetCap:
      return MeshStatus::kTetCap;
    case octree::OctreeStatus::kMemoryCap:
      return MeshStatus::kMemoryCap;
    case octree::OctreeStatus::kCancelled:
      break;
  }
  return MeshStatus::kCancelled;
}

unsigned thread_count(const MeshOptions& options) {
  return options.threads > 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace

octree::OctreeOptions octree_options(const MeshOptions& options) {
  octree::OctreeOptions limits;
  limits.max_tets = options.max_tets;
  limits.max_bytes = options.max_memory_bytes;
  limits.threads = thread_count(options);
  return limits;
}

MeshResult result_of(octree::OctreeResult&& made, const octree::OctreeOptions& limits) {
  MeshResult result;
  result.status = status_of(made.status);
  result.mesh = std::move(made.mesh);
  for (const auto& phase : made.stats.phases) result.stats.phases.push_back({phase.name, phase.seconds});
  result.stats.total_vertices = result.mesh.points.size();
  result.stats.total_tets = result.mesh.tets.size();
  result.stats.peak_bytes = made.stats.peak_bytes;
  result.stats.threads = limits.threads;
  result.stats.domain_tests = made.stats.domain_tests;
  return result;
}

}  // namespace unsliver::refine
