#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/behaviour/run_spec.h"
#include "core/cli/program.h"
#include "golden/approval/approval_list.h"
#include "golden/command/report_output.h"
#include "golden/command/suite_arguments.h"
#include "golden/judge/judged_run.h"

namespace rocinante {

// The sub-commands of `rocinante golden` (docs/programs/golden.md), each in a file of its name.
// `addNAMECommand` adds one to `app`; parsing fills `arguments`, which must outlive it.

/// Arguments of `rocinante golden run`.
struct RunArguments {
  SuiteArguments suite;
  ReportFiles files;
  bool verbose = false;          ///< links, figures and maps of each frame
  bool pages = false;            ///< of the sessions, beside the report
  std::filesystem::path viewer;  ///< folder of what they are made of; empty: the installed one
  int jobs = 1;                  ///< 0: by the number of frames and processors
};
cli::CommandLine addRunCommand(cli::CommandLine app, RunArguments& arguments);
/// Draws every frame, judges it, writes the reports and prints the verdicts.
Result<cli::Exit> runSuiteCommand(const RunArguments& arguments);

/// Arguments of `rocinante golden approve`.
struct ApproveArguments {
  SuiteArguments suite;
  std::string message;
  std::filesystem::path from;      ///< a list of approvals copied from the report
  std::filesystem::path artifact;  ///< folder or ZIP file of a report: take its pictures
  bool interactive = false;
  std::string run;       ///< accept the log under test of this run instead of frames
  bool replace = false;  ///< of a run: instead of the logs accepted so far
  bool anyway = false;   ///< also a log that is refused otherwise, or a picture without its texture
  bool also = false;     ///< keep the pictures accepted so far
};
cli::CommandLine addApproveCommand(cli::CommandLine app, ApproveArguments& arguments);
/// "not approved since the texture `a.png` is not found: ...; --anyway approves it all the same".
std::string lacksRefusal(const std::vector<std::string>& lacks);
/// Makes the frames drawn now the goldens of the selected frames.
Result<cli::Exit> runApproveCommand(const ApproveArguments& arguments);

struct SuggestArguments {
  SuiteArguments suite;
  std::string run;
  std::vector<std::filesystem::path> recordings;
};
cli::CommandLine addSuggestCommand(cli::CommandLine app, SuggestArguments& arguments);
/// Prints the limits of a run with which recordings of it accept each other, as TOML.
Result<cli::Exit> runSuggestCommand(const SuggestArguments& arguments);

/// Arguments of `rocinante golden list`.
struct ListArguments {
  SuiteArguments suite;
  bool verify = false;  ///< read every golden and check its hash
  bool json = false;
};
cli::CommandLine addListCommand(cli::CommandLine app, ListArguments& arguments);
/// Prints the frames with their goldens and the faults of the folder. Draws nothing.
Result<cli::Exit> runListCommand(const ListArguments& arguments);

/// Arguments of `rocinante golden add`.
struct AddArguments {
  std::filesystem::path suite;
  std::string name, at, event, after, events, every, size, tolerance, expect, reason;
  std::string cell, log;  ///< of a new suite, or the same as the suite's
  int occurrence = 0, samples = 0;
  double scale = 0;  ///< 0: not given, as `samples`
  bool no_insets = false, overlay = false;
  std::vector<std::string> cameras, layers, hide, show, insets, mask, tags, style;
};
cli::CommandLine addCaseCommand(cli::CommandLine app, AddArguments& arguments);
/// Appends the case to the suite's file; does not draw or approve.
Result<cli::Exit> runAddCommand(const AddArguments& arguments);

/// Arguments of `rocinante golden push`.
struct PushArguments {
  std::vector<std::filesystem::path> suites;
};
/// Arguments of `rocinante golden gc`.
struct GcArguments {
  std::filesystem::path suite;
  int keep_days = 14;
  bool dry_run = false;
};
cli::CommandLine addPushCommand(cli::CommandLine app, PushArguments& arguments);
cli::CommandLine addGcCommand(cli::CommandLine app, GcArguments& arguments);
/// Puts what the suites' manifests name into the ref of their store.
Result<cli::Exit> runPushCommand(const PushArguments& arguments);
/// Removes from the ref of a suite's store what no branch names.
Result<cli::Exit> runGcCommand(const GcArguments& arguments);

/// Arguments of `rocinante golden diff`.
struct DiffArguments {
  std::string revision;
  std::filesystem::path suite;  ///< empty: every manifest of goldens in the repository
  std::string report, json_file;
};
cli::CommandLine addDiffCommand(cli::CommandLine app, DiffArguments& arguments);
/// Prints which goldens changed since a git revision. Exit code 0: none, 1: some.
Result<cli::Exit> runDiffCommand(const DiffArguments& arguments);

/// Arguments of `rocinante golden report`.
struct ReportArguments {
  std::vector<std::filesystem::path> folders;
  ReportFiles files;
};
cli::CommandLine addReportCommand(cli::CommandLine app, ReportArguments& arguments);
/// Merges the reports of shards; the exit code is that of a single run.
Result<cli::Exit> runReportCommand(const ReportArguments& arguments);

/// Arguments of `rocinante golden session`.
struct SessionArguments : ModelSearch {
  std::filesystem::path a, b, cell;
  std::vector<std::string> more_accepted;
  std::string camera, tier = "loose", size = "640x480", report, align = "events";
  RunLimits limits;
  bool no_pictures = false, json = false;
};
cli::CommandLine addSessionCommand(cli::CommandLine app, SessionArguments& arguments);
Result<cli::Exit> runSessionCommand(const SessionArguments& arguments);

/// Arguments of `rocinante golden bisect`.
struct BisectArguments : ModelSearch {
  std::filesystem::path log, cell;
  std::string other_log, other_cell, other_render, camera, size = "640x480", from, until;
  int samples = 4;
  std::size_t most_frames = 2000;
  bool json = false;
};
cli::CommandLine addBisectCommand(cli::CommandLine app, BisectArguments& arguments);
Result<cli::Exit> runBisectCommand(const BisectArguments& arguments);

/// Makes the pictures that a job of CI drew the goldens of the frames in `list`. Draws nothing and
/// needs no log: what the manifest says of them (key, session, inputs) is what their report says.
Result<cli::Exit> approveArtifact(const ApproveArguments& arguments, const ApprovalList& list);

/// Accepts the log under test of the run that `arguments.run` names (docs/golden-suites.md,
/// "Accepting a log"): one that is compatible with the cell, that can be judged, and that widens
/// what is accepted by no more than kMostWidening limits; others only with `arguments.anyway`.
/// Prints what it widens.
Result<cli::Exit> approveRunOfSuite(const ApproveArguments& arguments);
/// The same for a run of a list of approvals: refused unless its log has the hash of the list
/// (JudgedRun::log_bytes).
Result<cli::Exit> approveListedRun(const ApproveArguments& arguments, const std::string& run,
                                   const std::string& bytes);
/// The same with the copy of the log in a report of CI.
Result<cli::Exit> approveReportedRun(const ApproveArguments& arguments, const JudgedRun& run,
                                     const std::string& bytes);

}  // namespace rocinante
