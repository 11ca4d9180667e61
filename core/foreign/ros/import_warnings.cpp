#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/foreign/ros/bag_import.h"
#include "core/log/import_record.h"

namespace rocinante::ros {

std::vector<std::string> importWarnings(const ImportReport& report) {
  std::vector<std::string> warnings = report.damage;
  if (report.dropped > 0) {
    warnings.push_back(
        countText(report.dropped, "message") +
        " left out: a log holds times from 1970 to 2262 and at most 128 MiB a message");
  }
  for (const ImportedTopic& topic : report.topics) {
    if (topic.malformed > 0) {
      const bool is_captured = topic.type == kDatagrams;
      warnings.push_back(topic.name + ": " + countText(topic.malformed, "message") +
                         " kept, but not the " +
                         (is_captured ? "packet text that the first word says"
                                      : topic.type + " that the recording says") +
                         (topic.fault.empty() ? "" : "; the first is " + topic.fault));
    }
    for (const auto& [sentence, count] : topic.notes) {
      warnings.push_back(topic.name + ": " + sentence + ": " + std::to_string(count));
    }
  }
  warnings.insert(warnings.end(), report.notes.begin(), report.notes.end());
  for (std::string& warning : warnings) warning = plainText(warning);
  return warnings;
}

LogMetadata warningsRecord(const ImportReport& report) {
  std::string lines;
  for (const std::string& warning : importWarnings(report)) lines += warning + "\n";
  LogMetadata record{std::string(kImportRecord),
                     {{std::string(kImportWarningsKey), std::move(lines)}}};
  if (!report.account.empty()) {
    record.entries.emplace(kImportLeftOutKey, accountLines(report.account));
  }
  return record;
}

}  // namespace rocinante::ros
