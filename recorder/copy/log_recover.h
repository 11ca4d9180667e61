#pragma once

#include <filesystem>

#include "recorder/copy/log_make.h"

namespace rocinante {

/// What can be read of a log that is cut off, damaged, without an index or never closed, as a whole
/// log. Its end reason is the input's where that is known. Marks beside it are baked in.
/// damaged when nothing in it can be read. The report's gaps that cost something are what is
/// missing; the checksum of the whole data section is looked at too.
Result<CopyReport> recoverLog(const std::filesystem::path& log, const MakeOptions& make);

/// The same over bytes in memory, onto any sink; `name` is for messages to people.
Result<CopyReport> recoverBytes(ByteView bytes, std::string name, std::vector<Event> marks,
                                std::unique_ptr<ByteSink> sink, const LogWriterOptions& log,
                                const KeyframeOptions& keyframes, const CopyProgress& progress);

}  // namespace rocinante
