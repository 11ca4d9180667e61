#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// Output and exit code of a program.
struct ChildOutput {
  int exit_code = -1;  ///< 128 + the signal if one ended it
  std::string out;
  std::string err;  ///< without trailing blanks
};

/// Runs a program, found on PATH, to its end, without a shell and with empty standard input.
/// not_found when the program does not exist; refused when it prints more than `most_bytes` to
/// its standard output or error and is therefore killed.
Result<ChildOutput> childOutput(const std::vector<std::string>& words,
                                std::uint64_t most_bytes = std::uint64_t{1} << 30U);

}  // namespace rocinante
