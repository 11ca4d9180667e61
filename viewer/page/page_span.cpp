#include "viewer/page/page_span.h"

#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/unfinished_path.h"
#include "core/copy/copy_report.h"
#include "core/copy/log_cut.h"
#include "viewer/page/page_limits.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

Result<Bytes> bytesOfFile(const fs::path& path) {
  const auto text = readFile(path, kMostPageBytes);
  if (!text) return text.error();
  const ByteView view = bytesOf(*text);
  return Bytes(view.begin(), view.end());
}

}  // namespace

Result<Bytes> carriedLog(const PageJob& job, PageReport& report) {
  SelectionOptions selection;
  selection.from = job.from;
  selection.until = job.until;
  if (!selection.anyTime()) return bytesOfFile(job.log);
  MakeOptions make;
  // Beside the page, where there is room for it.
  make.output = job.output;
  make.output += ".cut.mcap";
  const auto cut = cutLog(job.log, selection, make, "rocinante page");
  if (!cut) return cut.error();
  const UnfinishedPath removed(make.output);
  for (const CopyGap& gap : cut->gaps) report.warnings.push_back(gapText(gap));
  for (const std::string& note : cut->notes) report.warnings.push_back(note);
  if (!report.warnings.empty()) report.is_whole = false;
  return bytesOfFile(make.output);
}

}  // namespace rocinante
