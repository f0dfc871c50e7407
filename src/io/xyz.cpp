/// \file
/// XYZ, text: one point a line, or the chemists' form with the number of atoms, a comment and the elements.
#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/point_checks.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"

namespace unsliver::io {
namespace {

constexpr std::string_view kExpected =
    "an XYZ file: lines 'x y z', or a line with the number of atoms, a comment line and lines 'element x y "
    "z'";

bool starts_with_count(Scanner scanner) {
  scanner.word("a word");
  return scanner.at_line_end();
}

std::vector<Vec3> read_rows(Scanner& scanner) {
  std::vector<Vec3> points;
  while (!scanner.at_end()) {
    scanner.at("point", points.size());
    points.push_back(read_point(scanner));
    if (!scanner.at_line_end())
      scanner.fail_here(ErrorCode::kFormat,
                        "the line has more than the 3 columns x y z; remove the others, or write a CSV file "
                        "whose header names them (x,y,z,size)");
  }
  return points;
}

// Whatever follows the coordinates of an atom (charges, forces) is skipped.
std::vector<Vec3> read_atoms(Scanner& scanner) {
  const std::size_t count = scanner.count("atoms", sizeof("H 0 0 0"));
  scanner.skip_line();
  scanner.skip_line();  // the comment, which may look like anything
  std::vector<Vec3> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    scanner.at("atom", i);
    scanner.next_line("an atom (the file's second line is a comment)");
    scanner.word("an element");
    points[i] = read_point(scanner);
    scanner.skip_line();
  }
  return points;
}

void require_one_frame(Scanner& scanner, std::size_t atoms) {
  scanner.at_none();
  if (scanner.at_end()) return;
  scanner.word("a word");
  scanner.fail_here(ErrorCode::kUnsupported,
                    fmt::format("more lines follow the {} atoms that were declared; keep one frame", atoms));
}

}  // namespace

PointSet parse_xyz(std::string_view bytes, const std::string& name) {
  Scanner scanner(bytes, name, {.comment = '#', .layout = Layout::kLines});
  if (!is_number(scanner.peek())) fail_wrong_content(bytes, name, kExpected);
  PointSet set;
  if (starts_with_count(scanner)) {
    set.points = read_atoms(scanner);
    require_one_frame(scanner, set.points.size());
  } else {
    set.points = read_rows(scanner);
  }
  require_points(set, name);
  return set;
}

}  // namespace unsliver::io
