#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The maximum length of a mark's text, in bytes.
inline constexpr std::size_t kMaxMarkBytes = 4096;
/// The maximum size of LOG.marks; a larger one is neither read nor made.
inline constexpr std::uint64_t kMaxMarksFileBytes = std::uint64_t{16} << 20U;

/// The path of the marks of `log`: LOG.marks, beside it.
std::filesystem::path marksPath(const std::filesystem::path& log);

/// The marks beside `log`, in time order (equal times in the order they were set); none when the
/// file does not exist. Each is an Event with an empty source. The format is in docs/log-format.md,
/// "Marks"; a malformed line is an error with its line number.
Result<std::vector<Event>> readMarks(const std::filesystem::path& log);

/// Adds a mark to LOG.marks and flushes it to the disk; the log itself is not touched. Concurrent
/// calls from several processes lose no mark. bad_argument when the text is empty, too long or not
/// UTF-8.
Status addMark(const std::filesystem::path& log, const Event& mark);

/// One line of LOG.marks, with its LF.
std::string markLine(const Event& mark);
/// The inverse, without the LF. Empty when the line is malformed.
std::optional<Event> parseMarkLine(std::string_view line);

/// The payload of a message on /rocinante/mark (a mark copied into the log), and the inverse.
std::string markText(std::string_view text);
std::optional<std::string> parseMark(ByteView payload);

}  // namespace rocinante
