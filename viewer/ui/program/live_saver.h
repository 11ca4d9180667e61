#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/child_process.h"
#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "viewer/ui/live/live_keeper.h"

namespace rocinante {

/// Saves the kept log of a live session as one ordinary log with its cell, through `rocinante log
/// merge` and `rocinante log attach`, while the session continues. Nothing is deleted meanwhile.
/// One at a time; main thread. The file appears whole or not at all.
class LiveSaver {
 public:
  struct Request {
    std::filesystem::path cell;
    ModelSearch where;
    std::filesystem::path output;
    LogTime until{};  ///< the newest datagram to be saved
  };

  bool active() const { return step_ != Step::none; }
  /// refused when one is active.
  Status start(LiveKeeper& keeper, Request request);

  struct Saved {
    std::filesystem::path file;
    std::string doubt;  ///< what is not in it, as a sentence; empty: nothing is missing
  };
  /// To be called now and then: continues, and returns the outcome once. Does not wait.
  std::optional<Result<Saved>> look(LiveKeeper& keeper);

 private:
  enum class Step { none, finishing, merging, attaching };

  Status run(const std::vector<std::string>& words);
  Status merge(const KeptProgress& kept);
  Status attach(const std::filesystem::path& log);
  Result<Saved> end(LiveKeeper& keeper, std::optional<Error> fault);

  Step step_ = Step::none;
  Request request_;
  std::filesystem::path merged_;  ///< in the folder of the kept log
  std::string doubt_;
  std::optional<ChildProcess> process_;  ///< ended with this; it leaves no partial file
};

/// "live-20261123T150405.mcap" in `folder`, or with -2, -3 appended if that exists.
std::filesystem::path freeLiveName(const std::filesystem::path& folder, WallTime now);

}  // namespace rocinante
