#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/mcap/byte_sink.h"
#include "core/mcap/growing_file.h"
#include "core/mcap/open_chunk.h"
#include "core/mcap/records.h"
#include "core/mcap/summary.h"
#include "core/mcap/writer_options.h"

namespace rocinante::mcap {

/// Writes any MCAP file; LogWriter is the profile on top of it. Schemas and channels are declared
/// once and written where they are first used, again in every chunk, so that each chunk can be read
/// alone. Disk space is reserved for the file's end, so that a disk that fills up still leaves a
/// whole file; where that is impossible, each record is in the file whole or not at all, and
/// finish() can still be tried. Starts no threads.
class Writer {
 public:
  /// Writes the magic and the header.
  static Result<Writer> start(std::unique_ptr<ByteSink> sink, const WriterOptions& options,
                              const Header& header);

  /// Ids must be new.
  void addSchema(Schema schema);
  void addChannel(Channel channel);

  /// The channel must have been added. Fails when this message, or the chunk that it filled, could
  /// not be written: lost() counts the messages that are not in the file.
  Status write(const Message& message);
  /// Both close the chunk if it is begun in the file.
  Status writeAttachment(const Attachment& attachment);
  Status writeMetadata(const Metadata& metadata);

  /// Writes the messages of the open chunk to the file and leaves the chunk open there; closes it
  /// if the file can only grow. When it fails, the chunk is closed with the messages that are in
  /// the file.
  Status flush();
  /// See ByteSink::check().
  Status check() { return file_.check(); }
  /// Closes the open chunk, if it holds anything.
  Status closeChunk();
  /// Whether messages wait in memory.
  bool unflushed() const { return chunk_.unflushed(); }

  /// Closes the chunk, writes the summary, closes the file. When the disk refuses, the file keeps
  /// its whole records. No call may follow.
  Status finish();

  /// The bytes in the file.
  std::uint64_t bytesWritten() const { return file_.size(); }
  /// Per channel id: messages given to write() that the disk refused.
  const std::map<std::uint16_t, std::uint64_t>& lost() const { return lost_; }

 private:
  struct ChannelState {
    Bytes record;
    std::uint16_t schema_id = 0;
    std::uint64_t messages = 0;  ///< outside chunks
    OpenChunk::Part part;        ///< outside chunks only `declared`, in the file
  };
  struct SchemaState {
    Bytes record;
    std::uint16_t id = 0;
    bool declared = false;
  };

  Writer(std::unique_ptr<ByteSink> sink, const WriterOptions& options);

  Status writeLoose(ChannelState& channel, const Message& message);
  void declare(ChannelState& channel, Bytes& out);
  void undeclareSchemas();
  /// The disk refused: the records that are not in the file are lost.
  void refuse();
  /// Releases the room that was kept for writes after a refusal.
  void releaseRoom();
  void keepChunk();
  std::uint64_t tailBytes() const;

  GrowingFile file_;
  WriterOptions options_;
  std::vector<std::unique_ptr<ChannelState>> channel_by_id_;
  std::vector<SchemaState> schemas_;
  OpenChunk chunk_;
  bool refused_ = false;
  Bytes scratch_;
  Summary summary_;
  std::map<std::uint16_t, std::uint64_t> lost_;
};

}  // namespace rocinante::mcap
