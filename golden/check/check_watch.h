#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/watch/finding_watch.h"
#include "core/cli/program.h"
#include "core/foreign/decode/decoder_set.h"

namespace rocinante {

/// A standing watch: `check --live EP --watch`.
struct CheckWatchOptions : WatchOptions {
  std::vector<std::string> endpoints;
  std::string trust_file;
  /// Make packets of what is not packet text; null for none.
  std::shared_ptr<const decode::DecoderSet> decoders;
  std::optional<Nanoseconds> duration;  ///< empty: until it is stopped
  bool until_finding = false;           ///< ends when a finding that fails begins
  std::string command;                  ///< run for each change; empty: none
  bool json = false, quiet = false;
};

/// Judges what the endpoints receive until a stop signal, the end of a capture file or one of the
/// options ends it. Prints each finding as it begins and ends, and last a summary, on standard
/// output; the bound endpoints, and on a terminal a status line, on standard error. Tells a service
/// manager that it is ready and alive. `no` when a finding that fails began, else could_not_run
/// when no packet could be decoded. Fails when it cannot listen, or its command is not found.
Result<cli::Exit> watchLive(const Cell& cell, const CheckWatchOptions& options);

}  // namespace rocinante
