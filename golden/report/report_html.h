#pragma once

#include <string>

#include "golden/report/report.h"

namespace rocinante {

/// One self-contained page: no network, pictures inside. docs/golden-report.md.
std::string reportHtml(const SuiteReport& report);

}  // namespace rocinante
