/// \file
/// PQR: the atoms of a molecule with charge and radius. Fields are separated by blanks; which of those in the
/// middle are there differs, so a record is read from its end: ... residue-number x y z charge radius.
#include <array>
#include <cctype>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/point_checks.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"

namespace unsliver::io {
namespace {

// With the record's name: number, name, residue, chain (may be absent), residue number, x, y, z, charge,
// radius. The number may be glued to the record's name.
constexpr std::size_t kFewestFields = 9, kMostFields = 11;

struct Record {
  std::array<std::string_view, kMostFields> fields;
  std::size_t size = 0;

  /// 0 = the last field.
  std::string_view from_end(std::size_t i) const { return fields[size - 1 - i]; }
};

bool is_atom(std::string_view word) { return word.starts_with("ATOM") || word.starts_with("HETATM"); }

bool is_residue_number(std::string_view word) {
  if (word.starts_with('-')) word.remove_prefix(1);
  return !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) != 0;
}

[[noreturn]] void fail_fields(const Scanner& scanner, std::size_t found) {
  scanner.fail_here(
      ErrorCode::kFormat,
      fmt::format("the record has {} fields; expected '{}' or the same without the chain",
                  found > kMostFields ? "more than " + std::to_string(kMostFields) : std::to_string(found),
                  "ATOM number name residue chain residue-number x y z charge radius"));
}

Record read_record(Scanner& scanner) {
  Record record;
  while (!scanner.at_line_end()) {
    const std::string_view field = scanner.word("a field");
    if (record.size == kMostFields) fail_fields(scanner, kMostFields + 1);
    record.fields[record.size++] = field;
  }
  if (record.size < kFewestFields) fail_fields(scanner, record.size);
  return record;
}

void add_atom(Scanner& scanner, PointSet& set) {
  scanner.at("atom", set.points.size());
  const Record record = read_record(scanner);
  if (!is_residue_number(record.from_end(5)))
    scanner.fail_here(ErrorCode::kFormat,
                      fmt::format("expected a residue number before x y z charge radius, found {}; is a "
                                  "field missing?",
                                  in_quotes(record.from_end(5))));
  set.points.push_back({scanner.to_number(record.from_end(4), "coordinate x"),
                        scanner.to_number(record.from_end(3), "coordinate y"),
                        scanner.to_number(record.from_end(2), "coordinate z")});
  set.sizes.push_back(to_size(scanner, record.from_end(0), "the radius"));
  scanner.at_none();
}

}  // namespace

PointSet parse_pqr(std::string_view bytes, const std::string& name) {
  Scanner scanner(bytes, name, {.layout = Layout::kLines});
  PointSet set;
  while (!scanner.at_end()) {
    if (is_atom(scanner.peek())) add_atom(scanner, set);
    scanner.skip_line();
  }
  if (set.points.empty()) fail_wrong_content(bytes, name, "a PQR file with ATOM or HETATM records");
  require_points(set, name);
  return set;
}

}  // namespace unsliver::io
