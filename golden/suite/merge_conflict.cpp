#include "golden/suite/merge_conflict.h"

#include "core/base/plain_text.h"

namespace rocinante {

std::optional<Error> mergeConflictIn(std::string_view text, const std::string& file,
                                     std::string_view what, std::string_view advice) {
  constexpr std::string_view kMark = "<<<<<<< ";
  std::size_t at = text.starts_with(kMark) ? 0 : text.find("\n" + std::string(kMark));
  if (at == std::string_view::npos) return std::nullopt;
  if (at > 0) ++at;
  return Error{ErrorKind::damaged,
               std::string(what) + " holds a conflict of a git merge: " + std::string(advice),
               file + placeIn(text, at + 1)};
}

}  // namespace rocinante
