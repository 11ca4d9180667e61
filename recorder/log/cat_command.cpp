#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "recorder/log/command_support.h"
#include "recorder/log/log_cat.h"
#include "recorder/log/log_commands.h"

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
    for (const DamageSpan& span : reader->damage()) {
      cli::warn(fmt::format("{} ({}, byte {})", span.cause, log, span.from));
      exit = cli::Exit::no;
    }
  }
  if (count == 0) {
    return Error{
        ErrorKind::not_found, "no message was chosen",
        options.cat.name_log ? fmt::format("{} logs", options.logs.size()) : options.logs.front()};
  }
  return exit;
}

}  // namespace

LogCommand addCatCommand(CLI::App& program) {
  auto options = std::make_shared<CatCommandOptions>();
  CLI::App* const app = program.add_subcommand("cat", "the messages of a log, one a line");
  app->add_option("LOG", options->logs, "logs to print, one after another")->required();
  app->add_option("--from", options->cat.from, "begin at this session time (12.5s, -1s, RFC 3339)");
  app->add_option("--until", options->cat.until, "end before this session time");
  app->add_option("--channel", options->cat.channels,
                  "only topics that match this pattern, as a shell's; may be repeated")
      ->allow_extra_args(false);
  app->add_option("--device", options->cat.devices,
                  "only packets about a device that matches this pattern; may be repeated")
      ->allow_extra_args(false);
  app->add_option("--format", options->format, "text, json (one object a line) or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}))
      ->capture_default_str();
  return {app, [options] { return runCat(*options); }};
}

}  // namespace rocinante
