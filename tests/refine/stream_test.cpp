// stream_domain: which strategies it serves, and that it is mesh_domain.
#include "unsliver/stream.hpp"

#include <gtest/gtest.h>

#include "unsliver/error.hpp"

namespace unsliver {
namespace {

class Arrays : public MeshSink {
 public:
  void begin(const MeshHead& head) override {
    mesh.points.resize(head.vertices);
    mesh.levels.resize(head.vertices);
    mesh.tets.resize(head.tets);
  }
  void points(std::uint64_t first, std::span<const Vec3> points,
              std::span<const std::uint8_t> levels) override {
    std::copy(points.begin(), points.end(), mesh.points.begin() + std::ptrdiff_t(first));
    std::copy(levels.begin(), levels.end(), mesh.levels.begin() + std::ptrdiff_t(first));
  }
  void tets(std::uint64_t first, std::span<const std::array<VertexId, 4>> tets) override {
    std::copy(tets.begin(), tets.end(), mesh.tets.begin() + std::ptrdiff_t(first));
  }

  TetMesh mesh;
};

const DomainPtr kBall = make_ball({0, 0, 0}, 1);

TEST(StreamDomain, IsMeshDomainPieceByPiece) {
  Arrays sink;
  const StreamResult streamed = stream_domain(*kBall, *constant_size(0.1), sink);
  const MeshResult whole = mesh_domain(*kBall, *constant_size(0.1));
  EXPECT_EQ(streamed.status, MeshStatus::kDone);
  EXPECT_EQ(sink.mesh.points, whole.mesh.points);
  EXPECT_EQ(sink.mesh.levels, whole.mesh.levels);
  EXPECT_EQ(sink.mesh.tets, whole.mesh.tets);
  EXPECT_EQ(streamed.vertices, whole.mesh.points.size());
  EXPECT_EQ(streamed.tets, whole.mesh.tets.size());
  EXPECT_EQ(streamed.limits, *whole.mesh.limits);
  EXPECT_EQ(streamed.stats.strategy, Strategy::kOctree);
  EXPECT_EQ(streamed.stats.total_tets, whole.stats.total_tets);
}

TEST(StreamDomain, RefusesWhatOctreesDoNotMake) {
  Arrays sink;
  for (const Strategy strategy : {Strategy::kThrifty, Strategy::kLiteral, Strategy::kClosure})
    EXPECT_THROW(stream_domain(*kBall, *constant_size(0.1), sink, {.strategy = strategy}), Error);
  const SizingPtr steep = expression_size("0.05 + 0.9 * abs(z)", kBall->bounds());
  EXPECT_NE(choose_strategy({}, *steep, false).strategy, Strategy::kOctree);
  EXPECT_THROW(stream_domain(*kBall, *steep, sink), Error);
  EXPECT_EQ(stream_domain(*kBall, *steep, sink, {.strategy = Strategy::kOctree}).status, MeshStatus::kDone);
  EXPECT_THROW(stream_domain(*kBall, *constant_size(0.1), sink,
                             {.strategy = Strategy::kOctree, .min_dihedral_deg = 31}),
               Error);
}

}  // namespace
}  // namespace unsliver
