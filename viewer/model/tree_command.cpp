#include <fmt/format.h>
#include <langinfo.h>

#include <clocale>
#include <string_view>

#include "core/base/plain_text.h"
#include "viewer/model/commands.h"
#include "viewer/model/model_info.h"

namespace rocinante {
namespace {

struct TreeOptions {
  ModelFileOptions file;
  bool ascii = false;
};

// Whether the terminal's character set is UTF-8.
bool terminalHasBoxes() {
  std::setlocale(LC_CTYPE, "");
  const std::string_view codeset = nl_langinfo(CODESET);
  std::setlocale(LC_CTYPE, "C");
  return codeset == "UTF-8";
}

Result<cli::Exit> runTree(const TreeOptions& options) {
  const Result<Cell> cell = loadFile(options.file, false);
  if (!cell) return cell.error();
  warnOfFaults(*cell);
  const bool ascii = options.ascii || !terminalHasBoxes();
  const bool several = cell->devices.size() != 1;
  std::string text;
  for (const CellDevice& device : cell->devices) {
    if (!options.file.device.empty() && device.name != options.file.device) continue;
    const Model* model = cell->modelOf(device);
    if (model == nullptr) continue;
    if (several && !text.empty()) text += "\n";
    if (several) {
      text += fmt::format("{} ({})\n", plainText(device.name), plainText(device.model));
    }
    text += treeText(*model, ascii);
  }
  if (Status written = toStandardOutput(text); !written) return written.error();
  return cli::Exit::done;
}

}  // namespace

cli::Subcommand addTreeCommand(cli::CommandLine program) {
  auto options = std::make_shared<TreeOptions>();
  const cli::CommandLine app =
      program.addSubcommand("tree", "print the links and their joints as a tree");
  addFileOptions(app, options->file);
  app.addFlag("--ascii", options->ascii, "use only ASCII characters");
  return {app, [options] { return runTree(*options); }};
}

}  // namespace rocinante
