#include "core/recording/piece_namer.h"

#include "core/base/file_lock.h"
#include "core/recording/record_path.h"

namespace rocinante {
namespace {

/// Files of other recordings in the way: beyond this many the user should look.
constexpr std::uint64_t kMaxTaken = 100'000;

}  // namespace

Result<std::filesystem::path> PieceNamer::next(LogTime start, const Ours& ours) {
  const WallTime wall(start.time_since_epoch());
  const ChangingName changing = changingName(options_.output);
  ++named_;
  ++number_;
  const auto may_have = [&](const std::filesystem::path& path) {
    // The first name is refused by the code that makes the file, with its own message.
    std::error_code ignored;
    return named_ == 1 || !std::filesystem::exists(path, ignored) ||
           (options_.overwrite && !ours(path) && mayReplace(path));
  };
  const bool alone = named_ == 1 && !options_.several;
  if (!changing.number && (changing.time || alone)) {
    Result<std::filesystem::path> path = recordPath(options_.output, wall);
    if (!path || may_have(*path)) return path;
  }
  for (const std::uint64_t last = number_ + kMaxTaken; number_ < last; ++number_) {
    Result<std::filesystem::path> path = recordPath(options_.output, wall, number_);
    if (!path) return path;
    if (!changing.number) path = numberedPath(*path, number_);
    if (may_have(*path)) return path;
  }
  return Error{ErrorKind::refused, "no name is free for the next piece", options_.output};
}

void PieceNamer::takeBack() {
  --named_;
  --number_;
}

}  // namespace rocinante
