// Boxes filled exactly, from the outside: volume and boundary in integers, every guarantee by the independent
// verifier, the tetrahedra by the kernel.
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <map>
#include <random>

#include "delaunay/triangulation.hpp"
#include "exact/quality_signs.hpp"
#include "octree/octree.hpp"
#include "octree/random_forest.hpp"
#include "unsliver/error.hpp"
#include "unsliver/verify.hpp"

namespace unsliver::octree {
namespace {

using Int = std::int64_t;
using Point = std::array<Int, 3>;
__extension__ using Wide = __int128;

struct Job {
  Box3 box;
  SizingPtr size;
};

/// Boxes of 1 to 12 cubes, somewhere; constant and graded sizes, gentle and steep.
Job job_of(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double lo, double hi) {
    return lo + (hi - lo) * double(random() >> 11) * 0x1p-53;
  };
  const double side = std::ldexp(double(1 + 2 * (random() % 10)), int(random() % 8) - 6);
  Job job;
  for (int axis = 0; axis < 3; ++axis) {
    job.box.lo[axis] = side * (double(random() % 65) - 32) / 8;
    job.box.hi[axis] = job.box.lo[axis] + side * double(1 + random() % (axis == 1 ? 3 : 2));
  }
  const Vec3 p = job.box.lo + Vec3{between(0, 1) * side, between(-0.3, 1) * side, 0};
  const double least = between(0.02, 0.3) * side;
  const double slope = std::array{0.1, 0.3, 0.6, 3.0}[seed / 3 % 4];
  const double infinity = std::numeric_limits<double>::infinity();
  const SizingPtr sizes[] = {constant_size(between(0.06, 1.2) * side),
                             graded_from_points({p}, {0.4 * least}, slope, infinity),
                             graded_from_points({p, job.box.hi}, {least, 0.5 * least}, slope, 0.3 * side)};
  job.size = sizes[seed % 3];
  return job;
}

std::uint64_t job_count() { return std::getenv("UNSLIVER_LONG") != nullptr ? 600 : 36; }

/// Runs the test for each job's mesh.
template <class Test>
void for_each_mesh(const Test& test) {
  for (std::uint64_t seed = 1; seed <= job_count(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Job job = job_of(seed);
    const OctreeResult result = mesh_box_octree(job.box, *job.size);
    EXPECT_EQ(result.status, OctreeStatus::kDone);
    ASSERT_FALSE(result.mesh.tets.empty());
    test(job, result.mesh);
  }
}

/// The points as integers, the lower corner at 0, as small as can be.
std::vector<Point> integers(const Box3& box, const TetMesh& mesh) {
  std::vector<Point> points;
  Int all = 0;
  for (const Vec3& p : mesh.points) {
    Point q;
    for (int axis = 0; axis < 3; ++axis) {
      const double steps = (p[axis] - box.lo[axis]) / mesh.frame->unit;
      q[std::size_t(axis)] = Int(steps);
      EXPECT_EQ(box.lo[axis] + mesh.frame->unit * double(q[std::size_t(axis)]), p[axis]);
      all |= q[std::size_t(axis)];
    }
    points.push_back(q);
  }
  const int zeros = std::countr_zero(std::uint64_t(all));
  for (Point& q : points)
    for (Int& c : q) c >>= zeros;
  return points;
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Wide dot(const Point& a, const Point& b) { return Wide(a[0]) * b[0] + Wide(a[1]) * b[1] + Wide(a[2]) * b[2]; }

/// Along each axis.
Point extent(const std::vector<Point>& points) {
  Point most{};
  for (const Point& p : points)
    for (std::size_t axis = 0; axis < 3; ++axis) most[axis] = std::max(most[axis], p[axis]);
  return most;
}

TEST(MeshBoxOctree, TheUnionIsTheBoxExactly) {
  for_each_mesh([](const Job& job, const TetMesh& mesh) {
    Box3 bounds;
    for (const Vec3& p : mesh.points) bounds.extend(p);
    EXPECT_EQ(bounds.lo, job.box.lo);
    EXPECT_EQ(bounds.hi, job.box.hi);
    const std::vector<Point> q = integers(job.box, mesh);
    Wide total = 0;
    for (const auto& t : mesh.tets) {
      const Wide volume =
          dot(minus(q[t[1]], q[t[0]]), cross(minus(q[t[2]], q[t[0]]), minus(q[t[3]], q[t[0]])));
      EXPECT_TRUE(volume > 0);
      total += volume;
    }
    const Point side = extent(q);
    EXPECT_TRUE(total == Wide(6) * side[0] * side[1] * side[2]);
  });
}

TEST(MeshBoxOctree, TrianglesAreTheWholeBoundaryAndLabelsNameTheFaces) {
  for_each_mesh([](const Job& job, const TetMesh& mesh) {
    using Facet = std::array<VertexId, 3>;
    const auto sorted = [](Facet f) {
      std::sort(f.begin(), f.end());
      return f;
    };
    std::map<Facet, int> count;
    for (const auto& t : mesh.tets)
      for (const Facet& f :
           {Facet{t[0], t[1], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[3]}, {t[1], t[2], t[3]}})
        ++count[sorted(f)];
    const auto once = std::count_if(count.begin(), count.end(), [](const auto& c) { return c.second == 1; });
    ASSERT_EQ(mesh.triangles.size(), std::size_t(once));
    ASSERT_EQ(mesh.triangle_labels.size(), mesh.triangles.size());
    const std::vector<Point> q = integers(job.box, mesh);
    const Point side = extent(q);
    Wide area[6] = {};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Facet& f = mesh.triangles[i];
      EXPECT_EQ(count[sorted(f)], 1);
      const int face = mesh.triangle_labels[i] - 1;
      ASSERT_TRUE(face >= 0 && face < 6);
      const auto axis = std::size_t(face / 2);
      for (const VertexId v : f) EXPECT_EQ(q[v][axis], face % 2 == 1 ? side[axis] : 0);
      const Int normal = cross(minus(q[f[1]], q[f[0]]), minus(q[f[2]], q[f[0]]))[axis];
      EXPECT_GT(face % 2 == 1 ? normal : -normal, 0);
      area[face] += std::abs(normal);
    }
    for (std::size_t face = 0; face < 6; ++face)
      EXPECT_TRUE(area[face] == Wide(2) * side[(face / 2 + 1) % 3] * side[(face / 2 + 2) % 3]);
  });
}

TEST(MeshBoxOctree, KeepsEveryGuarantee) {
  for_each_mesh([](const Job& job, const TetMesh& mesh) {
    std::mt19937_64 random(7);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    VerifyOptions options;
    options.guarantee = QualityGuarantee{};
    options.delaunay_global = mesh.tets.size() < 20000;
    options.size = [&](const Vec3& p) { return job.size->at(p); };
    options.inside = [&](const Vec3& p) { return job.box.contains(p); };
    options.size_samples = 20000;
    const Vec3 size = job.box.size();
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = job.box.lo + Vec3{unit() * size.x, unit() * size.y, unit() * size.z};
      if (job.box.contains(p)) options.must_cover.push_back(p);
    }
    options.must_cover.insert(options.must_cover.end(), {job.box.lo, job.box.hi});
    const VerifyReport report = verify(mesh, options);
    EXPECT_TRUE(report.ok);
    for (const Finding& finding : report.findings) ADD_FAILURE() << finding.check << ": " << finding.message;
  });
}

/// The worst places are at the box's faces, which random points miss: all holes of the boundary's lattice.
TEST(MeshBoxOctree, SizeHoldsOnFacesAndEdges) {
  for_each_mesh([](const Job& job, const TetMesh& mesh) {
    constexpr int kSteps = 24;
    const Vec3 size = job.box.size();
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; j <= kSteps; ++j) {
        Vec3 p = job.box.lo;
        p.x = std::min(job.box.hi.x, p.x + size.x * i / kSteps);
        p.y = std::min(job.box.hi.y, p.y + size.y * j / kSteps);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& v : mesh.points) nearest = std::min(nearest, dist_sq(v, p));
        EXPECT_LE(std::sqrt(nearest), job.size->at(p) * (1 + 1e-12));
      }
  });
}

TEST(MeshBoxOctree, TetrahedraAreThoseOfTheKernelTiesIncluded) {
  for_each_mesh([](const Job& job, const TetMesh& mesh) {
    std::vector<Vec3> points;
    for (const Point& q : integers(job.box, mesh))
      points.push_back({double(q[0]), double(q[1]), double(q[2])});
    delaunay::Triangulation dt;
    dt.insert_all(points);
    std::vector<Tet> expected, made;
    for (delaunay::TetId t = 0; t < dt.slot_count(); ++t)
      if (dt.is_finite(t)) expected.push_back(dt.corners(t));
    for (const auto& t : mesh.tets) made.push_back({points[t[0]], points[t[1]], points[t[2]], points[t[3]]});
    EXPECT_EQ(test::sorted(made), test::sorted(expected));
  });
}

TEST(MeshBoxOctree, ThreadsChangeNothing) {
  for_each_mesh([](const Job& job, const TetMesh& mesh) {
    const TetMesh other = mesh_box_octree(job.box, *job.size, {.threads = 3}).mesh;
    EXPECT_EQ(mesh.points, other.points);
    EXPECT_EQ(mesh.tets, other.tets);
    EXPECT_EQ(mesh.triangles, other.triangles);
    EXPECT_EQ(mesh.triangle_labels, other.triangle_labels);
  });
}

TEST(MeshBoxOctree, ConstantSizesNeedNoMoreThanTheLatticesForce) {
  const Box3 cube{{0, 0, 0}, {1, 1, 1}};
  for (const double s : {0.02, 0.03, 0.045, 0.07, 0.1, 0.3, 2.0}) {
    const double radius = mesh_box_octree(cube, *constant_size(s)).stats.radius;
    EXPECT_LE(radius, s);
    EXPECT_GT(radius, std::min(s, 0.866) / 1.55);  // to the next lattice of the chain
  }
  // Cubes of side 3 * 2^k and of side 2^k: the choice is finer.
  for (const double s : {0.7, 1.0, 1.3, 1.7, 2.2})
    EXPECT_GT(mesh_box_octree({{0, 0, 0}, {48, 48, 48}}, *constant_size(s)).stats.radius, s / 1.34);
}

TEST(MeshBoxOctree, CapsEndTheRun) {
  const Box3 cube{{0, 0, 0}, {1, 1, 1}};
  const std::size_t tets = mesh_box_octree(cube, *constant_size(0.1)).mesh.tets.size();
  EXPECT_EQ(mesh_box_octree(cube, *constant_size(0.1), {.max_tets = tets}).status, OctreeStatus::kDone);
  EXPECT_EQ(mesh_box_octree(cube, *constant_size(0.1), {.max_tets = tets - 1}).status, OctreeStatus::kTetCap);
  EXPECT_THROW(mesh_box_octree(cube, *constant_size(0.1), {.threads = 0}), Error);
}

}  // namespace
}  // namespace unsliver::octree
