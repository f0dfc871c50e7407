/// \file
/// Points as comma-separated values. The columns are told by a header, or by their number. Lines that start
/// with '#' are comments, but the header may be one.
#include <algorithm>
#include <array>
#include <optional>

#include "io/detect.hpp"
#include "io/fail.hpp"
#include "io/point_checks.hpp"
#include "io/readers.hpp"
#include "io/scanner.hpp"

namespace unsliver::io {
namespace {

constexpr std::string_view kExpected =
    "a CSV file of points: a header with columns x, y, z (and size), or rows of 3 or 4 numbers";

std::string_view trimmed(std::string_view cell) {
  const auto first = cell.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return cell.substr(first, cell.find_last_not_of(" \t") - first + 1);
}

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

// Separators between double quotes belong to the cell.
std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] != separator || quoted) continue;
    cells.push_back(unquoted(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  cells.push_back(unquoted(line.substr(begin)));
  return cells;
}

char separator_of(std::string_view line) {
  for (const char separator : {';', ','})
    if (line.find(separator) != std::string_view::npos) return separator;
  return '\t';
}

// Which columns are x, y, z and the size.
struct Columns {
  static constexpr std::size_t kSize = 3;
  std::array<std::vector<std::size_t>, 4> positions;
  std::size_t count = 0;  // of all columns; 0 = not known yet
};

// The first name is the one that messages use; ParaView writes the others.
constexpr std::array<std::array<std::string_view, 3>, 4> kNames{{
    {"x", "points:0", "points_0"},
    {"y", "points:1", "points_1"},
    {"z", "points:2", "points_2"},
    {"size", "radius", "s"},
}};

std::optional<std::size_t> meaning_of(std::string_view title) {
  const std::string name = lower_case(title);
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (std::count(kNames[i].begin(), kNames[i].end(), name) > 0) return i;
  return std::nullopt;
}

// What the titles say; nothing unless x, y and z are among them.
std::optional<Columns> named_columns(const std::vector<std::string_view>& titles) {
  Columns columns;
  columns.count = titles.size();
  for (std::size_t i = 0; i < titles.size(); ++i)
    if (const auto meaning = meaning_of(titles[i])) columns.positions[*meaning].push_back(i);
  const bool has_axes = std::none_of(columns.positions.begin(), columns.positions.begin() + Columns::kSize,
                                     [](const auto& positions) { return positions.empty(); });
  return has_axes ? std::optional(columns) : std::nullopt;
}

class CsvReader {
 public:
  CsvReader(std::string_view bytes, const std::string& name)
      : scanner_(bytes, name, {.layout = Layout::kLines}) {}

  PointSet read() {
    while (!scanner_.at_end()) read_line(scanner_.line());
    if (set_.points.empty() && columns_.count > 0)
      fail(ErrorCode::kBadInput, "{}: the file has a header, but no points: no line with numbers follows it",
           scanner_.name());
    return std::move(set_);
  }

 private:
  void read_line(std::string_view line) {
    const bool comment = line.starts_with('#');
    if (columns_.count > 0) {
      if (!comment) add_point(split(line, separator_));
      return;
    }
    separator_ = separator_of(line);
    const std::vector<std::string_view> cells = split(line.substr(comment ? 1 : 0), separator_);
    if (const auto columns = named_columns(cells))
      use_header(*columns, cells);
    else if (!comment)
      read_first_row(cells);
  }

  void use_header(const Columns& columns, const std::vector<std::string_view>& titles) {
    columns_ = columns;
    for (const auto& positions : columns.positions)
      if (positions.size() > 1)
        scanner_.fail_here(
            ErrorCode::kFormat,
            fmt::format("columns {} and {} mean the same, {} and {}; keep one", positions[0] + 1,
                        positions[1] + 1, in_quotes(titles[positions[0]]), in_quotes(titles[positions[1]])));
    std::vector<std::string> unused;
    for (const std::string_view title : titles)
      if (!meaning_of(title)) unused.push_back(in_quotes(title));
    if (!unused.empty())
      set_.notes.push_back(fmt::format("{}: columns not used: {}", scanner_.name(), fmt::join(unused, ", ")));
  }

  // Without a header, the columns are x, y, z and perhaps the size.
  void read_first_row(const std::vector<std::string_view>& cells) {
    if (std::none_of(cells.begin(), cells.end(), is_number))
      scanner_.fail_here(ErrorCode::kFormat,
                         fmt::format("expected {}; found {}", kExpected,
                                     in_quotes(fmt::format("{}", fmt::join(cells, ",")))));
    scanner_.at("point", 0);
    if (cells.size() != 3 && cells.size() != 4)
      scanner_.fail_here(ErrorCode::kFormat,
                         fmt::format("the row has {} columns; without a header that names them, 3 (x, y, z) "
                                     "or 4 (and the size) are expected, separated by commas, semicolons or "
                                     "tabs",
                                     cells.size()));
    columns_.count = cells.size();
    for (std::size_t i = 0; i < cells.size(); ++i) columns_.positions[i] = {i};
    add_point(cells);
  }

  void add_point(const std::vector<std::string_view>& cells) {
    scanner_.at("point", set_.points.size());
    if (cells.size() != columns_.count)
      scanner_.fail_here(ErrorCode::kFormat, fmt::format("the row has {} columns, but the first one has {}",
                                                         cells.size(), columns_.count));
    const auto cell = [&](std::size_t meaning) { return cells[columns_.positions[meaning][0]]; };
    set_.points.push_back({scanner_.to_number(cell(0), "coordinate x"),
                           scanner_.to_number(cell(1), "coordinate y"),
                           scanner_.to_number(cell(2), "coordinate z")});
    if (!columns_.positions[Columns::kSize].empty())
      set_.sizes.push_back(to_size(scanner_, cell(Columns::kSize), "the size"));
  }

  Scanner scanner_;
  char separator_ = ',';
  Columns columns_;
  PointSet set_;
};

}  // namespace

PointSet parse_csv(std::string_view bytes, const std::string& name) {
  PointSet set = CsvReader(bytes, name).read();
  if (set.points.empty()) fail_wrong_content(bytes, name, kExpected);
  require_points(set, name);
  return set;
}

}  // namespace unsliver::io
