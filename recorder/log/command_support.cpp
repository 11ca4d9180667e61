#include "recorder/log/command_support.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "core/base/duration_text.h"
#include "core/base/rough_duration.h"

namespace rocinante {

Status toStandardOutput(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size()) return {};
  return Error{ErrorKind::unreadable, "cannot write to standard output", {}};
}

Result<Nanoseconds> readEvery(const std::string& text, Nanoseconds span, std::int64_t most) {
  const Result<Nanoseconds> every = parseDuration(text);
  if (!every) return every.error();
  if (every->count() <= 0) {
    return Error{ErrorKind::bad_argument, "must be greater than zero", "--every"};
  }
  if (span / *every >= most) {
    return Error{ErrorKind::bad_argument,
                 fmt::format("more than {} moments in {}; take a longer time, or a part of it by "
                             "--from and --until",
                             most, roughDuration(span)),
                 "--every"};
  }
  return every;
}

}  // namespace rocinante
