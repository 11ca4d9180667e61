#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/packet/session_state.h"
#include "core/result.h"

namespace rocinante {

/// Where the marks of `log` lie: LOG.marks, beside it.
std::filesystem::path marksPath(const std::filesystem::path& log);

/// The marks beside `log`, in order of time; none when there is no such file. Each is an Event
/// whose source is empty. The format is docs/log-format.md's, "Marks"; a malformed line is an error
/// with its line number.
Result<std::vector<Event>> readMarks(const std::filesystem::path& log);

/// Adds one to LOG.marks; the log itself is not touched.
Status addMark(const std::filesystem::path& log, const Event& mark);

/// The payload of a message on /rocinante/mark (a mark that a tool has baked in), and back.
std::string markText(std::string_view text);
std::optional<std::string> parseMark(ByteView payload);

}  // namespace rocinante
