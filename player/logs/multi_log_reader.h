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
#include "player/send/datagram_stream.h"

namespace rocinante {

/// The channels to play; others are treated as if they had not been recorded. Patterns of
/// topics; channels below /rocinante/restated and /rocinante/decoded follow the one that they are
/// of.
struct ChannelChoice {
  std::vector<std::string> only;   ///< any of these; empty: all
  std::vector<std::string> muted;  ///< and none of these
  bool imported = true;            ///< imported channels too, when `only` does not name them

  bool isAll() const { return only.empty() && muted.empty() && imported; }
  bool holds(const LogChannel& channel) const;
};

/// Reads several logs as one, ordered by (log_time, argument order, file offset). Not for sharing
/// between threads.
class MultiLogReader {
 public:
  enum class Which : std::uint8_t {
    captured,  ///< sent to the recorder
    received,  ///< and what others restated
    folded,    ///< makes up the state: these, and what decoders made of them
  };

  /// Fails as LogReader::open for the first log that cannot be read.
  static Result<MultiLogReader> open(const std::vector<std::filesystem::path>& paths,
                                     ChannelChoice choice = {});

  LogTime origin() const { return origin_; }  ///< the earliest of the logs' origins
  LogTime start() const { return start_; }    ///< the first captured message of all
  LogTime end() const { return end_; }        ///< the last captured message of all
  bool empty() const { return empty_; }       ///< no captured message
  std::size_t logs() const { return inputs_.size(); }
  /// All channels of the log, chosen or not.
  const std::vector<LogChannel>& channels(std::size_t log) const {
    return inputs_[log].reader.channels();
  }
  /// Whether a log has imported channels, chosen or not.
  bool anyImported() const;
  bool chosen(std::size_t log, ChannelId channel) const;
  /// Every SOURCE that the chosen channels name, sorted.
  std::set<std::string> sources() const;
  /// Damage found in the logs so far, as sentences with file and bytes.
  std::vector<std::string> damage() const;

  /// Goes to the first message of `which` at or after `place`.
  Status seek(TapePosition place, Which which);
  /// The next message; its payload is borrowed until the next call. Empty at the end.
  Result<std::optional<LogMessage>> next();
  /// The place of the message that next() returned last.
  TapePosition place() const;

  struct Earlier {
    std::uint64_t messages = 0;     ///< number found, at most `count`
    TapePosition place{};           ///< of the earliest found; the given place when none was
    std::optional<LogTime> before;  ///< time of the message before it
  };
  /// The captured message `count` messages before `place`, not earlier than `floor`. The position
  /// of next() is undefined until the next seek.
  Result<Earlier> back(TapePosition place, std::uint64_t count, LogTime floor);

 private:
  struct Input {
    LogReader reader;
    std::vector<bool> chosen;  ///< by channel id
    std::optional<LogMessage> head;
  };

  MultiLogReader() = default;
  bool wanted(const Input& input, const LogMessage& message) const;
  Status seekInputs(TapePosition place);
  Status advance(Input& input);
  Result<std::optional<TapePosition>> previous();
  Status findRange();

  std::vector<Input> inputs_;
  Which which_ = Which::captured;
  Input* taken_ = nullptr;  ///< whose head was returned last; advanced by the next call
  LogTime origin_{}, start_{}, end_{};
  bool empty_ = true;
};

}  // namespace rocinante
