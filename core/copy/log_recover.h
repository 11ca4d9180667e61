#pragma once

#include <filesystem>

#include "core/copy/log_make.h"

namespace rocinante {

/// Copies the readable part of a log that is cut off, damaged, without an index or never closed
/// into a complete log. Keeps the input's end reason if it is known. Marks beside the log are
/// copied into it. damaged when nothing can be read. The report's gaps that cost something are what
/// is missing; the checksum of the whole data section is checked too.
Result<CopyReport> recoverLog(const std::filesystem::path& log, const MakeOptions& make);

/// The same for bytes in memory, into any sink; `name` is used in messages.
Result<CopyReport> recoverBytes(ByteView bytes, std::string name, std::vector<Event> marks,
                                std::unique_ptr<ByteSink> sink, const LogWriterOptions& log,
                                const KeyframeOptions& keyframes, const CopyProgress& progress);

}  // namespace rocinante
