#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "recorder/doctor/log_diff.h"
#include "recorder/log/command_support.h"
#include "recorder/log/log_commands.h"

namespace rocinante {
namespace {

struct DiffOptions {
  std::string a;
  std::string b;
  std::string by = "all";
  bool json = false;
};

DiffBy byOf(const std::string& text) {
  if (text == "payload") return DiffBy::payload;
  if (text == "time") return DiffBy::time;
  return text == "state" ? DiffBy::state : DiffBy::all;
}

Result<cli::Exit> runDiff(const DiffOptions& options) {
  Result<LogReader> a = LogReader::open(options.a);
  if (!a) return a.error();
  Result<LogReader> b = LogReader::open(options.b);
  if (!b) return b.error();
  ProgressLine progress("comparing");
  const Result<LogDiff> diff =
      diffLogs(*a, *b, byOf(options.by), [&](double part) { progress.show(part); });
  if (!diff) return diff.error();
  if (diff->messages_a == 0 && diff->messages_b == 0) {
    return Error{ErrorKind::not_found, "neither log holds a message, so nothing can be compared",
                 options.a};
  }
  const std::string text = options.json ? diffJson(*diff) : diffText(*diff);
  if (Status written = toStandardOutput(text); !written) return written.error();
  bool damaged = false;
  for (const LogReader* reader : {&*a, &*b}) {
    for (const DamageSpan& span : reader->damage()) {
      cli::warn(fmt::format("{} ({}, byte {})", span.cause, reader->name(), span.from));
      damaged = true;
    }
  }
  return diff->same() && !damaged ? cli::Exit::done : cli::Exit::no;
}

}  // namespace

LogCommand addDiffCommand(CLI::App& program) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* const app =
      program.add_subcommand("diff", "where two logs part: messages, their times, their states");
  app->add_option("A", options->a, "a log")->required();
  app->add_option("B", options->b, "another log")->required();
  app->add_option("--by", options->by, "what to compare")
      ->check(CLI::IsMember({"payload", "time", "state", "all"}))
      ->capture_default_str();
  app->add_flag("--json", options->json, "for scripts");
  return {app, [options] { return runDiff(*options); }};
}

}  // namespace rocinante
