#include <algorithm>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/unfinished_path.h"
#include "core/bundle/attached_cell.h"
#include "core/copy/copy_report.h"
#include "core/copy/log_edits.h"
#include "core/log/log_profile.h"
#include "core/log/log_reader.h"
#include "viewer/page/page_file.h"
#include "viewer/page/page_job.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

Result<Bytes> bytesOfFile(const fs::path& path) {
  const auto text = readFile(path, kMostPageBytes);
  if (!text) return text.error();
  const ByteView view = bytesOf(*text);
  return Bytes(view.begin(), view.end());
}

/// Copies all but the cell that the log carries.
class WithoutCell final : public CopyAddition {
 public:
  bool keeps(const LogAttachment& attachment) const override {
    return attachment.name != profile::kCellManifest &&
           !attachment.name.starts_with(profile::kCellFolder);
  }
  bool keepsCell() const override { return false; }
  Status begin(PieceWriter&, LogTime) override { return {}; }
  Status follow(const CopyItem&, PieceWriter&) override { return {}; }
};

}  // namespace

Result<Bytes> carriedLog(const PageJob& job, PageReport& report) {
  SelectionOptions selection;
  selection.from = job.from;
  selection.until = job.until;
  const bool is_part = selection.anyTime();
  const auto reader = LogReader::open(job.log);
  const bool has_cell = reader && carriesCell(*reader);
  if (!is_part && !has_cell) return bytesOfFile(job.log);
  MakeOptions make;
  // Beside the page, where there is room for it.
  make.output = job.output;
  make.output += ".cut.mcap";
  WithoutCell without_cell;
  const auto cut =
      cutLog(job.log, selection, make, "rocinante page", has_cell ? &without_cell : nullptr);
  if (!cut && is_part) return cut.error();
  if (!cut) return bytesOfFile(job.log);
  const UnfinishedPath removed(make.output);
  // Of a whole log the page itself tells where the damage is.
  if (!is_part && !cut->gaps.empty()) return bytesOfFile(job.log);
  for (const CopyGap& gap : cut->gaps) report.warnings.push_back(gapText(gap));
  for (const std::string& note : cut->notes) report.warnings.push_back(note);
  if (!report.warnings.empty()) report.is_whole = false;
  return bytesOfFile(make.output);
}

}  // namespace rocinante
