/// \file
/// From a balanced forest to vertices and tetrahedra: choose, number, write.
///
/// The forest is cut into tasks, subtrees of about equal size in depth-first order; what a task makes goes to
/// its own part of the result, so that the result does not depend on the number of threads.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "octree/forest.hpp"
#include "octree/guest.hpp"
#include "octree/template_table.hpp"
#include "octree/uniform.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::octree {

class Emission {
 public:
  struct Settings {
    unsigned threads = 1;
    /// Is a tetrahedron (world coordinates) to be kept? Asked for those of leaves that are neither kInside
    /// nor kOutside; called from all threads.
    std::function<bool(const Tet&)> keep;
    /// Called now and then from the calling thread; may throw.
    std::function<void()> poll;
    /// To be asked about leaves that are kDisturbed, may be null if there are none.
    const Guest* guest = nullptr;
  };

  /// Requires a balanced forest, which must outlive this.
  Emission(Forest& forest, Settings settings);

  /// --- In this order:
  /// Chooses the tetrahedra, and marks the vertices that they use.
  void choose();
  /// Numbers the vertices in use from `first` on: in order of their owners, depth first. \throws Error kLimit
  /// at 2^31.
  void number(VertexId first = 0);
  /// Calls place(number, world point, its owner, the thread's number) for each vertex, from all threads; in
  /// each ascending, but for jumps.
  void write_points(const std::function<void(VertexId, const Vec3&, const Cell&, unsigned)>& place);
  /// Writes tet_count() tetrahedra, positively oriented.
  void write_tets(std::array<VertexId, 4>* out);
  /// Or hands them over, some at a time with the number of the first, from all threads.
  using TakeTets = std::function<void(std::uint64_t, std::span<const std::array<VertexId, 4>>)>;
  void stream_tets(const TakeTets& take);

  std::uint64_t tet_count() const { return tet_count_; }
  std::uint64_t vertex_count() const { return vertex_count_; }  ///< `first` included
  std::uint64_t leaf_count() const { return leaf_count_; }      ///< that own tetrahedra that may be kept
  std::uint64_t tested_tets() const { return tested_tets_; }
  std::size_t template_count() const { return templates_.size(); }
  std::size_t bytes() const;

 private:
  struct Task {
    Cell cell;
    std::uint64_t leaves = 0, tested = 0, tets = 0, vertices = 0;
    std::uint64_t first_tet = 0, first_vertex = 0;
    std::vector<std::uint64_t> kept =
        {};  ///< one bit a tested tetrahedron, in order; words start anew at each leaf
  };
  class Chooser;
  class Writer;
  class Streamer;

  template <class Visitor>
  void visit_leaves_of(const Task& task, Visitor& visitor) const;
  template <class Visit>
  void run_tasks(const Visit& visit);

  Forest& forest_;
  Settings settings_;
  std::vector<Task> tasks_;
  UniformPattern uniform_;
  TemplateStore templates_;
  std::vector<TemplateCache> caches_;  ///< one a thread
  std::uint64_t tet_count_ = 0, vertex_count_ = 0, leaf_count_ = 0, tested_tets_ = 0;
};

}  // namespace unsliver::octree
