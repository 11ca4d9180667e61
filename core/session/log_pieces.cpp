#include "core/session/log_pieces.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/log/log_profile.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// A folder of more logs than this is not a recording in pieces that anyone watches.
constexpr std::size_t kMaxOthers = 10'000;

bool follows(const LogSummary& next, const LogSummary& finished) {
  return next.messages > 0 && next.session_id == finished.session_id && next.start >= finished.end;
}

fs::file_time_type fileTimeOf(LogTime time) {
  const auto ago = std::chrono::system_clock::now().time_since_epoch() - time.time_since_epoch();
  return fs::file_time_type::clock::now() -
         std::chrono::duration_cast<fs::file_time_type::duration>(ago);
}

}  // namespace

bool NextPiece::expected(const LogReader& finished) {
  const LogSummary& summary = finished.summary();
  return summary.closed && summary.end_reason == profile::kSplitReason &&
         !summary.session_id.empty();
}

bool NextPiece::missing(const LogReader& finished) {
  if (!expected(finished)) return false;
  const auto next = NextPiece().after(finished);
  return next.ok() && !*next;
}

Result<std::optional<LogReader>> NextPiece::after(const LogReader& finished) {
  if (!expected(finished)) return std::optional<LogReader>();
  const fs::path own = finished.name();
  const fs::path folder = own.has_parent_path() ? own.parent_path() : fs::path(".");
  std::error_code fault;
  const fs::file_time_type ended =
      std::min(fs::last_write_time(own, fault), fileTimeOf(finished.summary().end));
  std::optional<LogReader> next;
  for (fs::directory_iterator each(folder, fault), end; !fault && each != end;
       each.increment(fault)) {
    std::error_code gone;
    const fs::path& path = each->path();
    if (path.extension() != own.extension() || path.filename() == own.filename()) continue;
    const fs::file_time_type changed = fs::last_write_time(path, gone);
    // It is written after the other's last message, and after the other's file unless that is a
    // copy made later; one second for coarse file times.
    if (gone || changed + std::chrono::seconds(1) < ended) continue;
    const auto known = others_.find(path);
    if (known != others_.end() && known->second == changed) continue;
    // One that has just been made may not be a log yet.
    Result<LogReader> log = LogReader::openGrowing(path);
    if (!log) continue;
    if (!follows(log->summary(), finished.summary())) {
      if (log->summary().messages > 0 && others_.size() < kMaxOthers) others_[path] = changed;
      continue;
    }
    if (!next || log->summary().start < next->summary().start) next = std::move(*log);
  }
  return next;
}

}  // namespace rocinante
