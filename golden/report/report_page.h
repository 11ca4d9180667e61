#pragma once

#include <string_view>

namespace rocinante {

// The files of golden/report/page, embedded by cmake/embed_report_page.cmake.

/// page.html; comments in capitals mark where the rest is inserted.
extern const std::string_view kReportPage;
extern const std::string_view kReportStyle;
/// All of the page's scripts, concatenated.
extern const std::string_view kReportScript;

}  // namespace rocinante
