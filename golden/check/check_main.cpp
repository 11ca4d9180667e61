#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/bundle/attached_cell.h"
#include "core/bundle/cell_folder.h"
#include "core/check/check.h"
#include "core/check/drift/model_drift.h"
#include "core/check/reports/baseline.h"
#include "core/check/rules/without_cell.h"
#include "core/cli/load_progress.h"
#include "core/cli/opened_session.h"
#include "core/cli/program.h"
#include "core/cli/progress_line.h"
#include "core/cli/worker_threads.h"
#include "core/foreign/live/received_decoder.h"
#include "core/foreign/recordings/cell_and_log.h"
#include "core/log/log_profile.h"
#include "golden/check/check_live.h"
#include "golden/check/check_options.h"
#include "golden/check/check_output.h"
#include "golden/check/check_watch.h"
#include "golden/check/log_octets.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante check cell.toml                         the model alone\n"
    "  rocinante check cell.toml session.mcap            does this session fit this model?\n"
    "  rocinante check session.mcap                      a log that carries its cell, or none\n"
    "  rocinante check arm.urdf session.mcap --json      for a program\n"
    "  rocinante check arm.urdf bag.db3                  a bag, a capture or a table\n"
    "  rocinante check cell.toml session.mcap -o junit=check.xml -o sarif=check.sarif\n"
    "  rocinante check cell.toml session.mcap --baseline known.json --strict\n"
    "  rocinante check cell.toml --live :19960 --duration 10s\n"
    "  rocinante check cell.toml --live :19960 --watch --on-finding ./alarm\n"
    "  rocinante check cell.toml --live :49152 --decoders kuka.decoders.toml\n"
    "  rocinante check --explain joint.limit\n";

/// Differences between the cell attached to the log, if any, and the cell it is judged with.
/// `is_description`: what is attached is the robot that a bag describes.
Findings driftOf(const LogReader& log, const Cell& given, bool is_description) {
  const auto unreadable = [&](const Error& error) {
    Finding finding;
    finding.rule = "drift.unreadable";
    finding.severity = Severity::warning;
    finding.text = "the cell that the log carries cannot be compared: " + error.text();
    return Findings{finding};
  };
  const Result<std::optional<CellBundle>> bundle = readAttachedCell(log);
  if (!bundle) return unreadable(bundle.error());
  if (!*bundle) return {};
  const std::string shown_as = log.name() + ":" + std::string(profile::kCellFolder);
  CellOptions options;
  options.parallel = cli::workerThreads();
  options.progress = cli::loadProgress(shown_as);
  Result<Cell> recorded = loadBundle(**bundle, shown_as, options);
  if (!recorded) return unreadable(recorded.error());
  if (!is_description) return modelDrift(*recorded, given);
  const bool has_meshes = std::ranges::none_of(recorded->faults, [](const Finding& fault) {
    return fault.severity == Severity::error || fault.rule == "model.missing-file";
  });
  return descriptionDrift(*recorded, has_meshes, given);
}

/// The session's log: made of it where another program recorded it.
Result<OpenedRecording> openSession(CheckArguments& arguments) {
  cli::catchStopSignals();
  const cli::StopDeadline deadline("stopped while reading the session");
  std::filesystem::path cell = arguments.cell, log = arguments.log;
  auto opened = cli::openCellAndLog(cell, log, arguments);
  if (!opened) return opened;
  // Its other warnings are findings of the report.
  if (!opened->not_kept.empty()) cli::warn(opened->not_kept);
  arguments.cell = cell.string();
  arguments.log = log.string();
  return opened;
}

Result<CheckReport> judgeLog(const CheckArguments& arguments, const Cell& cell,
                             const OpenedRecording& opened) {
  Result<LogReader> log = LogReader::open(arguments.log);
  if (!log) return log.error();
  Result<LogOctets> octets = LogOctets::of(*log, arguments.decoders, cell);
  if (!octets) return octets.error();
  const auto packets = *octets ? OctetPackets([&](const LogMessage& message, bool has_packet) {
    return octets->packetOf(message, has_packet);
  })
                               : OctetPackets();
  cli::catchStopSignals();
  const std::string name = opened.imported ? opened.recording.string() : arguments.log;
  Result<CheckReport> report = [&] {
    cli::ProgressLine line("judging " + name);
    return checkLog(
        cell, *log,
        [&](double part) {
          line.show(part);
          return !cli::stopRequested();
        },
        packets);
  }();
  if (!report) return report;
  report->session = name;
  if (*octets && octets->account().octets > 0) tellDecoded(octets->account(), *report);
  // A log judged with its own cell cannot have drifted.
  if (arguments.log != arguments.cell) {
    Findings drift = driftOf(*log, cell, opened.imported);
    report->findings.insert(report->findings.end(), drift.begin(), drift.end());
    const auto carried = readAttachedCell(*log);
    if (!carried || *carried) report->unjudged.erase("drift");
  }
  return report;
}

/// A session alone, which carries no cell: it is judged by what needs none.
Result<bool> hasNoCell(const CheckArguments& arguments) {
  if (arguments.cell != arguments.log || !isLog(arguments.cell)) return false;
  const auto log = LogReader::open(arguments.log);
  if (!log) return log.error();
  const auto carried = readAttachedCell(*log);
  if (!carried) return carried.error();
  return !carried->has_value();
}

/// The cell, with the rules of the command line.
Result<Cell> loadWithRules(const CheckArguments& arguments) {
  const Result<std::vector<CellRule>> rules = readRuleArguments(arguments);
  if (!rules) return rules.error();
  CellOptions options;
  static_cast<ModelSearch&>(options) = arguments;
  options.parallel = cli::workerThreads();
  options.progress = cli::loadProgress(arguments.cell);
  const Result<bool> is_bare = hasNoCell(arguments);
  if (!is_bare) return is_bare.error();
  Result<Cell> cell = *is_bare ? Cell() : loadCellOrLog(arguments.cell, options);
  if (cell) cell->rules.insert(cell->rules.end(), rules->begin(), rules->end());
  return cell;
}

Result<CheckReport> judge(const CheckArguments& arguments, const OpenedRecording& opened) {
  const Result<Cell> cell = loadWithRules(arguments);
  if (!cell) return cell.error();
  if (!arguments.live.empty()) {
    const auto duration =
        readPositive(arguments.duration.empty() ? "2s" : arguments.duration, "--duration");
    if (!duration) return duration.error();
    auto decoders = decodersFor(arguments.decoders, *cell);
    if (!decoders) return decoders.error();
    return checkLive(*cell, {arguments.live, arguments.trust, std::move(*decoders), *duration});
  }
  if (!arguments.log.empty()) return judgeLog(arguments, *cell, opened);
  if (!arguments.decoders.empty()) {
    return Error{ErrorKind::bad_argument, "--decoders needs a LOG or --live", {}};
  }
  return checkCell(*cell);
}

/// Applies the baseline and sets the verdict from the remaining findings.
Status concludeWith(const CheckArguments& arguments, const std::optional<Baseline>& baseline,
                    CheckReport& report) {
  report.fail_on = failOn(arguments);
  const bool is_whole = !report.interrupted && !(report.has_session && report.packets == 0);
  conclude(report);
  if (arguments.update_baseline && is_whole) {
    const Baseline now = Baseline::of(report);
    now.applyTo(report);
    if (Status written = writeFileWhole(arguments.baseline, bytesOf(now.text()), true); !written) {
      return written;
    }
  } else if (baseline) {
    baseline->applyTo(report);
  }
  conclude(report);
  return {};
}

cli::Exit exitOf(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::compatible:
      return cli::Exit::done;
    case CheckVerdict::incompatible:
      return cli::Exit::no;
    case CheckVerdict::nothing_judged:
    case CheckVerdict::interrupted:
      break;
  }
  return cli::Exit::could_not_run;
}

Result<cli::Exit> watch(const CheckArguments& arguments, const std::optional<Baseline>& baseline) {
  Result<CheckWatchOptions> options = readWatchArguments(arguments);
  if (!options) return options.error();
  if (baseline) options->baseline = &*baseline;
  const Result<Cell> cell = loadWithRules(arguments);
  if (!cell) return cell.error();
  auto decoders = decodersFor(arguments.decoders, *cell);
  if (!decoders) return decoders.error();
  options->decoders = std::move(*decoders);
  return watchLive(*cell, *options);
}

Result<cli::Exit> run(CheckArguments& arguments) {
  if (arguments.list_rules) {
    printRules(arguments.printsJson());
    return cli::Exit::done;
  }
  if (!arguments.explain.empty()) {
    if (Status explained = explainRule(arguments.explain); !explained) return explained.error();
    return cli::Exit::done;
  }
  if (arguments.cell.empty()) {
    return Error{ErrorKind::bad_argument, "CELL is required (see rocinante-check --help)", {}};
  }
  orderCellAndLog(arguments.cell, arguments.log);
  const Result<std::vector<CheckOutput>> outputs = readOutputs(arguments);
  if (!outputs) return outputs.error();
  std::optional<Baseline> baseline;
  if (!arguments.baseline.empty() && !arguments.update_baseline) {
    Result<Baseline> read = Baseline::read(arguments.baseline);
    if (!read) return read.error();
    baseline = std::move(*read);
  }
  if (arguments.watch) return watch(arguments, baseline);
  OpenedRecording opened;
  if (arguments.live.empty()) {
    Result<OpenedRecording> found = openSession(arguments);
    if (!found) return found.error();
    opened = std::move(*found);
    // A log that carries its cell needs no other argument.
    if (arguments.log.empty() && isLog(arguments.cell)) arguments.log = arguments.cell;
  }
  Result<CheckReport> report = judge(arguments, opened);
  if (!report) return opened.named(report.error());
  const Result<bool> is_bare = hasNoCell(arguments);
  if (is_bare && *is_bare) concludeWithoutCell(*report);
  if (opened.imported) report->cell = opened.named({{}, report->cell, {}}).what;
  if (Status concluded = concludeWith(arguments, baseline, *report); !concluded)
    return concluded.error();
  if (Status written = writeReport(*report, arguments, *outputs); !written) return written.error();
  return exitOf(report->verdict);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app("Checks whether a session fits a model: devices, joints, limits, losses.",
                   "rocinante-check");
  CheckArguments arguments;
  declareCheck(app, arguments);
  return cli::run(app, argc, argv, kExamples, [&] { return run(arguments); });
}
