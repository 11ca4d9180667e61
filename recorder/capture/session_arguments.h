#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/cli/command_line.h"
#include "recorder/capture/record.h"

namespace rocinante {

/// The part of rocinante-record's command line about when to record, into which files, and which of
/// them to keep; unparsed.
struct SessionArguments {
  std::string split_size, split_time;
  std::optional<std::uint64_t> keep;
  std::string disk_quota;
  bool attach_once = false;
  std::string ring, ring_after, ring_size;
  std::vector<std::string> ring_on, start_on, stop_on;
  std::string watch;  ///< a cell
  std::string watch_severity = "error";
};

/// Adds the options with their help. `arguments` must outlive parsing.
void addSessionArguments(cli::CommandLine app, SessionArguments& arguments);

/// Fills in `options`. bad_argument for invalid values or combinations.
Status readSessionArguments(const SessionArguments& arguments, RecordOptions& options);

/// A duration greater than zero; the error names `option`.
Result<Nanoseconds> readSpan(const std::string& text, const char* option);

}  // namespace rocinante
