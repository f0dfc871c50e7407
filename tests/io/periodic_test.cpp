#include <sstream>

#include "io/msh_periodic.hpp"
#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

/// Two tetrahedra across the upper x face of the unit cube: enough to be written and read, not a torus.
TetMesh sample() {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {1, 0, 0}};
  mesh.tets = {{0, 1, 2, 3}, {1, 4, 2, 3}};
  mesh.triangles = {{0, 2, 3}, {4, 3, 2}};
  mesh.triangle_labels = {periodic_face_label(-1, 0, 0), periodic_face_label(1, 0, 0)};
  Periodicity& p = mesh.periodicity.emplace();
  p.cell = {{0, 0, 0}, {1, 1, 1}};
  p.home = {0, 1, 2, 3, 0};
  p.shift = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  return mesh;
}

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(Periodic, FaceLabelsNameShifts) {
  for (int label = 1; label <= 27; ++label) {
    const auto s = periodic_face_shift(label);
    EXPECT_EQ(periodic_face_label(s[0], s[1], s[2]), label);
    EXPECT_EQ(periodic_face_label(-s[0], -s[1], -s[2]), 28 - label);
  }
}

TEST(Periodic, VtuKeepsHomesAndShifts) {
  const TemporaryFolder folder;
  write_tet_mesh(folder / "a.vtu", sample());
  const TetMesh read = read_tet_mesh(folder / "a.vtu");
  ASSERT_TRUE(read.periodicity);
  EXPECT_EQ(read.periodicity->home, sample().periodicity->home);
  EXPECT_EQ(read.periodicity->shift, sample().periodicity->shift);
  EXPECT_EQ(read.periodicity->cell.hi, (Vec3{1, 1, 1}));
  TetMesh plain = sample();
  plain.periodicity.reset();
  write_tet_mesh(folder / "b.vtu", plain);
  EXPECT_FALSE(read_tet_mesh(folder / "b.vtu").periodicity);
}

TEST(Periodic, NodesOfFacesArePaired) {
  const std::vector<PeriodicFaces> faces = periodic_faces(sample());
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].label, periodic_face_label(1, 0, 0));
  EXPECT_EQ(faces[0].master, periodic_face_label(-1, 0, 0));
  EXPECT_EQ(faces[0].moved, (Vec3{1, 0, 0}));
  EXPECT_EQ(faces[0].nodes, (std::vector<std::pair<VertexId, VertexId>>{{4, 0}}));
  TetMesh plain = sample();
  plain.periodicity.reset();
  EXPECT_TRUE(periodic_faces(plain).empty());
}

TEST(Periodic, GmshFilesSayWhichNodesAreCopies) {
  const TemporaryFolder folder;
  for (const std::string format : {"msh22", "msh41"})
    for (const bool ascii : {true, false}) {
      SCOPED_TRACE(format + (ascii ? ", text" : ", binary"));
      WriteOptions options;
      options.format = format;
      options.ascii = ascii;
      write_tet_mesh(folder / "a.msh", sample(), options);
      const std::string text = text_of(folder / "a.msh");
      EXPECT_NE(text.find("$Periodic\n"), std::string::npos);
      EXPECT_NE(text.find("$EndPeriodic\n"), std::string::npos);
      if (ascii) {
        EXPECT_NE(text.find("\n2 15 13\n"), std::string::npos);
        EXPECT_NE(text.find("\n1\n5 1\n$EndPeriodic"), std::string::npos);
      }
      EXPECT_EQ(read_tet_mesh(folder / "a.msh").tets, sample().tets);
    }
}

}  // namespace
}  // namespace unsliver::io
