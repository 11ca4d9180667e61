#pragma once

#include <string>

#include "core/check/watch/finding_watch.h"

namespace rocinante {

/// One line, without its end: "2026-02-03T04:05:06.789Z begins: error: SENTENCE [RULE]"; with the
/// count and the span when it ends.
std::string findingChangeText(const FindingChange& change);
/// One JSON object on one line, with its end (docs/programs/check.md, "A standing watch").
std::string findingChangeJson(const FindingChange& change);

/// "2026-02-03T04:05:06.789Z": to the millisecond, for people.
std::string momentText(LogTime time);

}  // namespace rocinante
