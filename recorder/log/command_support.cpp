#include "recorder/log/command_support.h"

#include <cstdio>

namespace rocinante {

Status toStandardOutput(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size()) return {};
  return Error{ErrorKind::unreadable, "cannot write to standard output", {}};
}

}  // namespace rocinante
