#pragma once

#include <string_view>

namespace rocinante {

// The files of golden/report/page, embedded by cmake/embed_report_page.cmake.

/// page.html: comments in capitals stand where the rest goes.
extern const std::string_view kReportPage;
extern const std::string_view kReportStyle;
/// All of the page's scripts, one after the other.
extern const std::string_view kReportScript;

}  // namespace rocinante
