#include "viewer/page/page_findings.h"

#include <filesystem>

#include "core/report/json_text.h"

namespace rocinante {
namespace {

/// Without the folder of the file that it is about, which texts may name too.
std::string pathless(std::string text, const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  if (file.empty() || name == file) return text;
  for (std::size_t at = text.find(file); at != std::string::npos; at = text.find(file, at)) {
    text.replace(at, file.size(), name);
    at += name.size();
  }
  return text;
}

}  // namespace

std::string pageFindings(const CheckReport& report) {
  Json list = Json::array();
  for (const Finding& finding : report.findings) {
    if (finding.accepted) continue;
    Json one;
    one["severity"] = nameOf(finding.severity);
    one["rule"] = finding.rule;
    one["text"] = pathless(finding.text, finding.file);
    if (!finding.hint.empty()) one["hint"] = pathless(finding.hint, finding.file);
    one["count"] = finding.count;
    if (!finding.subject.empty()) one["subject"] = pathless(finding.subject, finding.file);
    if (finding.first) {
      one["first_ns"] = (*finding.first - report.origin).count();
      one["last_ns"] = (finding.last.value_or(*finding.first) - report.origin).count();
    }
    list.push_back(std::move(one));
  }
  return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rocinante
