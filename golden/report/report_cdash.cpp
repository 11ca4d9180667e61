#include "golden/report/report_cdash.h"

#include <fmt/format.h>

#include "golden/compare/cdash_lines.h"

namespace rocinante {

std::string reportCdash(const SuiteReport& report, const std::filesystem::path& folder) {
  std::string text;
  for (const JudgedFrame& judged : report.frames) {
    if (isFine(judged.verdict)) continue;
    const std::string name = text.empty() ? "" : " " + judged.frame.name;
    const auto add = [&](std::string_view role, const char* ending) {
      const std::filesystem::path file = folder / (judged.frame.name + ending);
      std::error_code ignored;
      if (!std::filesystem::exists(file, ignored)) return;
      text += cdashPicture(fmt::format("{}{}", role, name), file);
    };
    add(kCdashFrame, ".frame.png");
    add(kCdashGolden, ".golden.png");
    add(kCdashDifference, ".difference.png");
  }
  return text;
}

}  // namespace rocinante
