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

/// Prints on standard error what of a log moves nothing or became no packet (LogAccount::note());
/// nothing where all is used, or the log cannot be read. `cell` may be null.
void warnOfAccount(const std::filesystem::path& log, const Cell* cell);

}  // namespace rocinante::cli
