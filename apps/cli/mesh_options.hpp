/// \file
/// The options of `unsliver mesh` and `unsliver refine`, checked as far as they can be without reading
/// anything.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "domain_source.hpp"
#include "size_request.hpp"
#include "unsliver/io.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::cli {

struct MeshCommandOptions {
  DomainRequest domain;
  SizeRequest size;
  MeshOptions mesh;
  std::string strategy = "auto";
  std::optional<double> max_radius_edge;  ///< as typed
  std::optional<unsigned> threads;        ///< as typed; none = one for each core
  std::string max_tets, max_memory;       ///< as typed; empty = none
  std::string output;
  std::string stream;  ///< the folder that takes its place; empty = none
  io::WriteOptions write;
  std::string topology;  ///< the file of a periodic mesh's topology; empty = none
  std::string json;      ///< a path, "-" for standard output, empty for none
  bool keep_partial = false, no_verify = false, quiet = false;
};

/// --format and --ascii, shared by the commands that write meshes.
void add_write_options(CLI::App& parser, io::WriteOptions& write);
/// \throws Error kBadOption or kIo: --ascii without effect, an unknown extension, a path that is not
/// writable.
void check_write_options(const std::string& output, const io::WriteOptions& write);

/// Of `unsliver mesh` and of `unsliver refine`.
void add_mesh_options(CLI::App& parser, MeshCommandOptions& options);
void add_refine_options(CLI::App& parser, MeshCommandOptions& options);

/// What must hold before even a report of failure may be written: the report has a place, and no file is in
/// the way of another. \throws Error.
void check_mesh_files(const MeshCommandOptions& options);

/// Derives what was typed as text and refuses what contradicts itself or has no effect. \throws Error.
void check_mesh_options(MeshCommandOptions& options);

}  // namespace unsliver::cli
