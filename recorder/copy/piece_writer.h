#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>

#include "core/recording/session_writer.h"
#include "recorder/copy/copy_source.h"

namespace rocinante {

/// What a log that is made of others is to be.
struct PieceOptions {
  LogWriterOptions log;
  KeyframeOptions keyframes;
  std::string session_id;
  std::optional<LogTime> origin;  ///< empty: that of its first captured message
};

/// What went into one.
struct PieceCounts {
  std::uint64_t messages = 0;  ///< captured
  std::uint64_t restated = 0;
  std::uint64_t keyframes = 0;
  std::uint64_t losses = 0;
  std::uint64_t marks = 0;
  std::uint64_t attachments = 0;
  std::uint64_t channels = 0;  ///< captured
  std::uint64_t bytes = 0;     ///< of the file, once it is finished
  LogTime start{}, end{};      ///< of its captured messages
};

/// Writes one output of a copy: channels that are equal (topic, encoding, metadata) become one,
/// keyframes are made anew, everything else goes over as it is.
class PieceWriter {
 public:
  static Result<PieceWriter> start(std::unique_ptr<ByteSink> sink, const PieceOptions& options);

  /// What precedes the piece, before anything else of the session.
  Status begin(const SessionState& preceding, LogTime moment);
  /// An opening that comes when something stands there already is said again, on
  /// /rocinante/restated/keyframe, unless the fold says the same.
  Status add(const CopyItem& item);
  Status addAttachment(const LogAttachment& attachment, ByteView data);
  Status addMetadata(const LogMetadata& metadata) { return session_.log().writeMetadata(metadata); }
  /// The readers whose messages came so far may go: nothing of them is held any more.
  void forgetInputs();
  /// Closes the log. Nothing may be called after it but counts().
  Status finish(std::string reason);

  const SessionState& state() const { return session_.state(); }
  const PieceCounts& counts() const { return counts_; }
  /// About what the file would have if it were finished now.
  std::uint64_t bytesSoFar() const;

 private:
  using ChannelKey = std::tuple<std::string, std::string, std::map<std::string, std::string>>;
  /// How channels of the inputs are called here. Those of readers stay where they are.
  using ChannelIds = std::unordered_map<const LogChannel*, ChannelId>;

  explicit PieceWriter(SessionWriter session) : session_(std::move(session)) {}

  Result<ChannelId> channelFor(const LogChannel& channel, bool restated);
  Result<ChannelId> addChannel(ChannelKey key);
  Status addMessage(const CopyItem& item);
  Status sayAgain(const SessionState& state, LogTime time);
  void countBytes(std::size_t payload_bytes);

  SessionWriter session_;
  std::map<ChannelKey, ChannelId> channels_;
  ChannelIds ids_;
  ChannelIds restated_ids_;
  PieceCounts counts_;
  bool begun_ = false;
  std::uint32_t said_again_ = 0;
  std::uint64_t chunk_start_ = 0;    ///< bytes written when the open chunk was begun
  std::uint64_t pending_bytes_ = 0;  ///< of records in the open chunk
  std::uint64_t index_bytes_ = 0;    ///< of indexes that are still to be written
};

}  // namespace rocinante
