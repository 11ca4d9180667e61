#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/cli/text_table.h"
#include "core/log/log_profile.h"
#include "recorder/contents/log_info.h"
#include "recorder/contents/message_printer.h"

namespace rocinante {
namespace {

using cli::counted;
using cli::grouped;

constexpr std::size_t kShownEvents = 20;

std::string shownMetadata(const LogChannel& channel, const char* key) {
  const auto found = channel.metadata.find(key);
  return found == channel.metadata.end() || found->second.empty() ? "-" : plainText(found->second);
}

/// The longest time without a message, between the first and the last.
std::string gapText(const ChannelInfo& info) {
  if (info.messages < 2) return "-";
  return fmt::format("{:.3f}", static_cast<double>(info.longest_gap.count()) / 1e9);
}

void addChannels(std::string& out, const LogInfo& info, std::size_t columns) {
  cli::TextTable table;
  table.is_number = {false, false, false, false, true, true, true, false};
  table.expendable = {3, 1};
  table.whole = {7};
  table.rows = {
      {"channel", "encoding", "source", "sender", "messages", "rate/s", "silent/s", "activity"}};
  const auto add = [&](const ChannelInfo& channel) {
    table.rows.push_back({plainText(channel.channel.topic), plainText(channel.channel.encoding),
                          shownMetadata(channel.channel, "source"),
                          shownMetadata(channel.channel, "remote"), grouped(channel.messages),
                          fmt::format("{:.1f}", channel.rateHz()), gapText(channel),
                          activityStrip(channel.activity)});
  };
  std::ranges::for_each(info.channels, add);
  std::ranges::for_each(info.own_channels, add);
  if (table.rows.size() == 1) return;
  out += '\n' + table.text(columns);
}

void addEvents(std::string& out, const LogInfo& info) {
  if (info.events == 0) return;
  out += fmt::format("\n  events\n");
  const std::size_t shown = std::min(info.first_events.size(), kShownEvents);
  for (const Event& event : std::span(info.first_events).first(shown)) {
    const std::string who = event.source.empty() ? "(mark)" : plainText(event.source);
    out += fmt::format("  {:>14} s  {}: {}\n", secondsText(event.time - info.summary.origin, 3),
                       who, plainText(event.text));
  }
  if (info.events > shown) out += fmt::format("  and {} more\n", grouped(info.events - shown));
}

void addLosses(std::string& out, const LogInfo& info) {
  const LossCounts& losses = info.losses;
  if (losses == LossCounts{}) {
    out += "  losses      none recorded";
  } else {
    out += fmt::format("  losses      kernel {}, queue {}, disk {}, truncated {} in {}",
                       grouped(losses.kernel), grouped(losses.queue), grouped(losses.disk),
                       grouped(losses.truncated), counted(info.loss_spans.size(), "span"));
  }
  if (info.source_gap > 0) {
    out += fmt::format("; the sources' sequence numbers miss {}", grouped(info.source_gap));
  }
  out += "\n";
}

std::string completeText(const LogSummary& summary) {
  const bool is_ours = summary.profile == profile::kName;
  if (summary.complete && is_ours) {
    return fmt::format("yes ({})", plainText(summary.end_reason));
  }
  const std::string writer = summary.library.empty() ? "its writer" : plainText(summary.library);
  if (summary.complete) return fmt::format("yes (closed by {})", writer);
  if (!summary.closed && is_ours) return "no: its recorder did not close it";
  if (!summary.closed) return fmt::format("no: it was not closed by {}", writer);
  return "no: it was closed, but rocinante.end is missing";
}

void addDamage(std::string& out, const LogInfo& info) {
  if (info.damage.empty()) return;
  out += "\n  damage\n";
  for (const DamageSpan& span : info.damage) {
    out += fmt::format("  bytes {} to {}: {}", span.from, span.to, plainText(span.cause));
    if (!span.messages_lost) {
      out += "; messages lost: unknown";
    } else if (*span.messages_lost > 0) {
      out += "; lost: " + counted(*span.messages_lost, "message");
    }
    out += "\n";
  }
}

/// Of ROS, as its recorders or converters wrote it.
bool isBag(const LogInfo& info) {
  return info.summary.profile != profile::kName &&
         std::ranges::any_of(info.channels, [](const auto& each) {
           return each.channel.encoding == "cdr" || each.channel.encoding == "ros1";
         });
}

std::string factsText(const LogInfo& info) {
  const LogSummary& summary = info.summary;
  const Nanoseconds duration = summary.end - summary.start;
  std::string out;
  if (!summary.session_id.empty()) {
    out += fmt::format("  session     {}\n", plainText(summary.session_id));
  }
  if (info.messages > 0) {
    out +=
        fmt::format("  origin      {}\n", rfc3339Text(WallTime(summary.origin.time_since_epoch())));
    out += fmt::format("  time        {} s to {} s, {} s long\n",
                       secondsText(summary.start - summary.origin, 3),
                       secondsText(summary.end - summary.origin, 3), secondsText(duration, 3));
  }
  out += fmt::format("  messages    {} on {}", grouped(info.messages),
                     counted(info.channels.size(), "channel"));
  const std::uint64_t understood = info.packets + info.decoded;
  if (understood < info.messages) {
    out += fmt::format("; {} could be decoded", grouped(understood));
  }
  out += "\n";
  if (understood == 0 && isBag(info)) {
    out +=
        "              `rocinante log import` makes packets of them; check, render and view take\n"
        "              the bag as it is\n";
  }
  if (info.events > 0) {
    out += fmt::format("  events      {}", grouped(info.events));
    if (info.marks > 0) out += fmt::format(", {} of them marks", grouped(info.marks));
    out += "\n";
  }
  if (info.keyframes > 0) out += fmt::format("  keyframes   {}\n", grouped(info.keyframes));
  out += fmt::format("  stored      {} in {}", sizeText(info.storage.file_bytes),
                     counted(info.storage.chunks, "chunk"));
  if (!info.storage.compressions.empty()) {
    out += fmt::format(", {}", fmt::join(info.storage.compressions, " and "));
  }
  if (info.storage.stored_bytes > 0 && info.storage.expanded_bytes > info.storage.stored_bytes) {
    out +=
        fmt::format(" ({:.1f} times smaller)", static_cast<double>(info.storage.expanded_bytes) /
                                                   static_cast<double>(info.storage.stored_bytes));
  }
  out += "\n";
  if (!info.attachments.empty()) {
    std::uint64_t bytes = 0;
    for (const LogAttachment& each : info.attachments) bytes += each.data_bytes;
    out += fmt::format("  attached    {}, {} of the {}\n", counted(info.attachments.size(), "file"),
                       sizeText(bytes), sizeText(info.storage.file_bytes));
  }
  if (!info.account.empty()) {
    out += fmt::format("  account     {}\n", plainText(info.account.sentence()));
  }
  return out;
}

}  // namespace

std::string logInfoText(const LogInfo& info, std::size_t columns) {
  constexpr std::size_t kValues = 14, kEventTexts = 20;  // where these columns begin
  std::string verdict = "  complete    " + completeText(info.summary) + "\n";
  addLosses(verdict, info);
  std::string damage;
  addDamage(damage, info);
  const bool is_sound = info.summary.complete && damage.empty() && info.losses == LossCounts{};
  std::string out = factsText(info) + verdict;
  // What a person must know is not below a screen of channels and events.
  if (columns > 0 && !is_sound) out = verdict + factsText(info);
  out += "  content     sha256 " + info.content_sha256 + "\n";
  if (!info.decoded_sha256.empty()) {
    out += "  decoded     sha256 " + info.decoded_sha256 + "\n";
  }
  out += "  stream      sha256 " + info.stream_sha256 + "\n";
  out = plainText(info.name) + "\n" + cli::wrapped(out, columns, kValues);
  if (columns > 0) out += cli::wrapped(damage, columns, 4);
  addChannels(out, info, columns);
  std::string events;
  addEvents(events, info);
  out += cli::wrapped(events, columns, kEventTexts);
  return columns > 0 ? out : out + damage;
}

}  // namespace rocinante
