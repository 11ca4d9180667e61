#pragma once

#include <filesystem>

#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/foreign/recordings/opened_recording.h"

namespace rocinante::cli {

/// openedRecording() for a program that shows or judges a session: with progress on a terminal,
/// warnings on standard error, and an end within a second of a stop signal. `cell`: whose devices
/// are meant; empty: those of the recording, whose log then carries them.
Result<OpenedRecording> openSession(const std::filesystem::path& recording,
                                    const std::filesystem::path& cell = {},
                                    const ModelSearch& search = {});
/// The same within the caller's StopDeadline: there is one at a time.
Result<OpenedRecording> openWithinDeadline(const std::filesystem::path& recording,
                                           const std::filesystem::path& cell = {},
                                           const ModelSearch& search = {});

/// openedCellAndRecording() within the caller's StopDeadline, with progress on a terminal: puts
/// what is to be read into `cell` and `log`. Where the cell is that of an imported recording,
/// empties `search`: its meshes were looked for by the import. Prints no warnings.
Result<OpenedRecording> openCellAndLog(std::filesystem::path& cell, std::filesystem::path& log,
                                       ModelSearch& search);
/// Prints its warnings, as the others do.
void warnOf(const OpenedRecording& opened);

/// Prints on standard error what of a log moves nothing or became no packet (LogAccount::note());
/// nothing where all is used, or the log cannot be read. `cell` may be null.
void warnOfAccount(const std::filesystem::path& log, const Cell* cell);

}  // namespace rocinante::cli
