#include <cstdlib>

#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

TEST(RealData, SurfacesHaveTheirKnownSizes) {
  const char* folder = std::getenv("UNSLIVER_DATA");
  if (!folder) GTEST_SKIP() << "UNSLIVER_DATA names no folder";
  struct Known {
    const char* file;
    std::size_t points, triangles;
  };
  for (const Known& known :
       {Known{"anchor.off", 519, 1050}, Known{"boeing_soup.off", 2741, 2564},
        Known{"cubes_nonmanifold.off", 14, 24}, Known{"joint.obj", 221, 446},
        Known{"knot2_linked.off", 5760, 11520}, Known{"self_intersectA.obj", 8582, 17160},
        Known{"spot.obj", 2930, 5856}, Known{"triceratops.off", 2832, 5660}}) {
    SCOPED_TRACE(known.file);
    const TriangleMesh mesh = read_surface(std::filesystem::path(folder) / known.file);
    EXPECT_EQ(mesh.points.size(), known.points);
    EXPECT_EQ(mesh.triangles.size(), known.triangles);
  }
}

TEST(RealData, LargeCoordinatesAreKept) {
  const char* folder = std::getenv("UNSLIVER_DATA");
  if (!folder) GTEST_SKIP() << "UNSLIVER_DATA names no folder";
  const TriangleMesh mesh = read_surface(std::filesystem::path(folder) / "step_bigcoords.off");
  ASSERT_EQ(mesh.points.size(), 10u);
  EXPECT_EQ(mesh.points[0], (Vec3{-25.198211669921875, -650.77587890625, 1174.5123291015625}));
}

}  // namespace
}  // namespace unsliver::io
