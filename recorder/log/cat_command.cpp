#include <fmt/format.h>

#include "core/copy/log_selection.h"
#include "core/log/damage_text.h"
#include "recorder/contents/log_cat.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct CatCommandOptions {
  std::vector<std::string> logs;
  std::string format = "text";
  CatOptions cat;
};

Result<cli::Exit> runCat(CatCommandOptions& options) {
  options.cat.format = options.format == "json"  ? CatFormat::json
                       : options.format == "csv" ? CatFormat::csv
                                                 : CatFormat::text;
  options.cat.name_log = options.logs.size() > 1;
  cli::Exit exit = cli::Exit::done;
  std::uint64_t count = 0;
  bool first = true;
  for (const std::string& log : options.logs) {
    Result<LogReader> reader = LogReader::open(log);
    if (!reader) return reader.error();
    const Result<std::uint64_t> shown = catLog(*reader, options.cat, first, toStandardOutput);
    if (!shown) return shown.error();
    first = false;
    count += *shown;
    if (count == 0 && options.logs.size() == 1) {
      const SelectionOptions& selection = options.cat.selection;
      const Result<TimeRange> range = rangeOf(selection, reader->summary(), {});
      return range ? nothingChosen(*reader, selection, *range) : range.error();
    }
    for (const DamageSpan& span : reader->damage()) {
      cli::warn(damageText(span, log));
      exit = cli::Exit::no;
    }
  }
  if (count > 0) return exit;
  return Error{ErrorKind::not_found, "no message was chosen",
               fmt::format("{} logs", options.logs.size())};
}

}  // namespace

cli::Subcommand addCatCommand(cli::CommandLine program) {
  auto options = std::make_shared<CatCommandOptions>();
  const cli::CommandLine app =
      program.addSubcommand("cat", "print the messages of a log, one per line");
  app.addOption("LOG", options->logs, "logs to print, one after another").required();
  app.addOption("--from", options->cat.selection.from,
                "begin at this session time (12.5s, -1s, RFC 3339)")
      .valueName("TIME");
  app.addOption("--until", options->cat.selection.until, "end before this session time")
      .valueName("TIME");
  app.addOption("--channel", options->cat.selection.channels,
                "only topics that match this pattern; may be repeated")
      .valueName("PATTERN")
      .oneEach();
  app.addOption("--device", options->cat.selection.devices,
                "only packets about a device that matches; may be repeated")
      .valueName("PATTERN")
      .oneEach();
  app.addOption("--format", options->format, "json: one object per line")
      .oneOf({"text", "json", "csv"})
      .showDefault();
  return {app, [options] { return runCat(*options); }};
}

}  // namespace rocinante
