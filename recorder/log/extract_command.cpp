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

Status checkArguments(const ExtractArguments& my) {
  const int chosen =
      int{!my.name.empty()} + int{my.index.has_value()} + int{my.all} + int{my.cell} + int{my.list};
  if (chosen != 1) {
    return badArgument("give exactly one of NAME, --index N, --all, --cell and --list");
  }
  if (my.list != my.output.empty()) {
    return badArgument(my.list ? "--list does not write a file" : "give the output: -o PATH");
  }
  if (my.json && !my.list) return badArgument("--json needs --list");
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

Result<cli::Exit> extractOne(const LogReader& log, const ExtractArguments& my) {
  const auto index = findAttachment(log, my.name, my.index);
  if (!index.ok()) return index.error();
  const auto bytes = log.readAttachment(*index);
  if (!bytes.ok()) return bytes.error();
  if (my.output == "-") {
    if (Status written = toStandardOutput(textOf(*bytes)); !written) return written.error();
    return cli::Exit::done;
  }
  if (Status written = writeFileWhole(my.output, *bytes, my.force); !written) {
    return written.error();
  }
  return cli::Exit::done;
}

Result<cli::Exit> extractFolder(const LogReader& log, const ExtractArguments& my) {
  const FolderOutput to{my.output, my.force};
  const auto report = my.cell ? extractCell(log, to) : extractAll(log, to);
  if (!report.ok()) return report.error();
  fmt::print("{} file{}, {} bytes in {}\n", report->files, report->files == 1 ? "" : "s",
             report->bytes, my.output.string());
  if (!my.cell) return cli::Exit::done;
  fmt::print("rocinante view {}", (my.output / report->main).string());
  for (const std::string& root : report->search) {
    fmt::print(" --search {}", (my.output / root).string());
  }
  for (const auto& [name, folder] : report->packages) {
    fmt::print(" --package {}={}", name, (my.output / folder).string());
  }
  fmt::print("\n");
  if (!report->stands_alone) {
    cli::warn(
        "outside the log some names in the cell mean other files, or none: rocinante check "
        "lists them");
  }
  return cli::Exit::done;
}

Result<cli::Exit> runExtract(const ExtractArguments& my) {
  if (Status fit = checkArguments(my); !fit) return fit.error();
  const auto log = LogReader::open(my.log);
  if (!log.ok()) return log.error();
  if (my.list) {
    if (Status said = toStandardOutput(listText(*log, my.json)); !said) return said.error();
    return cli::Exit::done;
  }
  return my.all || my.cell ? extractFolder(*log, my) : extractOne(*log, my);
}

}  // namespace

cli::Subcommand addExtractCommand(cli::CommandLine program) {
  auto my = std::make_shared<ExtractArguments>();
  const cli::CommandLine app =
      program.addSubcommand("extract", "extract the files attached to a log");
  app.addOption("LOG", my->log, "a log").required();
  app.addOption("NAME", my->name, "the attachment of that name");
  app.addOption("--index", my->index, "the attachment of that number in --list").valueName("N");
  app.addFlag("--all", my->all, "every attachment, into a folder");
  app.addFlag("--cell", my->cell, "the cell that the log carries, into a folder");
  app.addFlag("--list", my->list, "list the attachments");
  app.addOption("-o,--output", my->output,
                "a file, a folder for --all and --cell, or -: standard output")
      .valueName("PATH");
  app.addFlag("--force", my->force, "replace what is there");
  app.addFlag("--json", my->json, "print --list as JSON");
  return {app, [my] { return runExtract(*my); }};
}

}  // namespace rocinante
