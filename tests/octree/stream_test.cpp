// Meshes that go to a sink are the meshes that come as arrays.
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "octree/octree.hpp"
#include "octree/vertex_chunk.hpp"
#include "unsliver/error.hpp"

namespace unsliver::octree {
namespace {

/// Puts the pieces together, and counts how often each place is written.
class Collector : public MeshSink {
 public:
  void begin(const MeshHead& head) override {
    ++begun;
    mesh.frame = head.frame;
    mesh.points.resize(head.vertices);
    mesh.levels.resize(head.vertices);
    mesh.tets.resize(head.tets);
    point_writes = std::vector<std::atomic<int>>(head.vertices);
    tet_writes = std::vector<std::atomic<int>>(head.tets);
  }
  void points(std::uint64_t first, std::span<const Vec3> points,
              std::span<const std::uint8_t> levels) override {
    EXPECT_EQ(points.size(), levels.size());
    EXPECT_LE(points.size(), kChunkSize);
    EXPECT_EQ(tet_pieces, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      mesh.points.at(first + i) = points[i];
      mesh.levels.at(first + i) = levels[i];
      ++point_writes.at(first + i);
    }
  }
  void tets(std::uint64_t first, std::span<const std::array<VertexId, 4>> tets) override {
    EXPECT_LE(tets.size(), 2 * kChunkSize);
    ++tet_pieces;
    for (std::size_t i = 0; i < tets.size(); ++i) {
      mesh.tets.at(first + i) = tets[i];
      ++tet_writes.at(first + i);
    }
  }

  int begun = 0;
  std::atomic<int> tet_pieces = 0;
  TetMesh mesh;
  std::vector<std::atomic<int>> point_writes, tet_writes;
};

bool all_written_once(const std::vector<std::atomic<int>>& writes) {
  return std::all_of(writes.begin(), writes.end(), [](const auto& count) { return count == 1; });
}

struct Job {
  const char* name;
  DomainPtr domain;
  SizingPtr size;
};

std::vector<Job> jobs() {
  const DomainPtr ball = make_ball({0.1, 0.2, 0.3}, 1);
  const double inf = std::numeric_limits<double>::infinity();
  return {
      {"ball, many chunks", ball, constant_size(0.04)},
      {"ball, larger sizes", ball, constant_size(0.3)},
      {"ball, one leaf or few", ball, constant_size(10)},
      {"ball, graded", ball, graded_from_points({{0.3, 0.2, 0.1}}, {0.005}, 0.2, inf)},
      {"ball, formula", ball, expression_size("0.02 + 0.2 * abs(x)", ball->bounds())},
      {"plate", make_box({{0.7, 0.9, 0.3}, {1.7, 1.95, 0.319}}), constant_size(0.03)},
      {"torus", make_implicit("(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1", {{-1.5, -1.5, -0.5}, {1.5, 1.5, 0.5}}),
       constant_size(0.06)},
  };
}

TEST(Stream, IsTheMeshOfTheArrays) {
  for (const Job& job : jobs()) {
    const OctreeResult whole = mesh_domain_octree(*job.domain, *job.size);
    for (const unsigned threads : {1u, 2u, 3u}) {
      SCOPED_TRACE(std::string(job.name) + ", threads " + std::to_string(threads));
      Collector sink;
      OctreeOptions options;
      options.threads = threads;
      const OctreeResult result = stream_domain_octree(*job.domain, *job.size, sink, options);
      EXPECT_EQ(result.status, OctreeStatus::kDone);
      EXPECT_TRUE(result.mesh.points.empty() && result.mesh.tets.empty());
      EXPECT_EQ(result.stats.vertices, whole.mesh.points.size());
      EXPECT_EQ(result.stats.needed_tets, whole.mesh.tets.size());
      EXPECT_EQ(sink.begun, 1);
      EXPECT_TRUE(all_written_once(sink.point_writes) && all_written_once(sink.tet_writes));
      EXPECT_EQ(sink.mesh.points, whole.mesh.points);
      EXPECT_EQ(sink.mesh.levels, whole.mesh.levels);
      EXPECT_EQ(sink.mesh.tets, whole.mesh.tets);
      EXPECT_EQ(sink.mesh.frame->unit, whole.mesh.frame->unit);
      EXPECT_EQ(sink.mesh.frame->origin, whole.mesh.frame->origin);
    }
  }
}

TEST(Stream, HoldsLessThanArraysDo) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const SizingPtr size = constant_size(0.02);
  Collector sink;
  const OctreeResult result = stream_domain_octree(*ball, *size, sink);
  EXPECT_GT(result.stats.needed_tets, 1'000'000u);
  EXPECT_LT(double(result.stats.peak_bytes), 4.0 * double(result.stats.needed_tets));
}

TEST(Stream, CapsEndItBeforeItBegins) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const SizingPtr size = constant_size(0.05);
  const std::size_t tets = mesh_domain_octree(*ball, *size).mesh.tets.size();
  Collector sink;
  OctreeOptions options;
  options.max_tets = tets - 1;
  EXPECT_EQ(stream_domain_octree(*ball, *size, sink, options).status, OctreeStatus::kTetCap);
  options = {};
  options.max_bytes = 1000;
  EXPECT_EQ(stream_domain_octree(*ball, *size, sink, options).status, OctreeStatus::kMemoryCap);
  EXPECT_EQ(sink.begun, 0);
  options = {};
  options.threads = 0;
  EXPECT_THROW(stream_domain_octree(*ball, *size, sink, options), Error);
}

/// Fails where it is told to.
class FailingSink : public MeshSink {
 public:
  explicit FailingSink(int piece) : left_(piece) {}
  void begin(const MeshHead&) override { count(); }
  void points(std::uint64_t, std::span<const Vec3>, std::span<const std::uint8_t>) override { count(); }
  void tets(std::uint64_t, std::span<const std::array<VertexId, 4>>) override { count(); }

 private:
  void count() {
    if (left_-- == 0) throw std::runtime_error("full");
  }
  std::atomic<int> left_;
};

TEST(Stream, FailuresOfTheSinkReachTheCaller) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  const SizingPtr size = constant_size(0.02);
  for (const int piece : {0, 1, 2, 5, 10})
    for (const unsigned threads : {1u, 3u}) {
      SCOPED_TRACE(piece);
      FailingSink sink(piece);
      OctreeOptions options;
      options.threads = threads;
      EXPECT_THROW(stream_domain_octree(*ball, *size, sink, options), std::runtime_error);
    }
}

TEST(Stream, CanBeCancelledInItsMidst) {
  const DomainPtr ball = make_ball({0, 0, 0}, 1);
  Collector sink;
  Control control;
  control.cancelled = [&] { return sink.tet_pieces > 0; };
  EXPECT_EQ(stream_domain_octree(*ball, *constant_size(0.05), sink, {}, control).status,
            OctreeStatus::kCancelled);
  EXPECT_FALSE(all_written_once(sink.tet_writes));
}

}  // namespace
}  // namespace unsliver::octree
