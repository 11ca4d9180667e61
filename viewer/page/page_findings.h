#pragma once

#include <string>

#include "core/check/rules/check_report.h"

namespace rocinante {

/// JSON: the findings of a report as a page lists them: severity, rule, text, hint, count, subject,
/// first_ns and last_ns from the session's origin where they have times. Of paths only file names.
std::string pageFindings(const CheckReport& report);

}  // namespace rocinante
