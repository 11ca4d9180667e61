#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// Names the pieces of a recording one after another (docs/programs/record.md, "Pieces"): fills the
/// pattern of recordPath() for each piece. If nothing in the pattern changes, adds the piece's
/// number before the extension.
class PieceNamer {
 public:
  struct Options {
    std::string output;
    /// Several pieces are expected: the first has a number too.
    bool several = false;
    bool overwrite = false;
  };
  using Ours = std::function<bool(const std::filesystem::path&)>;

  explicit PieceNamer(Options options) : options_(std::move(options)) {}

  /// The name of the next piece, which begins at `start`. The first name is used as given. A later
  /// name that is taken, by another file or by one for which `ours` is true, is replaced by the
  /// next free number: a recording does not end because of a name. `overwrite` allows replacing
  /// other files, but never one of ours nor one that another process is writing. refused when no
  /// number is free.
  Result<std::filesystem::path> next(LogTime start, const Ours& ours);

  /// The last name was not used: its number goes to the next one.
  void takeBack();

 private:
  Options options_;
  std::uint64_t named_ = 0;
  std::uint64_t number_ = 0;  ///< used in the last name
};

}  // namespace rocinante
