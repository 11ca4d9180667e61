#include "golden/why/model_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/plain_text.h"
#include "core/bundle/cell_folder.h"
#include "core/check/drift/model_drift.h"
#include "golden/why/file_change.h"

namespace rocinante {
namespace {

void addTo(ModelChanges& changes, ModelChanges more) {
  changes.insert(changes.end(), std::make_move_iterator(more.begin()),
                 std::make_move_iterator(more.end()));
}

ModelChange::Seen seenOf(std::string_view rule) {
  if (rule == "drift.camera") return ModelChange::Seen::camera;
  for (const std::string_view unseen : {"drift.collision", "drift.joint-limits", "drift.layer",
                                        "drift.device-optional", "drift.model-removed"}) {
    if (rule == unseen) return ModelChange::Seen::never;
  }
  return ModelChange::Seen::drawn;
}

/// Without what it would do to a replay: "...: everything attached to it would be drawn there".
std::string withoutEffect(const std::string& text) {
  const std::size_t colon = text.rfind(": ");
  const bool is_effect =
      colon != std::string::npos && text.find(" would ", colon) != std::string::npos;
  return is_effect ? text.substr(0, colon) : text;
}

ModelChanges driftChanges(const Cell& golden, const Cell& now) {
  ModelChanges changes;
  for (const Finding& finding : modelDrift(golden, now)) {
    changes.push_back(
        {plainText(withoutEffect(finding.text)), finding.subject, seenOf(finding.rule)});
  }
  std::stable_partition(changes.begin(), changes.end(), [](const ModelChange& change) {
    return change.seen != ModelChange::Seen::never;
  });
  return changes;
}

}  // namespace

std::vector<std::string> textsOf(const ModelChanges& changes) {
  std::vector<std::string> texts;
  for (const ModelChange& change : changes) texts.push_back(change.text);
  return texts;
}

ModelChanges cellFaults(const Cell& cell) {
  ModelChanges changes;
  for (const Finding& fault : cell.faults) {
    if (fault.severity != Severity::error) continue;
    std::string place = fault.file.empty() ? "" : fault.file + ": ";
    if (fault.line > 0) place.insert(place.size() - 2, fmt::format(":{}", fault.line));
    changes.push_back({plainText(place + fault.text)});
  }
  return changes;
}

ModelChanges changedFiles(const FileHashes& golden, const FileHashes& frame,
                          const FileTexts& texts) {
  ModelChanges changes;
  for (FileChange& file : fileChanges(golden, frame, texts)) {
    changes.push_back({std::move(file.text),
                       {},
                       file.is_recorded ? ModelChange::Seen::maybe : ModelChange::Seen::drawn});
  }
  std::stable_partition(changes.begin(), changes.end(), [](const ModelChange& change) {
    return change.seen == ModelChange::Seen::drawn;
  });
  return changes;
}

ModelChanges modelChanges(const Cell& golden, const Cell& now) {
  ModelChanges changes = cellFaults(now);
  addTo(changes, driftChanges(golden, now));
  return changes;
}

ModelChanges modelChanges(const FileHashes& golden, const FileTexts& texts, CellBundle& today,
                          const Cell& now, const FileContents& at_hand) {
  ModelChanges changes;
  const FileHashes files_today = hashesOf(today);
  FileTexts all_texts = recordedTexts(today);
  all_texts.insert(texts.begin(), texts.end());
  const GoldenTexts put_back(today, golden, texts, at_hand);
  if (put_back.any()) {
    const auto before = loadBundle(today, "", {});
    if (before.ok()) addTo(changes, driftChanges(*before, now));
  }
  addTo(changes, changedFiles(golden, files_today, all_texts));
  if (put_back.unknown() > 0) {
    changes.push_back(
        {"changes in these texts are unknown: the golden was accepted before texts were kept",
         {},
         ModelChange::Seen::never});
  }
  return changes;
}

}  // namespace rocinante
