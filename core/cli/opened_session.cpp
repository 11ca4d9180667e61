#include "core/cli/opened_session.h"

#include "core/check/log_account.h"
#include "core/cli/import_progress.h"
#include "core/cli/program.h"

namespace rocinante::cli {

Result<OpenedRecording> openSession(const std::filesystem::path& recording,
                                    const std::filesystem::path& cell, const ModelSearch& search) {
  RecordingRequest request;
  request.recording = recording;
  request.cell = cell;
  request.search = search;
  request.progress = importProgress(recording.string());
  const StopDeadline deadline("stopped while reading the session");
  auto opened = openedRecording(request);
  if (!opened.ok()) return opened;
  for (const std::string& warning : opened->warnings) warn(warning);
  if (!opened->not_kept.empty()) warn(opened->not_kept);
  return opened;
}

void warnOfAccount(const std::filesystem::path& log, const Cell* cell) {
  const auto account = logAccount(log, cell);
  const std::string note = account ? account->note() : std::string();
  if (!note.empty()) warn(note);
}

}  // namespace rocinante::cli
