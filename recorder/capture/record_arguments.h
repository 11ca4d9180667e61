#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/cli/command_line.h"
#include "recorder/capture/record.h"
#include "recorder/capture/session_arguments.h"

namespace rocinante {

/// The command line of rocinante-record, unparsed.
struct RecordArguments : ModelSearch {
  std::vector<std::string> endpoints;
  std::vector<std::string> allow;
  std::string trust;
  std::vector<std::string> tees;
  std::string wait_interface;
  bool no_wait = false;
  std::string output;
  std::string cell;
  std::string decoders;
  std::string duration;
  std::optional<std::uint64_t> max_packets, max_loss;
  std::uint64_t min_packets = 0;
  SessionArguments session;
  std::string status;
  std::string compression = "zstd";
  std::string sync = "100ms";
  bool force = false;
  bool json = false;
  bool quiet = false;
};

/// Adds the options with their help. `arguments` must outlive parsing.
void addRecordArguments(cli::CommandLine app, RecordArguments& arguments);

/// Period of the status lines; empty: none.
Result<std::optional<Nanoseconds>> readStatusPeriod(const RecordArguments& arguments);

/// Parses the arguments. Reads the files of trust and decoders; binds and creates nothing.
/// `arguments` must outlive the result, which loads the cell later.
Result<RecordOptions> readRecordArguments(const RecordArguments& arguments);

}  // namespace rocinante
