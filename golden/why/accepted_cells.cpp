#include "golden/why/accepted_cells.h"

#include <algorithm>

#include "core/behaviour/track_cache.h"
#include "core/bundle/cell_folder.h"
#include "golden/why/file_change.h"
#include "golden/why/frame_explainer.h"
#include "golden/why/golden_texts.h"

namespace rocinante {
namespace {

/// Of files that define kinematics; a mesh moves nothing.
bool haveTextsChanged(const FileHashes& before, const FileHashes& today) {
  return std::ranges::any_of(before, [&](const auto& file) {
    const auto now = today.find(file.first);
    return isRecordedText(file.first) && (now == today.end() || now->second != file.second);
  });
}

}  // namespace

AcceptedCell AcceptedCells::of(const AcceptedRun& accepted) {
  const std::string today = trackCellHash(session_.cell());
  if (accepted.kinematics == today) return {};
  const auto [place, is_new] = cells_.try_emplace(accepted.cell);
  Rebuilt& its = place->second;
  if (is_new) {
    its = rebuilt(accepted);
    if (its.cell && trackCellHash(*its.cell) == today) its.cell.reset();
  }
  return {its.cell ? &*its.cell : nullptr, its.unknown};
}

AcceptedCells::Rebuilt AcceptedCells::rebuilt(const AcceptedRun& accepted) {
  bool has_changed = !accepted.kinematics.empty();
  const auto cannot = [&](const char* why) {
    return Rebuilt{{}, has_changed ? why : std::string()};
  };
  const FileHashes* const before = session_.manifest().cellNamed(accepted.cell);
  if (before == nullptr) return cannot("its files were not kept");
  if (!collected_) {
    collected_ = true;
    auto bundle = collectSessionCell(session_, options_);
    if (bundle.ok()) today_ = std::move(*bundle);
  }
  if (!today_) return cannot("today's cell has errors");
  if (hashesOf(*today_) == *before) return {};
  has_changed = has_changed || haveTextsChanged(*before, hashesOf(*today_));
  const GoldenTexts put_back(*today_, *before, session_.manifest().texts);
  if (!put_back.any()) return cannot("its texts were not kept");
  CellOptions options;
  options.geometry = false;
  auto cell = loadBundle(*today_, "", options);
  const auto isError = [](const Finding& fault) { return fault.severity == Severity::error; };
  if (!cell.ok() || std::ranges::any_of(cell->faults, isError)) {
    return cannot("it does not load with today's files");
  }
  return {std::move(*cell), {}};
}

}  // namespace rocinante
