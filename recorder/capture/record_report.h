#pragma once

#include <string>

#include "recorder/capture/record.h"

namespace rocinante {

/// The summary of a recording. Texts end without a newline.

/// A few lines for the user.
std::string summaryText(const RecordSummary& summary);

/// docs/programs/record.md, "JSON".
std::string summaryJson(const RecordSummary& summary);

}  // namespace rocinante
