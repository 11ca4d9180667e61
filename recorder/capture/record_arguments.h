#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "recorder/capture/record.h"
#include "recorder/capture/session_arguments.h"

namespace CLI {
class App;
}

namespace rocinante {

/// What the command line of rocinante-record says, as it stands there.
struct RecordArguments : ModelSearch {
  std::vector<std::string> endpoints;
  std::vector<std::string> allow;
  std::vector<std::string> tees;
  std::string wait_interface;
  std::string output;
  std::string cell;
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

/// Its options, with their help. `arguments` must outlive the parsing.
void addRecordArguments(CLI::App& app, RecordArguments& arguments);

/// How often a line of its own says how the recording stands; empty: never.
Result<std::optional<Nanoseconds>> readStatusPeriod(const RecordArguments& arguments);

/// What they ask for. Reads no file, binds and makes nothing. `arguments` must outlive it: the cell
/// is loaded later.
Result<RecordOptions> readRecordArguments(const RecordArguments& arguments);

}  // namespace rocinante
