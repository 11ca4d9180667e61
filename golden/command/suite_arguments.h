#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/judge/suite_session.h"

namespace rocinante {

/// Arguments of the subcommands that draw a suite's frames.
struct SuiteArguments : ModelSearch {
  std::filesystem::path suite;
  std::string cell, shard;
  /// Of a run as NAME=FILE, or the suite's.
  std::vector<std::string> logs;
  std::vector<std::string> only, tags, not_tags;
  bool incomplete = false;
  MakeDrawer drawers{};  ///< for tests; empty: the cell's and log's own
};

/// Adds SUITE and its options to a subcommand; parsing fills `arguments`, which must outlive it.
void addSuiteOptions(cli::CommandLine app, SuiteArguments& arguments);
/// Adds --incomplete to subcommands that judge or approve.
void addIncompleteOption(cli::CommandLine app, SuiteArguments& arguments);
/// bad_argument for an invalid shard.
Result<SuiteOptions> suiteOptions(const SuiteArguments& arguments);
/// bad_argument when the suite has no run of that name.
Result<const SuiteRun*> runNamed(const SuiteSession& session, const std::string& name);
/// "rocinante golden VERB SUITE ..." with these arguments, quoted for a shell.
std::string commandText(const char* verb, const SuiteArguments& arguments);

/// Milliseconds of a steady clock.
double steadyMs();
/// "2026-02-03T04:05:06Z".
std::string nowText();
/// The approving user: ROCINANTE_USER, USER, LOGNAME or "uid N".
std::string userName();
/// One line on stderr when the cell has errors, else when its pictures lack what is left out.
void warnOfModelFaults(const Cell& cell);

}  // namespace rocinante
