#pragma once

#include <filesystem>
#include <vector>

#include "golden/command/suite_arguments.h"
#include "golden/report/report.h"

namespace rocinante {

/// Pages of the sessions of what is not fine (docs/programs/page.md), and the links of its frames
/// and runs to their moments. A page that cannot be made is a note of the report: no verdict
/// depends on one. not_found without the viewer that pages are made of.
Status addSessionPages(const SuiteSession& session, const SuiteArguments& arguments,
                       const std::filesystem::path& viewer, SuiteReport& report);

}  // namespace rocinante
