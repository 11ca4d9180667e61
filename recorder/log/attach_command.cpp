#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/bundle/attached_cell.h"
#include "core/bundle/bundle_names.h"
#include "core/cli/load_progress.h"
#include "core/cli/search_options.h"
#include "core/cli/worker_threads.h"
#include "recorder/contents/attachments.h"
#include "recorder/log/command_support.h"
#include "recorder/log/commands.h"

namespace rocinante {
namespace {

struct AttachArguments {
  std::string log, name, media_type;
  std::vector<std::filesystem::path> files;
  std::filesystem::path cell;
  CellOptions search;
  bool replace = false;
  CopyArguments copy;
};

Result<std::vector<NewAttachment>> readFiles(const AttachArguments& arguments) {
  std::vector<NewAttachment> files;
  for (const std::filesystem::path& path : arguments.files) {
    auto content = readFile(path, kMaxAttachedBytes);
    if (!content.ok()) return content.error();
    NewAttachment file;
    file.name = arguments.name.empty() ? manifestWord(path.filename().string()) : arguments.name;
    if (!isBundleName(file.name)) {
      return Error{ErrorKind::bad_argument,
                   "an attachment is named as a file in a folder is: NAME or FOLDER/NAME",
                   file.name};
    }
    file.media_type = arguments.media_type.empty() ? mediaTypeOf(file.name) : arguments.media_type;
    const ByteView bytes = bytesOf(*content);
    file.data.assign(bytes.begin(), bytes.end());
    files.push_back(std::move(file));
  }
  return files;
}

Result<cli::Exit> runAttach(const AttachArguments& arguments) {
  const auto refuse = [](std::string why) {
    return Error{ErrorKind::bad_argument, std::move(why), {}};
  };
  if (arguments.files.empty() && arguments.cell.empty()) {
    return refuse("nothing to attach: give FILE..., --cell CELL, or both");
  }
  if (arguments.files.size() != 1 && !(arguments.name.empty() && arguments.media_type.empty())) {
    return refuse("--name and --media-type need exactly one FILE");
  }
  const std::vector<std::string> where = cli::searchWords(arguments.search);
  if (arguments.cell.empty() && !where.empty()) return refuse(where.front() + " needs --cell");
  AttachOptions attach;
  attach.replace = arguments.replace;
  auto files = readFiles(arguments);
  if (!files.ok()) return files.error();
  attach.files = std::move(*files);
  CellBundle cell;
  if (!arguments.cell.empty()) {
    CellOptions search = arguments.search;
    search.parallel = cli::workerThreads();
    search.progress = cli::loadProgress(arguments.cell);
    auto collected = collectCellOrLog(arguments.cell, search);
    if (!collected.ok()) return collected.error();
    cell = std::move(*collected);
    for (const std::string& warning : bundleWarnings(cell)) cli::warn(warning);
    attach.cell = &cell;
  }
  const Result<CopyReport> report =
      runCopy(arguments.copy, "copying " + arguments.log,
              [&](const MakeOptions& make) { return attachToLog(arguments.log, attach, make); });
  if (!report) return report.error();
  return tellCopy(arguments.copy, *report);
}

}  // namespace

cli::Subcommand addAttachCommand(cli::CommandLine program) {
  auto arguments = std::make_shared<AttachArguments>();
  const cli::CommandLine app =
      program.addSubcommand("attach", "copy a log and attach files, or its cell");
  app.addOption("LOG", arguments->log, "the log; it is not changed").required();
  app.addOption("FILE", arguments->files, "files to attach, each under its name without folders");
  app.addOption("--cell", arguments->cell, "attach this cell and every file it names")
      .valueName("CELL");
  cli::addSearchOptions(app, arguments->search);
  app.addOption("--name", arguments->name, "attach the one FILE under this name").valueName("NAME");
  app.addOption("--media-type", arguments->media_type, "of the one FILE; default by its ending")
      .valueName("TYPE");
  app.addFlag("--replace", arguments->replace, "in place of what the log has under the same name");
  addCopyArguments(app, arguments->copy);
  return {app, [arguments] { return runAttach(*arguments); }};
}

}  // namespace rocinante
