#include "core/cli/opened_session.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "core/check/log_account.h"
#include "core/cli/program.h"
#include "core/cli/progress_line.h"

namespace rocinante::cli {
namespace {

/// "importing NAME 42 %", and an error once the user asked to stop. The line disappears with the
/// last copy of the callback.
std::function<Status(double)> importProgress(const std::string& name) {
  return [line = std::make_shared<ProgressLine>("importing " + name)](double part) -> Status {
    line->show(part);
    if (stopRequested()) return Error{ErrorKind::refused, "stopped while importing", {}};
    return {};
  };
}

RecordingRequest requestOf(const std::filesystem::path& recording,
                           const std::filesystem::path& cell, const ModelSearch& search) {
  RecordingRequest request;
  request.recording = recording;
  request.cell = cell;
  request.search = search;
  request.progress = importProgress((recording.empty() ? cell : recording).string());
  return request;
}

}  // namespace

void warnOf(const OpenedRecording& opened) {
  for (const std::string& warning : opened.warnings) warn(warning);
  if (!opened.not_kept.empty()) warn(opened.not_kept);
}

Result<OpenedRecording> openWithinDeadline(const std::filesystem::path& recording,
                                           const std::filesystem::path& cell,
                                           const ModelSearch& search) {
  // The request goes first, and the line of its progress with it.
  auto opened = openedRecording(requestOf(recording, cell, search));
  if (opened.ok()) warnOf(*opened);
  return opened;
}

Result<OpenedRecording> openSession(const std::filesystem::path& recording,
                                    const std::filesystem::path& cell, const ModelSearch& search) {
  const StopDeadline deadline("stopped while reading the session");
  return openWithinDeadline(recording, cell, search);
}

Result<OpenedRecording> openCellAndLog(std::filesystem::path& cell, std::filesystem::path& log,
                                       ModelSearch& search) {
  auto found = openedCellAndRecording(requestOf(log, cell, search));
  if (!found) return found.error();
  if (found->opened.imported && found->cell == found->log) search = {};
  cell = std::move(found->cell);
  log = std::move(found->log);
  return std::move(found->opened);
}

void warnOfAccount(const std::filesystem::path& log, const Cell* cell) {
  const auto account = logAccount(log, cell);
  const std::string note = account ? account->note() : std::string();
  if (!note.empty()) warn(note);
}

}  // namespace rocinante::cli
