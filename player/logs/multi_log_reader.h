#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "player/send/tape_position.h"

namespace rocinante {

/// Which channels of the logs are there at all; the others are as if they had not been recorded.
/// Patterns are a shell's and match topics; a restated channel (/rocinante/restated/...) goes with
/// the one that it restates.
struct ChannelChoice {
  std::vector<std::string> only;   ///< any of these; empty: all
  std::vector<std::string> muted;  ///< and none of these

  bool isAll() const { return only.empty() && muted.empty(); }
  bool holds(std::string_view topic) const;
};

/// Several logs read as one: in order of (log_time, place among the arguments, file offset).
/// Not for sharing between threads.
class MultiLogReader {
 public:
  enum class Which : std::uint8_t {
    captured,  ///< what was sent to the recorder
    folded,    ///< what the state is made of: the captured, and restatements of others
  };

  /// Fails as LogReader::open does, on the first log that cannot be read.
  static Result<MultiLogReader> open(const std::vector<std::filesystem::path>& paths,
                                     ChannelChoice choice = {});

  LogTime origin() const { return origin_; }  ///< the earliest of the logs' origins
  LogTime start() const { return start_; }    ///< the first captured message of all
  LogTime end() const { return end_; }        ///< the last captured message of all
  bool empty() const { return empty_; }       ///< no captured message
  std::size_t logs() const { return inputs_.size(); }
  /// Of the whole log, chosen or not.
  const std::vector<LogChannel>& channels(std::size_t log) const {
    return inputs_[log].reader.channels();
  }
  bool chosen(std::size_t log, ChannelId channel) const;
  /// Every SOURCE that the chosen channels name, sorted.
  std::set<std::string> sources() const;
  /// Breaks found in any of the logs so far, as sentences with file and bytes.
  std::vector<std::string> damage() const;

  /// Goes to the first of `which` at or behind `place`.
  Status seek(TapePosition place, Which which);
  /// The next message; its payload is borrowed until the next call. Empty at the end.
  Result<std::optional<LogMessage>> next();
  /// Of the message that next() returned last.
  TapePosition place() const;

  struct Earlier {
    std::uint64_t messages = 0;     ///< how many were found, at most as many as were asked for
    TapePosition place{};           ///< of the earliest of them; where one was, when there are none
    std::optional<LogTime> before;  ///< the time of the one before that
  };
  /// The captured message that lies `count` of them before `place`, not earlier than `floor`. Where
  /// next() goes on is undefined until the next seek.
  Result<Earlier> back(TapePosition place, std::uint64_t count, LogTime floor);

 private:
  struct Input {
    LogReader reader;
    std::vector<bool> chosen;  ///< by channel id
    std::optional<LogMessage> head;
  };

  MultiLogReader() = default;
  bool wanted(const Input& input, const LogMessage& message) const;
  Status stand(TapePosition place);
  Status advance(Input& input);
  Result<std::optional<TapePosition>> previous();
  Status findRange();

  std::vector<Input> inputs_;
  Which which_ = Which::captured;
  Input* taken_ = nullptr;  ///< whose head was handed out last; it moves on at the next call
  LogTime origin_{}, start_{}, end_{};
  bool empty_ = true;
};

}  // namespace rocinante
