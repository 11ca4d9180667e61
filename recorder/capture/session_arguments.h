#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recorder/capture/record.h"

namespace CLI {
class App;
}

namespace rocinante {

/// Of the command line of rocinante-record, as it stands there: what is recorded when, in which
/// files, and what of it stays.
struct SessionArguments {
  std::string split_size, split_time;
  std::optional<std::uint64_t> keep;
  std::string disk_quota;
  bool attach_once = false;
  std::string ring, ring_after, ring_size;
  std::vector<std::string> ring_on, start_on, stop_on;
};

/// Its options, with their help. `arguments` must outlive the parsing.
void addSessionArguments(CLI::App& app, SessionArguments& arguments);

/// Fills in what they ask for. bad_argument for what cannot be, alone or together.
Status readSessionArguments(const SessionArguments& arguments, RecordOptions& options);

/// A duration of more than nothing; `option` is named when it is not.
Result<Nanoseconds> readSpan(const std::string& text, const char* option);

}  // namespace rocinante
