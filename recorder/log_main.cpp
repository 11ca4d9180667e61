#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>

#include "core/cli/program.h"
#include "recorder/log_cat.h"
#include "recorder/log_info.h"

namespace {

using namespace rocinante;

constexpr const char* kExamples =
    "  rocinante log info session.mcap                 what is in it, and whether it is whole\n"
    "  rocinante log info --json session.mcap          the same for scripts\n"
    "  rocinante log cat session.mcap --from 12.5s --until 14s\n"
    "  rocinante log cat session.mcap --channel '/udp/*/arm' --format json\n";

/// "reading session.mcap 42 %" on a terminal, once the work has taken a second.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what)
      : what_(std::move(what)), on_(::isatty(STDERR_FILENO) == 1) {}
  ~ProgressLine() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double part) {
    if (!on_ || std::chrono::steady_clock::now() < next_) return;
    next_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
    shown_ = true;
    fmt::print(stderr, "\rreading {} {:3.0f} %", what_, part * 100);
  }

 private:
  std::string what_;
  bool on_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_ =
      std::chrono::steady_clock::now() + std::chrono::seconds(1);
};

Status toStandardOutput(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size()) return {};
  return Error{ErrorKind::unreadable, "cannot write to standard output", {}};
}

Result<cli::Exit> runInfo(const std::vector<std::string>& logs, bool json) {
  cli::Exit exit = cli::Exit::done;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    ProgressLine progress(logs[i]);
    const Result<LogInfo> info = logInfo(logs[i], [&](double part) { progress.show(part); });
    if (!info) return info.error();
    if (!json && i > 0) std::fputc('\n', stdout);
    const std::string text = json ? logInfoJson(*info, logs.size() == 1) : logInfoText(*info);
    if (Status written = toStandardOutput(text); !written) return written.error();
    if (!info->damage.empty()) exit = cli::Exit::no;
  }
  return exit;
}

Result<cli::Exit> runCat(const std::vector<std::string>& logs, CatOptions options) {
  options.name_log = logs.size() > 1;
  cli::Exit exit = cli::Exit::done;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    Result<LogReader> reader = LogReader::open(logs[i]);
    if (!reader) return reader.error();
    const Result<std::uint64_t> shown = catLog(*reader, options, i == 0, toStandardOutput);
    if (!shown) return shown.error();
    count += *shown;
    for (const DamageSpan& span : reader->damage()) {
      cli::warn(fmt::format("{} ({}, byte {})", span.cause, logs[i], span.from));
      exit = cli::Exit::no;
    }
  }
  if (count == 0) {
    return Error{ErrorKind::not_found, "no message was chosen",
                 options.name_log ? fmt::format("{} logs", logs.size()) : logs.front()};
  }
  return exit;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Looks into logs.", "rocinante-log");
  app.require_subcommand(1);
  std::vector<std::string> logs;
  bool json = false;
  CatOptions cat;
  std::string format = "text";

  CLI::App* const info =
      app.add_subcommand("info", "what is in a log: channels, rates, losses, damage");
  info->add_option("LOG", logs, "logs to describe")->required();
  info->add_flag("--json", json, "for scripts; of several logs, one object a line");

  CLI::App* const messages = app.add_subcommand("cat", "the messages of a log, one a line");
  messages->add_option("LOG", logs, "logs to print, one after another")->required();
  messages->add_option("--from", cat.from, "begin at this session time (12.5s, -1s, RFC 3339)");
  messages->add_option("--until", cat.until, "end before this session time");
  messages
      ->add_option("--channel", cat.channels,
                   "only topics that match this pattern, as a shell's; may be repeated")
      ->allow_extra_args(false);
  messages->add_option("--format", format, "text, json (one object a line) or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}))
      ->capture_default_str();

  return cli::run(app, argc, argv, kExamples, [&]() -> Result<cli::Exit> {
    if (info->parsed()) return runInfo(logs, json);
    cat.format = format == "json"  ? CatFormat::json
                 : format == "csv" ? CatFormat::csv
                                   : CatFormat::text;
    return runCat(logs, cat);
  });
}
