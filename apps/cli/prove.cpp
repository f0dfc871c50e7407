/// \file
/// `unsliver prove`: decides the claims that the guarantees rest on, by exact enumeration.
#include "unsliver/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "commands.hpp"
#include "files.hpp"
#include "mesh_report.hpp"
#include "progress_display.hpp"
#include "terminal.hpp"
#include "text.hpp"
#include "usage.hpp"

namespace unsliver::cli {
namespace {

constexpr const char* kExamples = R"text(Examples:
  unsliver prove --list
  unsliver prove lemma-5
  unsliver prove all --json proofs.json

"holds": what was found is what is claimed. "differs": it is not; where that is known, a document explains it.
Exit codes: 0 all is as the documents say; 3 it is not.)text";

using Json = nlohmann::ordered_json;

struct ProveOptions {
  std::string name = "all", json;
  bool list = false, quiet = false;
};

std::vector<std::string> names_asked_for(const std::string& name) {
  std::vector<std::string> names;
  for (const Claim& claim : provable_claims()) names.push_back(claim.id);
  if (name == "all") return names;
  if (std::find(names.begin(), names.end(), name) != names.end()) return {name};
  const std::string hint = suggestion(name, names);
  throw Error(ErrorCode::kBadOption, "there is no claim named '" + name + "'" + hint +
                                         (hint.empty() ? "." : "") + " See `unsliver prove --list`");
}

const char* verdict(bool holds) { return holds ? "holds" : "differs"; }

Json to_json(const Proof& proof) {
  Json parts = Json::array();
  for (const ProofPart& part : proof.parts) {
    Json entry{{"claimed", part.claimed}, {"found", part.found}, {"verdict", verdict(part.holds)}};
    entry["explained_in"] = part.explained_in.empty() ? Json() : Json(part.explained_in);
    parts.push_back(entry);
  }
  return {{"id", proof.claim.id},
          {"source", proof.claim.source},
          {"statement", proof.claim.statement},
          {"verdict", verdict(proof.holds())},
          {"as_recorded", proof.is_as_recorded()},
          {"seconds", proof.seconds},
          {"parts", parts}};
}

std::string to_text(const Proof& proof) {
  std::string text = fmt::format("{}: {} ({}, {})\n  {}\n", proof.claim.id, verdict(proof.holds()),
                                 proof.claim.source, human_seconds(proof.seconds), proof.claim.statement);
  for (const ProofPart& part : proof.parts) {
    text += fmt::format("  {:<8}{}\n            found: {}\n", verdict(part.holds), part.claimed, part.found);
    if (!part.explained_in.empty()) text += fmt::format("            explained in {}\n", part.explained_in);
  }
  return text;
}

ExitCode list_claims() {
  std::string text;
  for (const Claim& claim : provable_claims())
    text += fmt::format("  {:<20}{}: {}\n", claim.id, claim.source, claim.statement);
  print_result(text);
  return ExitCode::kDone;
}

ExitCode run(const ProveOptions& options) {
  if (options.list) return list_claims();
  check_report_file(options.json);
  const std::vector<std::string> names = names_asked_for(options.name);
  ProgressDisplay display(!options.quiet && stderr_is_terminal());
  Json proofs = Json::array();
  bool as_recorded = true;
  for (const std::string& name : names) {
    display.show("proving " + name + " ...");
    const Proof proof = decide_claim(name);
    display.clear();
    as_recorded &= proof.is_as_recorded();
    proofs.push_back(to_json(proof));
    if (options.json != "-") print_result(to_text(proof));
  }
  const ExitCode code = as_recorded ? ExitCode::kDone : ExitCode::kBug;
  Json report = json_head("prove", code);
  report["claims"] = proofs;
  if (!options.json.empty()) write_json(options.json, report.dump(2) + "\n");
  return code;
}

}  // namespace

Command add_prove(CLI::App& app) {
  const auto options = std::make_shared<ProveOptions>();
  CLI::App* const parser =
      app.add_subcommand("prove", "Decide the claims that the guarantees rest on, by exact enumeration");
  parser->add_option("NAME", options->name, "a claim, or all")->capture_default_str();
  parser->add_flag("--list", options->list, "say what claims there are");
  parser->add_option("--json", options->json, "report for machines: a file, or - for standard output");
  parser->add_flag("--quiet", options->quiet, "no progress");
  parser->footer(kExamples);
  return {parser, [options] { return run(*options); }};
}

}  // namespace unsliver::cli
