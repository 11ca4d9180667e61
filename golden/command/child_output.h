#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace rocinante {

/// What a program said, and how it ended.
struct ChildOutput {
  int exit_code = -1;  ///< 128 + the signal when one ended it
  std::string out, err;
};

/// Runs a program, found on PATH, to its end: its arguments as they are, by no shell, and nothing
/// on its standard input. not_found when there is no such program; refused when it says more than
/// `most_bytes`, and it is then killed.
Result<ChildOutput> childOutput(const std::vector<std::string>& words,
                                std::uint64_t most_bytes = std::uint64_t{1} << 30U);

}  // namespace rocinante
