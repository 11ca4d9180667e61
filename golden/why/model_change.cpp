#include "golden/why/model_change.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/plain_text.h"
#include "core/bundle/cell_folder.h"
#include "core/check/drift/model_drift.h"
#include "golden/why/file_change.h"
#include "golden/why/golden_texts.h"

namespace rocinante {
namespace {

void addTo(std::vector<std::string>& lines, std::vector<std::string> more) {
  lines.insert(lines.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

std::vector<std::string> driftLines(const Cell& golden, const Cell& now) {
  std::vector<std::string> lines;
  for (const Finding& finding : modelDrift(golden, now)) lines.push_back(plainText(finding.text));
  return lines;
}

}  // namespace

std::vector<std::string> cellFaults(const Cell& cell) {
  std::vector<std::string> lines;
  for (const Finding& fault : cell.faults) {
    if (fault.severity != Severity::error) continue;
    std::string place = fault.file.empty() ? "" : fault.file + ": ";
    if (fault.line > 0) place.insert(place.size() - 2, fmt::format(":{}", fault.line));
    lines.push_back(plainText(place + fault.text));
  }
  return lines;
}

std::vector<std::string> modelChanges(const Cell& golden, const Cell& now) {
  std::vector<std::string> lines = cellFaults(now);
  addTo(lines, driftLines(golden, now));
  return lines;
}

std::vector<std::string> modelChanges(const FileHashes& golden, const FileTexts& texts,
                                      CellBundle& today, const Cell& now) {
  std::vector<std::string> lines;
  const FileHashes files_today = hashesOf(today);
  const GoldenTexts put_back(today, golden, texts);
  if (put_back.any()) {
    const auto before = loadBundle(today, "", {});
    if (before.ok()) addTo(lines, driftLines(*before, now));
  }
  addTo(lines, fileChanges(golden, files_today));
  if (put_back.unknown() > 0) {
    lines.push_back(
        "changes in these texts are unknown: the golden was accepted before texts were kept");
  }
  return lines;
}

}  // namespace rocinante
