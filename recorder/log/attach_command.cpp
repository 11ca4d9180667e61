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

Result<std::vector<NewAttachment>> readFiles(const AttachArguments& my) {
  std::vector<NewAttachment> files;
  for (const std::filesystem::path& path : my.files) {
    auto content = readFile(path, kMaxAttachedBytes);
    if (!content.ok()) return content.error();
    NewAttachment file;
    file.name = my.name.empty() ? manifestWord(path.filename().string()) : my.name;
    if (!isBundleName(file.name)) {
      return Error{ErrorKind::bad_argument,
                   "an attachment is named as a file in a folder is: NAME or FOLDER/NAME",
                   file.name};
    }
    file.media_type = my.media_type.empty() ? mediaTypeOf(file.name) : my.media_type;
    const ByteView bytes = bytesOf(*content);
    file.data.assign(bytes.begin(), bytes.end());
    files.push_back(std::move(file));
  }
  return files;
}

Result<cli::Exit> runAttach(const AttachArguments& my) {
  const auto refuse = [](std::string why) {
    return Error{ErrorKind::bad_argument, std::move(why), {}};
  };
  if (my.files.empty() && my.cell.empty()) {
    return refuse("nothing to attach: give FILE..., --cell CELL, or both");
  }
  if (my.files.size() != 1 && !(my.name.empty() && my.media_type.empty())) {
    return refuse("--name and --media-type need exactly one FILE");
  }
  const std::vector<std::string> where = cli::searchWords(my.search);
  if (my.cell.empty() && !where.empty()) return refuse(where.front() + " needs --cell");
  AttachOptions attach;
  attach.replace = my.replace;
  auto files = readFiles(my);
  if (!files.ok()) return files.error();
  attach.files = std::move(*files);
  CellBundle cell;
  if (!my.cell.empty()) {
    CellOptions search = my.search;
    search.parallel = cli::workerThreads();
    search.progress = cli::loadProgress(my.cell);
    auto collected = collectCellOrLog(my.cell, search);
    if (!collected.ok()) return collected.error();
    cell = std::move(*collected);
    for (const std::string& warning : bundleWarnings(cell)) cli::warn(warning);
    attach.cell = &cell;
  }
  const Result<CopyReport> report =
      runCopy(my.copy, "copying " + my.log,
              [&](const MakeOptions& make) { return attachToLog(my.log, attach, make); });
  if (!report) return report.error();
  return tellCopy(my.copy, *report);
}

}  // namespace

cli::Subcommand addAttachCommand(cli::CommandLine program) {
  auto my = std::make_shared<AttachArguments>();
  const cli::CommandLine app =
      program.addSubcommand("attach", "copy a log and attach files, or its cell");
  app.addOption("LOG", my->log, "the log; it is not changed").required();
  app.addOption("FILE", my->files, "files to attach, each under its name without folders");
  app.addOption("--cell", my->cell, "attach this cell and every file it names").valueName("CELL");
  cli::addSearchOptions(app, my->search);
  app.addOption("--name", my->name, "attach the one FILE under this name").valueName("NAME");
  app.addOption("--media-type", my->media_type, "of the one FILE; default by its ending")
      .valueName("TYPE");
  app.addFlag("--replace", my->replace, "in place of what the log has under the same name");
  addCopyArguments(app, my->copy);
  return {app, [my] { return runAttach(*my); }};
}

}  // namespace rocinante
