#include "recorder/capture/record_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/foreign/decode/decode_account.h"
#include "core/net/datagram_source.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

using std::chrono::seconds;

constexpr Nanoseconds kDiskSpan = seconds(10);

double perSecond(std::uint64_t now, std::uint64_t before, Nanoseconds span) {
  return span > Nanoseconds(0) ? static_cast<double>(now - std::min(now, before)) / secondsOf(span)
                               : 0;
}

/// "43 s", "12 min", "5.2 h", "12 days", "over a year".
std::string roughly(double span_s) {
  if (span_s < 120) return fmt::format("{:.0f} s", span_s);
  if (span_s < 7'200) return fmt::format("{:.0f} min", span_s / 60);
  if (span_s < 172'800) return fmt::format("{:.1f} h", span_s / 3'600);
  if (span_s < 365 * 86'400.0) return fmt::format("{:.0f} days", span_s / 86'400);
  return "over a year";
}

// The summary names a delay of more than this: less is how programs start on a busy machine.
constexpr Nanoseconds kLate = std::chrono::seconds(1);

std::string endpointText(const ListenedEndpoint& listened) {
  return boundText(listened.endpoint, listened.bound);
}

std::string filesText(const RecordSummary& summary) {
  const std::vector<PieceFacts>& pieces = summary.files.pieces;
  std::string text;
  if (pieces.empty()) {
    text = "no file";
  } else if (pieces.size() == 1) {
    text = fmt::format("{} ({})", summary.log.string(), sizeText(summary.log_bytes));
  } else {
    text = fmt::format("{} pieces, {} to {} ({})", pieces.size(), pieces.front().file.path.string(),
                       pieces.back().file.path.filename().string(), sizeText(summary.log_bytes));
  }
  if (const DeletedPieces& deleted = summary.files.deleted; deleted.count > 0) {
    text += fmt::format("; deleted {} of {} ({})", countText(deleted.count, "piece"),
                        countText(deleted.packets, "packet"), sizeText(deleted.bytes));
  }
  if (summary.packets_before > 0) {
    text +=
        fmt::format("; {} before the start condition", countText(summary.packets_before, "packet"));
  }
  return text;
}

Json pieceJson(const PieceFacts& piece) {
  Json object;
  object["log"] = piece.file.path.string();
  object["packets"] = piece.packets;
  object["bytes"] = piece.bytes;
  if (piece.start) {
    object["start"] = rfc3339Text(WallTime(piece.start->time_since_epoch()));
    object["end"] = rfc3339Text(WallTime(piece.end->time_since_epoch()));
  }
  if (piece.refused > 0) object["refused"] = piece.refused;
  if (piece.trouble) object["trouble"] = *piece.trouble;
  if (piece.triggered) {
    object["triggered"] = rfc3339Text(WallTime(piece.triggered->time_since_epoch()));
    object["why"] = piece.why;
    object["triggers"] = piece.triggers;
    object["cut_short"] = piece.cut_short;
  }
  return object;
}

void addCounts(Json& object, const LossCounts& counts) {
  object["kernel"] = counts.kernel;
  object["queue"] = counts.queue;
  object["disk"] = counts.disk;
  object["truncated"] = counts.truncated;
}

Json untrustedJson(const UntrustedCounts& counts) {
  Json json;
  for (std::size_t i = 0; i < kUntrustedReasons; ++i) {
    json[std::string(nameOf(static_cast<Untrusted>(i)))] = counts.by_reason[i];
  }
  return json;
}

Json secondsOrNull(std::optional<Nanoseconds> span) {
  return span ? Json(secondsOf(*span)) : Json();
}

void addInput(Json& object, const InputAccount& input) {
  object["refused"] = input.counts.refused;
  object["strangers"] = input.counts.strangers;
  object["requests"] = input.counts.requests;
  object["echoes"] = input.counts.echoes;
  object["incomplete"] = input.counts.incomplete;
  object["malformed"] = input.counts.malformed;
  object["left_out"] = leftOutJson(input.left_out);
  if (input.counts.untrusted) object["untrusted"] = untrustedJson(*input.counts.untrusted);
  if (const auto& subscription = input.subscription) {
    Json& outcome = object["subscription"];
    outcome["accepted_after_s"] = secondsOrNull(subscription->accepted_after);
    outcome["trouble"] = orNull(subscription->trouble);
  }
  object["receive_buffer"] = {{"granted_bytes", input.buffer_granted_bytes},
                              {"needed_bytes", input.buffer_needed_bytes}};
}

/// Nothing arrived there at all, and it is not said otherwise.
bool isSilent(const EndpointAccount& account, const InputAccount& input) {
  InputCounts others = input.counts;
  if (others.untrusted && others.untrusted->total() == 0) others.untrusted.reset();
  const bool is_reported = input.subscription && !input.subscription->accepted_after;
  return account.recorded == 0 && account.losses == LossCounts{} && others == InputCounts{} &&
         input.left_out.empty() && !is_reported;
}

std::string silenceText(const RecordSummary& summary) {
  // Whose the datagrams before a start condition were is not counted.
  if (summary.packets_before > 0) return {};
  std::vector<std::string> silent;
  for (std::size_t i = 0; i < std::min(summary.endpoints.size(), summary.inputs.size()); ++i) {
    if (isSilent(summary.endpoints[i], summary.inputs[i])) {
      silent.push_back(summary.inputs[i].endpoint);
    }
  }
  if (silent.empty()) return {};
  return fmt::format("\nnothing was heard at {} (rocinante spy looks for the reason)",
                     fmt::join(silent, ", "));
}

/// One line each for datagrams that were not recorded without being lost, and for the tees.
std::string inputText(const RecordSummary& summary) {
  std::string text;
  for (const InputAccount& each : summary.inputs) {
    const auto say = [&](std::uint64_t count, std::string_view what) {
      if (count > 0)
        text += fmt::format("\n{} at {}", fmt::format(fmt::runtime(what), count), each.endpoint);
    };
    say(each.counts.refused, "{} not recorded: sender not in --allow");
    say(each.counts.strangers, "{} not recorded: not from the relay");
    say(each.counts.requests, "{} not recorded: requests that are for a relay");
    const UntrustedCounts untrusted = each.counts.untrusted.value_or(UntrustedCounts{});
    say(untrusted.total(), "{} not recorded: not trusted (" + untrusted.text() + ")");
    say(each.counts.echoes, "{} not recorded: sent by --tee itself");
    if (each.subscription && each.subscription->accepted_after.value_or(kLate) > kLate) {
      text += fmt::format("\n{}: subscribed after {:.1f} s", each.endpoint,
                          secondsOf(*each.subscription->accepted_after));
    }
    if (!each.left_out.empty()) {
      text += fmt::format("\n{}: {}", each.endpoint, accountSentence(each.left_out));
    }
  }
  for (const Tee::Account& each : summary.tees) {
    text +=
        fmt::format("\nforwarded to {}: {}, {} dropped", each.to.text(), each.sent, each.dropped);
    if (each.looped > 0) text += fmt::format(", {} came back", each.looped);
    if (each.trouble) text += fmt::format(" ({})", each.trouble->what);
  }
  return text;
}

}  // namespace

/// The latest progress up to `elapsed`, or else the first.
const RecordProgress& RecordStatus::before(Nanoseconds elapsed) const {
  const auto later = std::ranges::find_if(
      reported_, [&](const RecordProgress& each) { return each.elapsed > elapsed; });
  return later == reported_.begin() ? *later : *std::prev(later);
}

std::string RecordStatus::text(const RecordProgress& now) {
  if (reported_.empty()) reported_.emplace_back();
  const RecordProgress& second_ago = before(now.elapsed - seconds(1));
  const RecordProgress& long_ago = reported_.front();
  const double rate = perSecond(now.packets, second_ago.packets, now.elapsed - second_ago.elapsed);
  const double disk_rate =
      perSecond(now.log_bytes, long_ago.log_bytes, now.elapsed - long_ago.elapsed);
  std::string text =
      fmt::format("{:.1f} s   {:.0f} packets/s   {} packets   {} lost   {}", secondsOf(now.elapsed),
                  rate, now.packets, now.lost, sizeText(now.log_bytes));
  if (!now.started) text += "   waiting to start";
  if (now.held > Nanoseconds(0)) text += fmt::format("   holding {:.1f} s", secondsOf(now.held));
  text += fmt::format("   queue {:.0f} %", 100 * now.queue_fill);
  if (now.disk_free_bytes) {
    text += fmt::format("   {} free", sizeText(*now.disk_free_bytes));
    if (disk_rate > 0) {
      text += ", for " + roughly(static_cast<double>(*now.disk_free_bytes) / disk_rate);
    }
  }
  reported_.push_back(now);
  while (now.elapsed - reported_.front().elapsed > kDiskSpan) reported_.pop_front();
  return text;
}

std::string summaryText(const RecordSummary& summary) {
  std::string text =
      fmt::format("recorded {} on {} in {:.1f} s", countText(summary.packets, "packet"),
                  countText(summary.channels, "channel"), secondsOf(summary.duration));
  if (summary.first_after.value_or(kLate) > kLate) {
    text += fmt::format(", the first after {:.1f} s", secondsOf(*summary.first_after));
  }
  text += ": " + filesText(summary) + silenceText(summary);
  for (const EndpointAccount& each : summary.endpoints) {
    const LossCounts& lost = each.losses;
    if (lost == LossCounts{}) continue;
    text += fmt::format(
        "\nlost at {}: {} {}, {} in the queue, {} on the disk; {} truncated",
        endpointText(each.listened), lost.kernel,
        each.listened.endpoint.isNats() ? "at the server or on the way" : "in the kernel",
        lost.queue, lost.disk, lost.truncated);
  }
  text += inputText(summary);
  if (!summary.decoded) return text;
  text += fmt::format("\ndecoded {}:\n{}", countText(summary.decoded->decoded(), "packet"),
                      decode::accountText(*summary.decoded));
  text.pop_back();  // the caller ends the line
  return text;
}

std::string summaryJson(const RecordSummary& summary) {
  Json object;
  object["format"] = 1;
  // A ring that was never triggered wrote no log.
  object["log"] = orNull(summary.log.string());
  object["packets"] = summary.packets;
  object["restated"] = summary.restated;
  object["bytes"] = summary.log_bytes;
  object["payload_bytes"] = summary.payload_bytes;
  object["channels"] = summary.channels;
  object["duration_s"] = secondsOf(summary.duration);
  object["first_after_s"] = secondsOrNull(summary.first_after);
  addCounts(object["losses"], summary.losses);
  object["complete"] = summary.complete();
  object["reason"] = summary.reason;
  object["late"] = summary.late;
  object["endpoints"] = Json::array();
  for (std::size_t i = 0; i < summary.endpoints.size(); ++i) {
    const EndpointAccount& each = summary.endpoints[i];
    Json endpoint;
    endpoint["endpoint"] = endpointText(each.listened);
    endpoint["packets"] = each.recorded;
    addCounts(endpoint["losses"], each.losses);
    if (i < summary.inputs.size()) addInput(endpoint, summary.inputs[i]);
    object["endpoints"].push_back(std::move(endpoint));
  }
  object["tees"] = Json::array();
  for (const Tee::Account& each : summary.tees) {
    object["tees"].push_back(
        {{"endpoint", each.to.text()}, {"sent", each.sent}, {"dropped", each.dropped}});
    if (each.looped > 0) object["tees"].back()["looped"] = each.looped;
  }
  object["pieces"] = Json::array();
  for (const PieceFacts& each : summary.files.pieces) object["pieces"].push_back(pieceJson(each));
  const DeletedPieces& deleted = summary.files.deleted;
  object["deleted"] = {
      {"pieces", deleted.count}, {"packets", deleted.packets}, {"bytes", deleted.bytes}};
  object["packets_before"] = summary.packets_before;
  object["warnings"] = summary.warnings;
  if (summary.decoded) object["decoded"] = decode::accountJson(*summary.decoded);
  return jsonText(object);
}

}  // namespace rocinante
