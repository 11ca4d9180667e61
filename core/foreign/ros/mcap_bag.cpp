#include <algorithm>

#include "core/foreign/ros/bag_reader.h"
#include "core/foreign/ros/expanded_messages.h"
#include "core/log/damage_text.h"
#include "core/log/log_profile.h"
#include "core/log/log_reader.h"

namespace rocinante::ros {
namespace {

/// MCAP of ROS 2, and of ROS 1 as converters make it. Reads through LogReader: in order of time,
/// over every damage that it can pass.
class McapBag final : public BagReader {
 public:
  explicit McapBag(LogReader reader) : reader_(std::move(reader)) {
    for (const LogChannel& channel : reader_.channels()) {
      if (by_id_.size() <= channel.id) by_id_.resize(channel.id + 1U);
      by_id_[channel.id] = topics_.size();
      BagTopic topic;
      topic.name = channel.topic;
      topic.type = channel.schema ? channel.schema->name : std::string();
      topic.encoding = channel.encoding;
      topic.metadata = channel.metadata;
      topic.schema = channel.schema;
      topics_.push_back(std::move(topic));
    }
  }

  std::string_view kind() const override {
    return reader_.summary().profile == "ros1"   ? "ros1-mcap"
           : reader_.summary().profile == "ros2" ? "ros2-mcap"
                                                 : "mcap";
  }
  const std::vector<BagTopic>& topics() const override { return topics_; }

  Result<std::optional<BagMessage>> next() override {
    const Result<std::optional<LogMessage>> message = reader_.next();
    if (!message) return message.error();
    if (!*message) return std::optional<BagMessage>();
    const LogMessage& found = **message;
    last_ = found.log_time;
    return std::optional(BagMessage{by_id_[found.channel->id], found.sequence, found.log_time,
                                    found.publish_time_ns, found.payload});
  }

  Result<std::optional<Bytes>> lastOf(std::size_t topic) override {
    const ChannelId id = reader_.channels()[topic].id;
    const Result<std::optional<LogMessage>> message = reader_.lastOf(id, kLastLogTime);
    if (!message) return message.error();
    if (!*message) return std::optional<Bytes>();
    return std::optional(Bytes((*message)->payload.begin(), (*message)->payload.end()));
  }

  double part() const override {
    const LogSummary& summary = reader_.summary();
    const double whole = secondsOf(summary.end - summary.start);
    return whole <= 0 ? 0 : std::clamp(secondsOf(last_ - summary.start) / whole, 0.0, 1.0);
  }

  std::vector<std::string> damage() const override {
    std::vector<std::string> sentences = unreadable_;
    for (const DamageSpan& span : reader_.damage()) {
      std::string sentence = span.cause;
      if (span.messages_lost && *span.messages_lost > 0) {
        sentence += ": " + std::to_string(*span.messages_lost) + " messages lost";
      }
      sentences.push_back(damageText(sentence, reader_.name(), span.from));
    }
    return sentences;
  }

  Status copyExtras(LogWriter& log) override {
    for (const LogMetadata& record : reader_.metadata()) {
      if (record.name.starts_with("rocinante.")) continue;
      if (Status written = log.writeMetadata(record); !written) return written;
    }
    for (std::size_t i = 0; i < reader_.attachments().size(); ++i) {
      const LogAttachment& attachment = reader_.attachments()[i];
      const Result<Bytes> data = reader_.readAttachment(i);
      if (!data) {
        unreadable_.push_back(data.error().text());
        continue;
      }
      if (Status written = log.writeAttachment(attachment.name, attachment.media_type,
                                               attachment.log_time, *data);
          !written) {
        return written;
      }
    }
    return {};
  }

 private:
  LogReader reader_;
  std::vector<BagTopic> topics_;
  std::vector<std::size_t> by_id_;
  LogTime last_{};
  std::vector<std::string> unreadable_;  ///< attachments
};

Result<std::unique_ptr<BagReader>> bagOf(Result<LogReader> reader) {
  if (!reader) return reader.error();
  if (reader->summary().profile == profile::kName) {
    return Error{ErrorKind::bad_argument, "it is a log already; `rocinante log merge` joins logs",
                 reader->name()};
  }
  const std::uint64_t file_bytes = reader->storage().file_bytes;
  return withExpandedMessages(std::make_unique<McapBag>(std::move(*reader)), file_bytes);
}

}  // namespace

Result<std::unique_ptr<BagReader>> openMcapBag(const std::filesystem::path& path) {
  return bagOf(LogReader::open(path));
}

Result<std::unique_ptr<BagReader>> openMcapBytes(ByteView bytes, std::string name) {
  return bagOf(LogReader::openBytes(bytes, std::move(name)));
}

}  // namespace rocinante::ros
