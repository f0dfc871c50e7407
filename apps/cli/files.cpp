#include "files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "interrupts.hpp"
#include "terminal.hpp"
#include "unsliver/error.hpp"
#include "unsliver/io.hpp"

namespace unsliver::cli {
namespace {

namespace fs = std::filesystem;

/// File systems take 255 bytes; what is being written has a suffix.
constexpr std::size_t kLongestName = 230;

bool among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

fs::path directory_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : "."; }

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw Error(ErrorCode::kIo, fmt::format("{}: {}", path.string(), what));
}

/// A device or a pipe: written directly, for nothing can be renamed onto it.
bool is_special(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  const auto plain = [&](const fs::path& p) {
    return fs::weakly_canonical(fs::absolute(p, ignored), ignored);
  };
  return fs::equivalent(a, b, ignored) || plain(a) == plain(b);
}

bool is_tetgen_file(const fs::path& path) { return among({"node", "ele", "face"}, extension_of(path)); }

/// The extension that a format of meshes goes by.
std::string extension_for(const std::string& format) {
  if (format == "tetgen") return "node";
  if (format == "medit") return "mesh";
  return format.substr(0, 3);  // msh22, msh41 and vtu
}

/// The files behind each name: TetGen's come in threes.
std::vector<fs::path> files_behind(const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  for (const fs::path path : names) {
    if (path.empty() || path == "-" || is_special(path)) continue;
    files.push_back(path);
    if (!is_tetgen_file(path)) continue;
    for (const std::string other : {"node", "ele", "face"})
      if (other != extension_of(path)) files.push_back(fs::path(path).replace_extension(other));
  }
  return files;
}

/// All of `content` at `path`, or 0 < errno.
int store(const fs::path& path, const std::string& content) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), std::fclose);
  if (!file) return errno;
  const bool stored = std::fwrite(content.data(), 1, content.size(), file.get()) == content.size() &&
                      std::fflush(file.get()) == 0;
  return stored ? 0 : errno;
}

/// By its extension. \throws Error kBadOption.
void check_has_format(const fs::path& path) {
  if (is_tet_mesh_file(path)) return;
  const std::string extension = extension_of(path);
  const std::string fault = extension.empty() ? "the name has no extension, which would say the format"
                                              : "no mesh format has the extension \"." + extension + "\"";
  throw Error(ErrorCode::kBadOption,
              fmt::format("{}: {}; use .vtu, .msh, .mesh or .node, or say --format", path.string(), fault));
}

/// TetGen's three files are told by extension alone. \throws Error kBadOption.
void check_goes_by(const fs::path& path, const std::string& format) {
  const std::string wanted = extension_for(format);
  const bool fits =
      format == "tetgen" ? is_tetgen_file(path) : !is_tet_mesh_file(path) || extension_of(path) == wanted;
  if (!fits)
    throw Error(ErrorCode::kBadOption,
                fmt::format("{}: --format {} goes by the extension .{}; change one of them", path.string(),
                            format, wanted));
}

}  // namespace

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

bool is_point_file(const fs::path& path) { return among(io::point_formats(), extension_of(path)); }
bool is_surface_file(const fs::path& path) { return among(io::surface_formats(), extension_of(path)); }
bool is_tet_mesh_file(const fs::path& path) {
  static const std::vector<std::string> kExtensions = {"vtu", "msh", "mesh", "node", "ele", "face"};
  return among(kExtensions, extension_of(path));
}

void check_writable(const fs::path& path, const std::string& option) {
  std::error_code ignored;
  const fs::path directory = directory_of(path);
  if (!fs::is_directory(directory, ignored))
    fail(path, fmt::format("{} cannot be written: there is no directory {}", option, directory.string()));
  if (fs::is_directory(path, ignored))
    fail(path, fmt::format("{} cannot be written: it is a directory", option));
  if (path.filename().string().size() > kLongestName)
    fail(path, fmt::format("{} cannot be written: the name is too long", option));
  if (is_special(path)) {
    if (access(path.c_str(), W_OK) != 0) fail(path, option + " cannot be written: no permission");
  } else if (access(directory.c_str(), W_OK) != 0) {
    fail(path,
         fmt::format("{} cannot be written: no permission to write into {}", option, directory.string()));
  }
}

void check_report_file(const std::string& path) {
  if (path.empty() || path == "-") return;
  if (is_tet_mesh_file(path) || is_surface_file(path) || is_point_file(path))
    throw Error(
        ErrorCode::kBadOption,
        path + ": --json would write a report into a file for geometry: give it a name like report.json");
  check_writable(path, "--json");
}

void check_mesh_output(const fs::path& path, const std::string& format) {
  if (path == "-")
    throw Error(ErrorCode::kBadOption,
                "-: a mesh goes into a file; /dev/stdout with --quiet is standard output");
  if (format.empty())
    check_has_format(path);
  else
    check_goes_by(path, format);
  check_writable(path, "the output");
}

void check_distinct(const std::vector<std::string>& written, const std::vector<std::string>& read) {
  const std::vector<fs::path> outputs = files_behind(written), inputs = files_behind(read);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto is_this = [&](const fs::path& other) { return same_file(outputs[i], other); };
    const auto later = outputs.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    if (std::any_of(inputs.begin(), inputs.end(), is_this))
      throw Error(ErrorCode::kBadOption,
                  outputs[i].string() + " would overwrite an input: give the output another name");
    if (std::any_of(later, outputs.end(), is_this))
      throw Error(ErrorCode::kBadOption,
                  outputs[i].string() + " would hold two results: give each a file of its own");
  }
}

void check_readable(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) fail(path, "there is no such file");
  if (fs::is_directory(path, ignored)) fail(path, "this is a directory, not a file");
  if (access(path.c_str(), R_OK) != 0) fail(path, "no permission to read it");
}

void write_file(const fs::path& path, const std::string& content) {
  const interrupts::Hold hold(interrupts::Hold::For::kFile);
  const bool special = is_special(path);
  const fs::path stored = special ? path : fs::path(path.string() + fmt::format(".{}.part", getpid()));
  int failure = store(stored, content);
  if (failure == 0 && !special && std::rename(stored.c_str(), path.c_str()) != 0) failure = errno;
  if (failure == 0) return;
  if (!special) std::remove(stored.c_str());
  fail(path, fmt::format("cannot be written: {}", std::strerror(failure)));
}

void write_json(const std::string& path, const std::string& content) {
  if (path == "-")
    print_result(content);
  else
    write_file(path, content);
}

}  // namespace unsliver::cli
