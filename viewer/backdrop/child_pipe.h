#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/child_process.h"
#include "core/base/result.h"

namespace rocinante {

/// A child program whose output is read as it comes. Not thread-safe.
class ChildPipe {
 public:
  /// not_found when there is no such program. What still runs is ended with this.
  static Result<ChildPipe> start(const std::vector<std::string>& words);

  /// Fills `into`; fewer bytes at the end of the output. refused when `stopped`, which is asked ten
  /// times a second and may be empty, says so, or when nothing comes for 30 s.
  Result<std::size_t> read(std::span<std::uint8_t> into, const std::function<bool()>& stopped);
  /// Waits for its end: whether it was well, and else what it said, on one line.
  Status ended();

 private:
  explicit ChildPipe(ChildProcess child) : child_(std::move(child)) {}

  ChildProcess child_;
};

}  // namespace rocinante
