#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/log/log_reader.h"
#include "core/result.h"

namespace rocinante {

/// Several logs read as one: in order of (log_time, place among the arguments, file offset).
/// Not for sharing between threads.
class LogMerge {
 public:
  enum class Which : std::uint8_t {
    captured,  ///< what was sent to the recorder
    folded,    ///< what the state is made of: the captured, and restatements of others
  };

  /// Fails as LogReader::open does, on the first log that cannot be read.
  static Result<LogMerge> open(const std::vector<std::filesystem::path>& paths);

  LogTime origin() const { return origin_; }  ///< the earliest of the logs' origins
  LogTime start() const { return start_; }    ///< the first captured message of all
  LogTime end() const { return end_; }        ///< the last captured message of all
  std::uint64_t messages() const { return messages_; }
  /// Every SOURCE that the logs' channels name, sorted.
  std::set<std::string> sources() const;
  /// Breaks found in any of the logs so far, as sentences with file and bytes.
  std::vector<std::string> damage() const;

  /// Goes to the first of `which` with log_time >= `moment`.
  Status seek(LogTime moment, Which which);
  /// The next message; its payload is borrowed until the next call. Empty at the end.
  Result<std::optional<LogMessage>> next();

 private:
  struct Input {
    LogReader reader;
    std::optional<LogMessage> head;
  };

  LogMerge() = default;
  Status advance(Input& input);

  std::vector<Input> inputs_;
  Which which_ = Which::captured;
  Input* taken_ = nullptr;  ///< whose head was handed out last; it moves on at the next call
  LogTime origin_{}, start_{}, end_{};
  std::uint64_t messages_ = 0;
};

}  // namespace rocinante
