#include "core/log/message_span.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/log/mcap_stream_reader.h"

namespace rocinante {

using mcap::Opcode;

LogTime logTimeOf(std::uint64_t file_time) {
  constexpr auto kLast = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  return LogTime(Nanoseconds(static_cast<std::int64_t>(std::min(file_time, kLast))));
}

void SpanDecoder::decode(const MessageSpan& span, SpanMessages& out) {
  out.records = {};
  out.places.clear();
  out.channels.clear();
  out.damage.clear();
  if (span.loose) {
    out.records = file_.subspan(static_cast<std::size_t>(span.offset),
                                static_cast<std::size_t>(span.end - span.offset));
  } else {
    Result<ByteView> records = span.cut ? expander_.expandCut(span.chunk, out.scratch)
                                        : expander_.expand(span.chunk, out.scratch);
    if (!records) {
      out.damage.push_back({span.offset, span.end, records.error().what, indexedMessages(span)});
      return;
    }
    out.records = *records;
  }
  readRecords(span, out);
  // Nearly always so already: recorders write in time order.
  if (!std::is_sorted(out.places.begin(), out.places.end())) {
    std::sort(out.places.begin(), out.places.end());
  }
}

void SpanDecoder::readRecords(const MessageSpan& span, SpanMessages& out) {
  std::uint64_t position = 0;
  std::uint64_t malformed = 0;
  while (position < out.records.size()) {
    const std::optional<mcap::Record> record = mcap::recordAt(out.records, position);
    if (!record) {
      if (!span.cut) {
        out.damage.push_back(
            {span.offset, span.end,
             fmt::format("a record reaches past the end of its chunk, {} bytes into it", position),
             std::nullopt});
      }
      break;
    }
    if (record->opcode == Opcode::message) {
      mcap::Message message;
      constexpr auto kLast = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
      if (!mcap::parse(record->content, message) || message.log_time > kLast) {
        ++malformed;
      } else {
        out.places.push_back({static_cast<std::int64_t>(message.log_time),
                              static_cast<std::uint32_t>(position), message.channel_id});
      }
    } else if (record->opcode == Opcode::channel) {
      mcap::Channel channel;
      if (mcap::parse(record->content, channel)) out.channels.push_back(std::move(channel));
    }
    position = record->end();
  }
  if (malformed > 0) {
    out.damage.push_back(
        {span.offset, span.end, fmt::format("{} messages are malformed", malformed), malformed});
  }
}

std::optional<std::uint64_t> SpanDecoder::indexedMessages(const MessageSpan& span) const {
  std::optional<std::uint64_t> count;
  std::uint64_t position = span.end;
  while (const std::optional<mcap::Record> record = mcap::recordAt(file_, position)) {
    mcap::MessageIndex index;
    if (record->opcode != Opcode::message_index || !mcap::parse(record->content, index)) break;
    count = count.value_or(0) + index.records.size();
    position = record->end();
  }
  return count;
}

}  // namespace rocinante
