#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "core/copy/copy_source.h"
#include "core/log/octets_before.h"
#include "core/recording/session_writer.h"

namespace rocinante {

/// Options of an output log.
struct PieceOptions {
  LogWriterOptions log;
  KeyframeOptions keyframes;
  std::string session_id;
  std::optional<LogTime> origin;  ///< empty: that of its first captured message
};

/// Counts of one output.
struct PieceCounts {
  std::uint64_t messages = 0;  ///< captured
  std::uint64_t restated = 0;
  std::uint64_t decoded = 0;  ///< packets that decoders made, directly behind their octets
  std::uint64_t keyframes = 0;
  std::uint64_t losses = 0;
  std::uint64_t marks = 0;
  std::uint64_t attachments = 0;
  std::uint64_t channels = 0;  ///< captured
  std::uint64_t bytes = 0;     ///< of the file, once it is finished
  LogTime start{}, end{};      ///< of its captured messages
};

/// Writes one output of a copy: equal channels (topic, encoding, metadata) become one, keyframes
/// are made again, everything else is copied unchanged.
class PieceWriter {
 public:
  static Result<PieceWriter> start(std::unique_ptr<ByteSink> sink, const PieceOptions& options);

  /// Writes the state before the piece. Call before anything else of the session.
  Status begin(const SessionState& preceding, LogTime moment);
  /// An opening that follows other items is repeated on /rocinante/restated/keyframe, unless it
  /// equals the fold.
  Status add(const CopyItem& item);
  /// A packet decoded from the message that add() wrote last; `metadata` are the channel's own
  /// besides those of that message's channel.
  Status addDecoded(const CopyItem& octets, const std::map<std::string, std::string>& metadata,
                    std::string_view text);
  Status addAttachment(const LogAttachment& attachment, ByteView data);
  Status addMetadata(const LogMetadata& metadata) { return session_.log().writeMetadata(metadata); }
  /// Drops all references to the readers whose messages were added, so that they may be destroyed.
  void forgetInputs();
  /// Closes the log. Only counts() may be called afterwards.
  Status finish(std::string reason);

  const SessionState& state() const { return session_.state(); }
  const PieceCounts& counts() const { return counts_; }
  /// Approximate size of the file if it were finished now.
  std::uint64_t bytesSoFar() const;

 private:
  struct ChannelKey {
    std::string topic, encoding;
    std::map<std::string, std::string> metadata;
    LogSchema schema;  ///< empty: none
    auto operator<=>(const ChannelKey&) const = default;
  };
  /// Output ids of the inputs' channels. Readers do not move their channels.
  using ChannelIds = std::unordered_map<const LogChannel*, ChannelId>;

  explicit PieceWriter(SessionWriter session) : session_(std::move(session)) {}

  Result<ChannelId> channelFor(const LogChannel& channel, bool restated);
  Result<ChannelId> addChannel(ChannelKey key, std::shared_ptr<const LogSchema> schema);
  Status addMessage(const CopyItem& item);
  Status sayAgain(const SessionState& state, LogTime time);
  void countBytes(std::size_t payload_bytes);

  SessionWriter session_;
  std::map<ChannelKey, ChannelId> channels_;
  ChannelIds ids_;
  ChannelIds restated_ids_;
  OctetsBefore octets_before_;
  PieceCounts counts_;
  bool begun_ = false;
  std::uint32_t restated_count_ = 0;
  std::uint64_t chunk_start_ = 0;    ///< bytes written before the open chunk
  std::uint64_t pending_bytes_ = 0;  ///< of records in the open chunk
  std::uint64_t index_bytes_ = 0;    ///< of indexes still to be written
};

}  // namespace rocinante
