#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/foreign/session/message_sink.h"
#include "core/mcap/writer.h"
#include "core/report/account.h"

namespace rocinante {

/// An MCAP file for other tools: channels with schemas, made when their first message is written.
/// Messages are to come in order of time. Chunks are zstd.
class ExportedMcap final : public MessageSink {
 public:
  /// `profile` is MCAP's: empty or "ros2".
  static Result<ExportedMcap> start(std::unique_ptr<ByteSink> sink, std::string profile);

  static constexpr std::size_t kMostChannels = 0xFFFF;

  /// Of channels beyond kMostChannels nothing is written: see addLeftOut().
  Status write(std::string_view topic, const MessageSchema& schema, LogTime time, ByteView message,
               const std::map<std::string, std::string>& metadata) override;
  using MessageSink::write;
  /// A message without schema, as another log had it.
  Status writeRaw(const std::string& topic, const std::string& encoding,
                  const std::map<std::string, std::string>& metadata, const mcap::Message& message);
  /// The messages that were not written.
  void addLeftOut(Account& account) const;
  Status writeAttachment(const mcap::Attachment& attachment);
  /// Whole on the disk. No call may follow.
  Status finish();

  /// By topic: how many messages.
  struct Topic {
    std::string schema;  ///< its name; of a raw channel its encoding
    std::uint64_t messages = 0;
  };
  const std::map<std::string, Topic, std::less<>>& topics() const { return topics_; }

 private:
  explicit ExportedMcap(mcap::Writer writer) : writer_(std::move(writer)) {}

  struct ChannelEntry {
    std::uint16_t id = 0;
    std::uint32_t sequence = 0;
    Topic* topic = nullptr;
  };
  /// Null, and counted, beyond kMostChannels.
  ChannelEntry* addChannel(const std::string& key, mcap::Channel channel, const std::string& shown);

  mcap::Writer writer_;
  std::map<std::string, ChannelEntry, std::less<>> channels_;
  std::map<std::string, std::uint16_t, std::less<>> schemas_;
  std::map<std::string, Topic, std::less<>> topics_;
  std::uint64_t beyond_ = 0;
  std::string first_beyond_;  ///< its topic
};

}  // namespace rocinante
