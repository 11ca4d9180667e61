#include "recorder/contents/log_follow.h"

#include <algorithm>
#include <map>

#include "core/base/pattern.h"

namespace rocinante {
namespace {

constexpr std::size_t kFlushBytes = 1U << 16U;

bool isChosen(const LogChannel& channel, const std::vector<std::string>& patterns) {
  if (patterns.empty()) return channel.captured();
  return anyPatternMatches(patterns, channel.topic);
}

}  // namespace

Result<std::uint64_t> followLog(LogFollower& follower, const FollowOptions& options,
                                const FollowEvents& events, const TextSink& out) {
  MessagePrinter printer(options.format, {}, LogTime{});
  std::map<ChannelId, bool> chosen;
  bool origin_known = false;
  std::string piece;
  if (options.with_header) printer.header(piece);
  std::uint64_t count = 0;
  while (true) {
    const Result<std::optional<LogMessage>> message = follower.poll();
    const bool idle = message && !*message;
    if (!idle && message) {
      const LogChannel& channel = *(*message)->channel;
      const auto [known, is_new] = chosen.try_emplace(channel.id, false);
      if (is_new) {
        known->second = isChosen(channel, options.channels);
        if (known->second) printer.makeRoomFor(channel);
      }
      if (!origin_known) {
        origin_known = true;
        printer.setOrigin(follower.origin().value_or((*message)->log_time));
      }
      if (known->second) {
        printer.message(**message, piece);
        ++count;
      }
    }
    if (idle || !message || piece.size() >= kFlushBytes) {
      if (Status written = out(piece); !written) return written.error();
      piece.clear();
      for (const DamageSpan& span : follower.takeDamage()) events.damaged(span);
    }
    if (!message) return message.error();
    if (idle && (follower.ended() || !events.wait())) return count;
  }
}

}  // namespace rocinante
