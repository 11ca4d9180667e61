#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// Names the pieces of a recording one after another (docs/programs/record.md, "Pieces"): from the
/// pattern of recordPath(), filled anew for each. Where nothing in the pattern changes, the piece's
/// number goes before the extension.
class PieceNamer {
 public:
  struct Options {
    std::string output;
    /// More pieces than one are to be expected: the first has a number too.
    bool several = false;
    bool overwrite = false;
  };
  using Ours = std::function<bool(const std::filesystem::path&)>;

  explicit PieceNamer(Options options) : options_(std::move(options)) {}

  /// The name of the next piece, which begins at `start`. That of the first is as the user wants
  /// it; a later one that is taken, by a stranger's file or by one for which `ours` is true, gives
  /// way to the next number that is free: a recording does not end because of a name. `overwrite`
  /// lets a stranger's file go, never one of ours nor one that another process is writing. refused
  /// when no number is free.
  Result<std::filesystem::path> next(LogTime start, const Ours& ours);

  /// The last name was not used after all: its number is the next one's.
  void takeBack();

 private:
  Options options_;
  std::uint64_t named_ = 0;
  std::uint64_t number_ = 0;  ///< that the last name was filled with
};

}  // namespace rocinante
