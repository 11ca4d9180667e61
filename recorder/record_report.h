#pragma once

#include <cstdint>
#include <string>

#include "recorder/record.h"

namespace rocinante {

/// What a recording says of itself. Texts end without a newline.

/// "1.2 MB": decimal units, three digits or so.
std::string sizeText(std::uint64_t bytes);

/// One line for a terminal; `before` is the progress shown last, from which the rate comes.
std::string statusText(const RecordProgress& now, const RecordProgress& before);

/// A few lines for a person.
std::string summaryText(const RecordSummary& summary);

/// docs/programs/record.md, "JSON".
std::string summaryJson(const RecordSummary& summary);

}  // namespace rocinante
