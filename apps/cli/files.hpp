/// \file
/// Small files of our own, and what can be known of a path before a long run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace unsliver::cli {

/// The extension in lower case, without the dot.
std::string extension_of(const std::filesystem::path& path);

bool is_surface_file(const std::filesystem::path& path);
bool is_tet_mesh_file(const std::filesystem::path& path);
bool is_point_file(const std::filesystem::path& path);

/// Refuses a path whose directory is missing or not writable, or that is itself a directory.
/// \throws Error kIo naming the path and `option`.
void check_writable(const std::filesystem::path& path, const std::string& option);

/// Where --json goes: standard output ("-"), nowhere (""), or a writable file whose name is not that of a
/// mesh, a surface or points, which it would overwrite. \throws Error kIo or kBadOption.
void check_report_file(const std::string& path);

/// check_writable, and the extension is one that tetrahedral meshes are written in; if there is a `format`,
/// none of another one. \throws Error kIo or kBadOption.
void check_mesh_output(const std::filesystem::path& path, const std::string& format);

/// No file is both written and read, or written twice, under whatever names. Empty paths, "-", devices and
/// pipes count as none; a TetGen file stands for its companions too. \throws Error kBadOption.
void check_distinct(const std::vector<std::string>& written, const std::vector<std::string>& read);

/// \throws Error kIo when nothing can be read there.
void check_readable(const std::filesystem::path& path);

/// Writes under a temporary name in the same directory and renames; on failure nothing is left behind.
/// \throws Error kIo.
void write_file(const std::filesystem::path& path, const std::string& content);

/// write_file, or standard output where the path is "-".
void write_json(const std::string& path, const std::string& content);

}  // namespace unsliver::cli
