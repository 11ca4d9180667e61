#include "core/log/log_follower.h"

#include <fmt/format.h>

#include <limits>
#include <map>

#include "core/log/followed_records.h"
#include "core/log/log_index.h"
#include "core/log/log_profile.h"
#include "core/log/other_format.h"
#include "core/mcap/parse_record.h"

namespace rocinante {

using mcap::Opcode;

struct LogFollower::Impl {
  explicit Impl(std::unique_ptr<FollowedFile> file) : records(std::move(file)) {}

  FollowedRecords records;
  std::optional<Error> failure;
  std::optional<LogTime> origin;
  std::map<ChannelId, LogChannel> channels;

  Result<std::optional<LogMessage>> poll() {
    if (Status seen = records.look(); !seen) return seen.error();
    while (true) {
      const Result<std::optional<FollowedRecord>> next = records.step();
      if (!next) return next.error();
      if (!*next) return std::optional<LogMessage>();
      const mcap::Record& record = (*next)->record;
      if (record.opcode == Opcode::channel) {
        takeChannel(record);
      } else if (record.opcode == Opcode::metadata) {
        takeMetadata(record);
      } else if (record.opcode == Opcode::message) {
        if (std::optional<LogMessage> message = takeMessage(**next)) return message;
      }
    }
  }

  std::optional<LogMessage> takeMessage(const FollowedRecord& found) {
    mcap::Message message;
    constexpr auto kLast = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (!mcap::parse(found.record.content, message) || message.log_time > kLast) {
      records.damaged("a message is malformed", 1);
      return std::nullopt;
    }
    const auto channel = channels.find(message.channel_id);
    if (channel == channels.end()) {
      records.damaged(
          fmt::format("a message on channel {}, which was never defined", message.channel_id), 1);
      return std::nullopt;
    }
    if (found.quiet) return std::nullopt;
    LogMessage out;
    out.channel = &channel->second;
    out.sequence = message.sequence;
    out.log_time = LogTime(Nanoseconds(static_cast<std::int64_t>(message.log_time)));
    out.publish_time_ns = static_cast<std::int64_t>(message.publish_time);
    out.file_offset = (found.span << 32U) | found.record.offset;
    out.payload = message.data;
    return out;
  }

  void takeChannel(const mcap::Record& record) {
    mcap::Channel channel;
    if (!mcap::parse(record.content, channel)) return records.damaged("a channel is malformed");
    if (addChannel(channels, channel)) return;
    records.damaged(fmt::format("channel {} is defined again as another", channel.id));
  }

  void takeMetadata(const mcap::Record& record) {
    mcap::Metadata metadata;
    if (!mcap::parse(record.content, metadata)) {
      return records.damaged("a metadata record is malformed", 0);
    }
    if (origin || metadata.name != profile::kSession) return;
    const auto format = metadata.metadata.find(std::string(profile::kFormatKey));
    const std::string said = format == metadata.metadata.end() ? std::string() : format->second;
    if (said != profile::kFormat) {
      records.damaged(profile::otherFormatText(said), 0);
      noteOtherFormat(said, records.file().name());
    }
    const auto entry = metadata.metadata.find(std::string(profile::kOriginKey));
    if (entry != metadata.metadata.end()) origin = profile::parseOrigin(entry->second);
  }
};

Result<LogFollower> LogFollower::open(const std::filesystem::path& path, From from) {
  Result<std::unique_ptr<FollowedFile>> file = followFile(path);
  if (!file) return file.error();
  return openOn(std::move(*file), from);
}

Result<LogFollower> LogFollower::openOn(std::unique_ptr<FollowedFile> file, From from) {
  auto impl = std::make_unique<Impl>(std::move(file));
  if (Status seen = impl->records.look(); !seen) return seen.error();
  if (from == From::now) impl->records.beginAtEnd();
  const Result<bool> begun = impl->records.readMagic();
  if (!begun) return begun.error();
  return LogFollower(std::move(impl));
}

LogFollower::LogFollower(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LogFollower::~LogFollower() = default;
LogFollower::LogFollower(LogFollower&&) noexcept = default;
LogFollower& LogFollower::operator=(LogFollower&&) noexcept = default;

Result<std::optional<LogMessage>> LogFollower::poll() {
  if (impl_->failure) return *impl_->failure;
  Result<std::optional<LogMessage>> message = impl_->poll();
  if (!message) impl_->failure = message.error();
  return message;
}

bool LogFollower::ended() const { return impl_->records.ended(); }
std::optional<LogTime> LogFollower::origin() const { return impl_->origin; }
std::vector<DamageSpan> LogFollower::takeDamage() { return impl_->records.takeDamage(); }
const std::string& LogFollower::name() const { return impl_->records.file().name(); }

}  // namespace rocinante
