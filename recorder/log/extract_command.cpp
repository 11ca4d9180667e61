#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/plain_text.h"
#include "core/report/json_text.h"
#include "recorder/contents/attachments.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct ExtractArguments {
  std::string log, name;
  std::filesystem::path output;
  std::optional<std::size_t> index;
  bool all = false, cell = false, list = false, force = false, json = false;
};

Error badArgument(std::string what) { return {ErrorKind::bad_argument, std::move(what), {}}; }

Status checkArguments(const ExtractArguments& arguments) {
  const int chosen = int{!arguments.name.empty()} + int{arguments.index.has_value()} +
                     int{arguments.all} + int{arguments.cell} + int{arguments.list};
  if (chosen != 1) {
    return badArgument("give exactly one of NAME, --index N, --all, --cell and --list");
  }
  if (arguments.list != arguments.output.empty()) {
    return badArgument(arguments.list ? "--list does not write a file"
                                      : "give the output: -o PATH");
  }
  if (arguments.json && !arguments.list) return badArgument("--json needs --list");
  return {};
}

std::string listText(const LogReader& log, bool json) {
  if (!json) {
    std::string text;
    for (std::size_t i = 0; i < log.attachments().size(); ++i) {
      const LogAttachment& each = log.attachments()[i];
      text += fmt::format("{:>4}  {:>12}  {:<24}  {}\n", i + 1, each.data_bytes,
                          plainText(each.media_type), plainText(each.name));
    }
    return text;
  }
  Json root;
  root["format"] = 1;
  root["log"] = log.name();
  root["attachments"] = Json::array();
  for (std::size_t i = 0; i < log.attachments().size(); ++i) {
    const LogAttachment& each = log.attachments()[i];
    root["attachments"].push_back({{"index", i + 1},
                                   {"name", each.name},
                                   {"media_type", each.media_type},
                                   {"bytes", each.data_bytes},
                                   {"log_time_ns", each.log_time.time_since_epoch().count()}});
  }
  return jsonText(root);
}

Result<cli::Exit> extractOne(const LogReader& log, const ExtractArguments& arguments) {
  const auto index = findAttachment(log, arguments.name, arguments.index);
  if (!index.ok()) return index.error();
  const auto bytes = log.readAttachment(*index);
  if (!bytes.ok()) return bytes.error();
  if (arguments.output == "-") {
    if (Status written = toStandardOutput(textOf(*bytes)); !written) return written.error();
    return cli::Exit::done;
  }
  if (Status written = writeFileWhole(arguments.output, *bytes, arguments.force); !written) {
    return written.error();
  }
  return cli::Exit::done;
}

Result<cli::Exit> extractFolder(const LogReader& log, const ExtractArguments& arguments) {
  const FolderOutput to{arguments.output, arguments.force};
  const auto report = arguments.cell ? extractCell(log, to) : extractAll(log, to);
  if (!report.ok()) return report.error();
  fmt::print("{} file{}, {} bytes in {}\n", report->files, report->files == 1 ? "" : "s",
             report->bytes, arguments.output.string());
  if (!arguments.cell) return cli::Exit::done;
  fmt::print("rocinante view {}", (arguments.output / report->main).string());
  for (const std::string& root : report->search) {
    fmt::print(" --search {}", (arguments.output / root).string());
  }
  for (const auto& [name, folder] : report->packages) {
    fmt::print(" --package {}={}", name, (arguments.output / folder).string());
  }
  fmt::print("\n");
  if (!report->stands_alone) {
    cli::warn(
        "outside the log some names in the cell mean other files, or none: rocinante check "
        "lists them");
  }
  return cli::Exit::done;
}

Result<cli::Exit> runExtract(const ExtractArguments& arguments) {
  if (Status fit = checkArguments(arguments); !fit) return fit.error();
  const auto log = LogReader::open(arguments.log);
  if (!log.ok()) return log.error();
  if (arguments.list) {
    if (Status printed = toStandardOutput(listText(*log, arguments.json)); !printed)
      return printed.error();
    return cli::Exit::done;
  }
  return arguments.all || arguments.cell ? extractFolder(*log, arguments)
                                         : extractOne(*log, arguments);
}

}  // namespace

cli::Subcommand addExtractCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<ExtractArguments>();
  const cli::CommandLine app =
      program.addSubcommand("extract", "extract the files attached to a log");
  app.addOption("LOG", arguments->log, "a log").required();
  app.addOption("NAME", arguments->name, "the attachment of that name");
  app.addOption("--index", arguments->index, "the attachment of that number in --list")
      .valueName("N");
  app.addFlag("--all", arguments->all, "every attachment, into a folder");
  app.addFlag("--cell", arguments->cell, "the cell that the log carries, into a folder");
  app.addFlag("--list", arguments->list, "list the attachments");
  app.addOption("-o,--output", arguments->output,
                "a file, a folder for --all and --cell, or -: standard output")
      .valueName("PATH");
  app.addFlag("--force", arguments->force, "replace what is there");
  app.addFlag("--json", arguments->json, "print --list as JSON");
  return {app, [arguments] { return runExtract(*arguments); }};
}

}  // namespace rocinante
