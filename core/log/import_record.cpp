#include "core/log/import_record.h"

#include <algorithm>

#include "core/base/plain_text.h"

namespace rocinante {

bool hasImportRecord(const std::vector<LogMetadata>& metadata) {
  return std::ranges::any_of(
      metadata, [](const LogMetadata& record) { return record.name == kImportRecord; });
}

std::vector<std::string> importWarningsOf(const std::vector<LogMetadata>& metadata) {
  std::vector<std::string> warnings;
  for (const LogMetadata& record : metadata) {
    if (record.name != kImportRecord) continue;
    const auto found = record.entries.find(std::string(kImportWarningsKey));
    if (found == record.entries.end()) continue;
    std::string_view rest = found->second;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      if (end > 0) warnings.push_back(plainText(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return warnings;
}

std::string importLeftOutOf(const std::vector<LogMetadata>& metadata) {
  std::string lines;
  for (const LogMetadata& record : metadata) {
    if (record.name != kImportRecord) continue;
    const auto found = record.entries.find(std::string(kImportLeftOutKey));
    if (found != record.entries.end()) lines += found->second;
  }
  return lines;
}

}  // namespace rocinante
