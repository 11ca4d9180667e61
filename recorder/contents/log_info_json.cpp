#include <cmath>

#include "core/base/duration_text.h"
#include "core/report/json_text.h"
#include "recorder/contents/log_info.h"

namespace rocinante {
namespace {

std::string metadataOf(const LogChannel& channel, const char* key) {
  const auto found = channel.metadata.find(key);
  return found == channel.metadata.end() ? std::string() : found->second;
}

/// Thousandths are as precise as a rate is; further digits only differ between libraries.
double thousandths(double value) { return std::round(value * 1000) / 1000; }

Json channelJson(const ChannelInfo& info) {
  Json json = {{"id", info.channel.id},
               {"topic", info.channel.topic},
               {"encoding", info.channel.encoding},
               {"sender", metadataOf(info.channel, "remote")},
               {"source", metadataOf(info.channel, "source")},
               {"messages", info.messages},
               {"rate_hz", thousandths(info.rateHz())},
               {"first_ns", info.messages > 0 ? Json(nanosecondsOf(info.first)) : Json(nullptr)},
               {"last_ns", info.messages > 0 ? Json(nanosecondsOf(info.last)) : Json(nullptr)},
               {"longest_gap_ns", info.longest_gap.count()},
               {"longest_gap_from_ns",
                info.longest_gap.count() > 0 ? Json(nanosecondsOf(info.gap_from)) : Json(nullptr)}};
  // Who made decoded packets, and by which version of a translation.
  for (const char* const key : {"decoder", "decoder_version"}) {
    if (info.channel.metadata.contains(key)) json[key] = metadataOf(info.channel, key);
  }
  return json;
}

Json channelsJson(const std::vector<ChannelInfo>& channels) {
  Json out = Json::array();
  for (const ChannelInfo& info : channels) out.push_back(channelJson(info));
  return out;
}

Json lossesJson(const LogInfo& info) {
  Json spans = Json::array();
  for (const LossSpan& span : info.loss_spans) {
    spans.push_back({{"endpoint", span.endpoint},
                     {"from_ns", nanosecondsOf(span.from)},
                     {"until_ns", nanosecondsOf(span.until)},
                     {"kernel", span.counts.kernel},
                     {"queue", span.counts.queue},
                     {"disk", span.counts.disk},
                     {"truncated", span.counts.truncated}});
  }
  return {{"kernel", info.losses.kernel},  {"queue", info.losses.queue},
          {"disk", info.losses.disk},      {"truncated", info.losses.truncated},
          {"source_gap", info.source_gap}, {"spans", std::move(spans)}};
}

Json damageJson(const std::vector<DamageSpan>& damage) {
  Json out = Json::array();
  for (const DamageSpan& span : damage) {
    Json each = {{"from", span.from}, {"to", span.to}, {"cause", span.cause}};
    each["messages_lost"] = orNull(span.messages_lost);
    out.push_back(std::move(each));
  }
  return out;
}

Json eventsJson(const std::vector<Event>& events) {
  Json out = Json::array();
  for (const Event& event : events) {
    out.push_back({{"log_time_ns", nanosecondsOf(event.time)},
                   {"source", event.source},
                   {"text", event.text}});
  }
  return out;
}

Json attachmentsJson(const std::vector<LogAttachment>& attachments) {
  Json out = Json::array();
  for (const LogAttachment& attachment : attachments) {
    out.push_back({{"name", attachment.name},
                   {"media_type", attachment.media_type},
                   {"log_time_ns", nanosecondsOf(attachment.log_time)},
                   {"bytes", attachment.data_bytes}});
  }
  return out;
}

}  // namespace

std::string logInfoJson(const LogInfo& info, bool indented) {
  const LogSummary& summary = info.summary;
  Json out;
  out["format"] = 1;
  out["log"] = info.name;
  out["session_id"] = summary.session_id;
  out["messages"] = info.messages;
  out["packets"] = info.packets;
  out["origin_ns"] = nanosecondsOf(summary.origin);
  out["start_ns"] = nanosecondsOf(summary.start);
  out["end_ns"] = nanosecondsOf(summary.end);
  out["duration_s"] = static_cast<double>((summary.end - summary.start).count()) / 1e9;
  out["content_sha256"] = info.content_sha256;
  if (!info.decoded_sha256.empty()) {
    out["decoded"] = info.decoded;
    out["decoded_sha256"] = info.decoded_sha256;
  }
  out["stream_sha256"] = info.stream_sha256;
  out["channels"] = channelsJson(info.channels);
  out["own_channels"] = channelsJson(info.own_channels);
  out["keyframes"] = info.keyframes;
  out["events"] = info.events;
  out["marks"] = info.marks;
  out["event_list"] = eventsJson(info.first_events);
  out["losses"] = lossesJson(info);
  out["profile"] = summary.profile;
  out["library"] = summary.library;
  out["complete"] = summary.complete;
  out["end_reason"] = summary.end_reason;
  out["attachments"] = attachmentsJson(info.attachments);
  std::uint64_t attached_bytes = 0;
  for (const LogAttachment& each : info.attachments) attached_bytes += each.data_bytes;
  out["attached_bytes"] = attached_bytes;
  out["at_rest"] = info.account.at_rest;
  out["not_in_cell"] = info.account.not_in_cell;
  out["left_out"] = leftOutJson(info.account.left_out);
  out["compression"] = info.storage.compressions;
  out["chunks"] = info.storage.chunks;
  out["file_bytes"] = info.storage.file_bytes;
  out["stored_bytes"] = info.storage.stored_bytes;
  out["expanded_bytes"] = info.storage.expanded_bytes;
  out["damage"] = damageJson(info.damage);
  return jsonText(out, indented ? 2 : -1);
}

}  // namespace rocinante
