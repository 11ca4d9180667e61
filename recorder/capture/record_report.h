#pragma once

#include <string>

#include "recorder/capture/record.h"

namespace rocinante {

/// What a recording says of itself. Texts end without a newline.

/// A few lines for a person.
std::string summaryText(const RecordSummary& summary);

/// docs/programs/record.md, "JSON".
std::string summaryJson(const RecordSummary& summary);

}  // namespace rocinante
