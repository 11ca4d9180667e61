#include "viewer/page/page_parts.h"

#include <filesystem>
#include <string>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/data_file.h"
#include "core/report/account.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

constexpr const char* kScriptName = "rocinante-viewer.js";
constexpr const char* kViewerName = "rocinante-viewer.wasm";
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;

Error noViewer(const std::string& why) {
  return {ErrorKind::not_found,
          "the viewer of pages is not there: build it with scripts/build_web, then name its folder "
          "with --viewer DIR; " +
              why,
          {}};
}

Result<std::string> viewerFile(const std::filesystem::path& folder, const char* name) {
  if (folder.empty()) {
    const auto found = findDataFile(std::string("web/") + name);
    if (!found) return noViewer(found.error().what);
    return readFile(*found, kMostBytes);
  }
  auto content = readFile(folder / name, kMostBytes);
  if (!content) return noViewer(content.error().text());
  return content;
}

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

Status readPageViewer(const std::filesystem::path& folder, PageParts& parts) {
  auto script = viewerFile(folder, kScriptName);
  if (!script) return script.error();
  parts.viewer_script = std::move(*script);
  const auto viewer = viewerFile(folder, kViewerName);
  if (!viewer) return viewer.error();
  const ByteView bytes = bytesOf(*viewer);
  parts.viewer.assign(bytes.begin(), bytes.end());
  return {};
}

std::string pageFindings(const CheckReport& report) {
  Json list = Json::array();
  for (const Finding& finding : report.findings) {
    if (finding.accepted) continue;
    Json one;
    one["severity"] = nameOf(finding.severity);
    one["rule"] = finding.rule;
    one["text"] = pathless(sentenceOf(finding), finding.file);
    if (!finding.hint.empty()) one["hint"] = pathless(finding.hint, finding.file);
    one["count"] = finding.left_out.empty() ? finding.count : 1;  // else the text has it
    if (!finding.subject.empty()) one["subject"] = pathless(finding.subject, finding.file);
    if (finding.first) {
      one["first_ns"] = (*finding.first - report.origin).count();
      one["last_ns"] = (finding.last.value_or(*finding.first) - report.origin).count();
    }
    list.push_back(std::move(one));
  }
  return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string pageEvents(const std::vector<Event>& events, LogTime origin) {
  Json list = Json::array();
  for (const Event& event : events) {
    Json one;
    one["ns"] = (event.time - origin).count();
    one["text"] = event.text;
    list.push_back(std::move(one));
  }
  return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rocinante
