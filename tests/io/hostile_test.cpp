// Readers on damaged files: whatever the bytes, an Error or a usable mesh. The seeds are files of ours and
// small files by hand; libFuzzer does the same at length (tests/fuzz).
#include <cstdlib>
#include <random>

#include "fuzz/fuzz_reader.hpp"
#include "io/readers.hpp"
#include "io_test_util.hpp"
#include "unsliver/io.hpp"

namespace unsliver::io {
namespace {

using fuzz::check_reader;

// Words that have broken readers before: large counts, signs, not-a-numbers.
constexpr std::string_view kNastyWords[] = {"4294967295",
                                            "-1",
                                            "0",
                                            "18446744073709551615",
                                            "9223372036854775807",
                                            "nan",
                                            "inf",
                                            "1e999",
                                            "",
                                            " ",
                                            "\n",
                                            "#",
                                            "-",
                                            "\xff\xff\xff\xff",
                                            std::string_view("\0\0\0\0\0\0\0\x80", 8)};

std::string damaged(std::string bytes, std::mt19937_64& random) {
  for (std::uint64_t edits = 1 + random() % 4; edits > 0 && !bytes.empty(); --edits) {
    const std::size_t at = random() % bytes.size();
    const std::size_t length = std::min<std::size_t>(random() % 12, bytes.size() - at);
    switch (random() % 5) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(random() % bytes.size(), length));
        break;
      case 4:
        bytes.replace(at, length, kNastyWords[random() % std::size(kNastyWords)]);
        break;
    }
  }
  return bytes;
}

template <class Parse>
void expect_sturdy(const std::vector<std::string>& seeds, const Parse& parse) {
  const int rounds = std::getenv("UNSLIVER_LONG") ? 200000 : 3000;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    ASSERT_NO_THROW(parse(seeds[i])) << "seed file " << i << " itself must be good";
    for (std::size_t size = 0; size < std::min<std::size_t>(seeds[i].size(), 600); ++size)
      check_reader(std::string_view(seeds[i]).substr(0, size), parse);
    std::mt19937_64 random(i);
    for (int round = 0; round < rounds; ++round) check_reader(damaged(seeds[i], random), parse);
  }
}

std::string written(const char* format, const char* name, bool ascii = false) {
  TemporaryFolder folder;
  write_tet_mesh(folder / name, sample_mesh(), {.format = format, .ascii = ascii, .min_dihedral_deg = {}});
  return get_file(folder / name);
}

TEST(Hostile, Stl) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  std::string binary(80, '\0');
  binary += std::string("\2\0\0\0", 4) + std::string(100, '\0');
  expect_sturdy({"solid a\n" + facet + facet + "endsolid a\n", binary},
                [](std::string_view bytes) { return parse_stl(bytes, "fuzz"); });
}

TEST(Hostile, Obj) {
  expect_sturdy({"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1/2/3 2//3 -1\n"},
                [](std::string_view bytes) { return parse_obj(bytes, "fuzz"); });
}

TEST(Hostile, Off) {
  expect_sturdy({"OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n4 0 1 2 3\n"},
                [](std::string_view bytes) { return parse_off(bytes, "fuzz"); });
}

TEST(Hostile, Ply) {
  const std::string head =
      " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const std::string corners("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  expect_sturdy({"ply\nformat ascii" + head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                 "ply\nformat binary_little_endian" + head + std::string(36, '\0') + corners},
                [](std::string_view bytes) { return parse_ply(bytes, "fuzz"); });
}

TEST(Hostile, Vtu) {
  expect_sturdy({written("vtu", "a.vtu")}, [](std::string_view bytes) { return parse_vtu(bytes, "fuzz"); });
}

TEST(Hostile, Msh) {
  expect_sturdy({written("msh22", "a.msh"), written("msh22", "a.msh", true), written("msh41", "a.msh"),
                 written("msh41", "a.msh", true)},
                [](std::string_view bytes) { return parse_msh(bytes, "fuzz"); });
}

TEST(Hostile, Medit) {
  expect_sturdy({written("medit", "a.mesh")},
                [](std::string_view bytes) { return parse_medit(bytes, "fuzz"); });
}

TEST(Hostile, Tetgen) {
  TemporaryFolder folder;
  write_tet_mesh(folder / "a.node", sample_mesh());
  const std::string node = get_file(folder / "a.node"), ele = get_file(folder / "a.ele"),
                    face = get_file(folder / "a.face");
  expect_sturdy({node}, [&](std::string_view bytes) { return parse_tetgen({bytes, ele, face}, "fuzz"); });
  expect_sturdy({ele}, [&](std::string_view bytes) { return parse_tetgen({node, bytes, face}, "fuzz"); });
  expect_sturdy({face}, [&](std::string_view bytes) { return parse_tetgen({node, ele, bytes}, "fuzz"); });
}

TEST(Hostile, Points) {
  expect_sturdy({"0 0 0\n1 0 0\n# two\n0 1 1e5\n", "2\nwater\nO 0 0 0\nH 1 0 0 .5\n"},
                [](std::string_view bytes) { return parse_xyz(bytes, "fuzz"); });
  expect_sturdy({"0,0,0\n1,0,0\n", "id,\"y\",x,s,Z\n1,2,3,4,5\n1,\"2\",3,4,5\n", "#x;y;z;u\n1;2;3;,\n"},
                [](std::string_view bytes) { return parse_csv(bytes, "fuzz"); });
  expect_sturdy({"REMARK 1\nATOM 1 N MET A 1 0 0 0 0 1.5\nHETATM 2 O HOH 2 1 1 1 0 1\nEND\n"},
                [](std::string_view bytes) { return parse_pqr(bytes, "fuzz"); });
  expect_sturdy({"2 3 1 0\n1 0 0 0 7\n2 1 0 0 7\n"},
                [](std::string_view bytes) { return parse_node(bytes, "fuzz"); });
}

}  // namespace
}  // namespace unsliver::io
