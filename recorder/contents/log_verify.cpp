#include "recorder/contents/log_verify.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/log/log_profile.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kShown = 10;
constexpr std::uint64_t kMessagesPerProgress = 1000;

/// Whether the channel holds datagrams as they were received, also those that restate for others.
/// The opening keyframe of a merged log is a tool's.
bool isDatagram(const LogChannel& channel) {
  return channel.received() && channel.topic != profile::kRestatedKeyframeTopic;
}

WallTime wallTimeOf(LogTime time) { return WallTime(time.time_since_epoch()); }

}  // namespace

Result<VerifyReport> verifyLog(LogReader& log, TrustJudge& judge,
                               const std::function<bool(double)>& progress) {
  VerifyReport report;
  report.log = log.name();
  report.origin = log.summary().origin;
  const std::uint64_t expected = std::max<std::uint64_t>(log.summary().messages, 1);
  while (true) {
    const Result<std::optional<LogMessage>> message = log.next();
    if (!message) return message.error();
    if (!*message) break;
    const LogMessage& each = **message;
    if (!isDatagram(*each.channel)) continue;
    if (++report.messages % kMessagesPerProgress == 0 &&
        !progress(static_cast<double>(report.messages) / static_cast<double>(expected))) {
      report.stopped = true;
      break;
    }
    const auto reason = judge.judge(each.payload, wallTimeOf(each.log_time));
    if (!reason) continue;
    report.untrusted.add(*reason);
    if (report.listed.size() < VerifyReport::kListed) {
      report.listed.push_back({each.log_time, each.channel->topic, each.sequence, *reason});
    }
  }
  report.damage = log.damage();
  return report;
}

std::string verifyText(const VerifyReport& report) {
  std::string text = fmt::format("{}: {}, {} trusted", plainText(report.log),
                                 countText(report.messages, "datagram"), report.trusted());
  if (report.untrusted.total() > 0) text += ", not trusted: " + report.untrusted.text();
  if (report.stopped) text += "; stopped before the end";
  text += '\n';
  for (std::size_t i = 0; i < std::min(kShown, report.listed.size()); ++i) {
    const UntrustedMessage& each = report.listed[i];
    text += fmt::format("  {} s  {} {}: {}\n", secondsText(each.time - report.origin),
                        plainText(each.topic), each.sequence, nameOf(each.reason));
  }
  if (report.untrusted.total() > kShown) {
    text += fmt::format("  and {} more\n", report.untrusted.total() - kShown);
  }
  for (const DamageSpan& each : report.damage) {
    text += fmt::format("  not judged: {} (byte {})\n", each.cause, each.from);
  }
  return text;
}

std::string verifyJson(const VerifyReport& report) {
  Json json;
  json["format"] = 1;
  json["log"] = report.log;
  json["whole"] = report.isWhole();
  json["datagrams"] = report.messages;
  json["trusted"] = report.trusted();
  for (std::size_t i = 0; i < kUntrustedReasons; ++i) {
    json["untrusted"][std::string(nameOf(static_cast<Untrusted>(i)))] =
        report.untrusted.by_reason[i];
  }
  json["stopped"] = report.stopped;
  json["listed"] = Json::array();
  for (const UntrustedMessage& each : report.listed) {
    json["listed"].push_back({{"t_s", secondsOf(each.time - report.origin)},
                              {"log_time_ns", nanosecondsOf(each.time)},
                              {"topic", each.topic},
                              {"sequence", each.sequence},
                              {"reason", std::string(nameOf(each.reason))}});
  }
  json["damage"] = Json::array();
  for (const DamageSpan& each : report.damage) {
    json["damage"].push_back({{"cause", each.cause}, {"byte", each.from}});
  }
  // A file name need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rocinante
