#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "recorder/record.h"

namespace CLI {
class App;
}

namespace rocinante {

/// What the command line of rocinante-record says, as it stands there.
struct RecordArguments {
  std::vector<std::string> endpoints;
  std::string output;
  std::string cell;
  std::vector<std::filesystem::path> search;
  bool search_environment = false;
  std::string duration;
  std::optional<std::uint64_t> max_packets, max_loss;
  std::uint64_t min_packets = 0;
  std::string compression = "zstd";
  std::string sync = "100ms";
  bool force = false;
  bool json = false;
  bool quiet = false;
};

/// Its options, with their help. `arguments` must outlive the parsing.
void addRecordArguments(CLI::App& app, RecordArguments& arguments);

/// What they ask for. Reads the cell, if there is one, with all its files; binds and makes nothing.
Result<RecordOptions> readRecordArguments(const RecordArguments& arguments);

}  // namespace rocinante
