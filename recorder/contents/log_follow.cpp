#include "recorder/contents/log_follow.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/pattern.h"

namespace rocinante {
namespace {

constexpr std::size_t kFlushBytes = 1U << 16U;

bool isChosen(const LogChannel& channel, const std::vector<std::string>& patterns) {
  if (patterns.empty()) return channel.captured();
  return anyPatternMatches(patterns, channel.topic);
}

/// The damage of a log that has not been told yet: while the log grows, its list is made anew, and
/// what concerns all of it grows too.
class UnreportedDamage {
 public:
  explicit UnreportedDamage(const LogReader& log) : log_(log) {}

  void tell(const std::function<void(const DamageSpan&)>& damaged) {
    for (const DamageSpan& span : log_.damage()) {
      const bool is_new = reported_.emplace(span.from, span.cause).second;
      if (is_new && damaged) damaged(span);
    }
  }

 private:
  const LogReader& log_;
  std::set<std::pair<std::uint64_t, std::string>> reported_;
};

}  // namespace

Result<std::uint64_t> followLog(LogReader& log, const FollowOptions& options,
                                const FollowEvents& events, const TextSink& out) {
  MessagePrinter printer(options.format, {}, LogTime{});
  UnreportedDamage damage(log);
  if (!options.from_start) {
    log.skipInFile();
    damage.tell({});
  }
  std::map<ChannelId, bool> chosen;
  bool origin_known = false;
  std::string piece;
  printer.header(piece);
  std::uint64_t count = 0;
  while (true) {
    const Result<std::optional<LogMessage>> message = log.nextInFile();
    if (!message) return message.error();
    if (*message) {
      const LogChannel& channel = *(*message)->channel;
      const auto [known, is_new] = chosen.try_emplace(channel.id, false);
      if (is_new) {
        known->second = isChosen(channel, options.channels);
        if (known->second) printer.makeRoomFor(channel);
      }
      if (!std::exchange(origin_known, true)) printer.setOrigin(log.summary().origin);
      if (known->second) {
        printer.message(**message, piece);
        ++count;
      }
      if (piece.size() < kFlushBytes) continue;
    }
    if (Status written = out(piece); !written) return written.error();
    piece.clear();
    damage.tell(events.damaged);
    if (*message) continue;
    if (log.ended() || !events.wait()) return count;
    if (const Result<bool> grown = log.refresh(); !grown) return grown.error();
  }
}

}  // namespace rocinante
