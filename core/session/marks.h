#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The longest text of a mark, in bytes.
inline constexpr std::size_t kMaxMarkBytes = 4096;
/// LOG.marks holds at most this; a larger one is not read and not made.
inline constexpr std::uint64_t kMaxMarksFileBytes = std::uint64_t{16} << 20U;

/// Where the marks of `log` lie: LOG.marks, beside it.
std::filesystem::path marksPath(const std::filesystem::path& log);

/// The marks beside `log`, in order of time (equal times as they were set); none when there is no
/// such file. Each is an Event whose source is empty. The format is docs/log-format.md's, "Marks";
/// a malformed line is an error with its line number.
Result<std::vector<Event>> readMarks(const std::filesystem::path& log);

/// Adds one to LOG.marks and hands it to the disk; the log itself is not touched. Processes that
/// mark at once lose nothing. bad_argument when the text is empty, too long or no UTF-8.
Status addMark(const std::filesystem::path& log, const Event& mark);

/// One line of LOG.marks, with its LF.
std::string markLine(const Event& mark);
/// Back, without the LF. Empty when the line is malformed.
std::optional<Event> parseMarkLine(std::string_view line);

/// The payload of a message on /rocinante/mark (a mark that a tool has baked in), and back.
std::string markText(std::string_view text);
std::optional<std::string> parseMark(ByteView payload);

}  // namespace rocinante
