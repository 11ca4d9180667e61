#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "core/session/message_folder.h"
#include "core/session/timeline.h"

namespace rocinante {

/// What a packet said: a value of a device.
struct StatedItem {
  std::string device;
  std::string value_name;  ///< of a joint; empty: whatever was last said of joints and pose
  bool operator==(const StatedItem&) const = default;
};

/// The packet that a shown value comes from.
struct PacketBehind {
  std::string source, topic;
  std::string sender;                     ///< address and port; empty: the log does not have it
  std::optional<std::uint64_t> sequence;  ///< empty: the source numbers nothing
  std::string by;                         ///< who said it again; empty: the source itself
  bool restated = false;
  LogTime time{};                           ///< of arrival
  std::optional<std::int64_t> source_time;  ///< TIME: nanoseconds since the epoch
  std::string text;                         ///< the datagram, as it came
};

/// Looks in a log for the packet behind a value: the last one up to the shown moment that said it
/// and that the fold took (not one that came late). Goes back message by message, in steps, so
/// that a window stays responsive however long ago it was. One thread.
class PacketSearch {
 public:
  /// not_found or unreadable as LogReader::open(). Reads the log beside its other readers.
  static Result<PacketSearch> open(const std::filesystem::path& log);

  /// Begins anew, unless it is for the same item and moment.
  Status begin(const StatedItem& item, LogTime moment);
  bool begun() const { return begun_; }
  const StatedItem& item() const { return item_; }
  LogTime moment() const { return moment_; }

  /// Looks at up to `messages` more. True when there is nothing more to look for.
  Result<bool> step(std::size_t messages);
  bool finished() const { return finished_; }
  /// Empty while it is not found, and when no message of the log said it.
  const std::optional<PacketBehind>& found() const { return found_; }

 private:
  PacketSearch(LogReader reader, Timeline states)
      : reader_(std::make_unique<LogReader>(std::move(reader))),
        states_(std::make_unique<Timeline>(std::move(states))),
        folder_(std::make_unique<MessageFolder>()) {}
  Result<bool> isBehind(const LogMessage& message, const Packet& packet);

  std::unique_ptr<LogReader> reader_;
  std::unique_ptr<Timeline> states_;  // beside the shown one, whose state stays valid
  std::unique_ptr<MessageFolder> folder_;
  StatedItem item_;
  LogTime moment_{};
  bool begun_ = false, finished_ = false;
  std::optional<PacketBehind> found_;
};

/// The window's question after the packet behind a value.
struct PacketLookup {
  bool wanted = false;
  bool shows_bytes = false;  ///< in place of the text
  std::string value_name;    ///< of the inspected device; empty: what was last said about it
  std::optional<PacketSearch> search;
  std::string trouble;  ///< why it cannot be answered; a sentence

  bool searching() const { return wanted && search && search->begun() && !search->finished(); }
  /// Looks on, at up to `messages` more messages of `log`.
  void look(const std::filesystem::path& log, const StatedItem& item, LogTime moment,
            std::size_t messages);
};

}  // namespace rocinante
