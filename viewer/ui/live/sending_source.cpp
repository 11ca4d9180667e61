#include "viewer/ui/live/sending_source.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/base/bytes.h"
#include "core/base/plain_text.h"
#include "core/base/random_id.h"
#include "core/packet/packet_text.h"
#include "core/transport/open_sink.h"

namespace rocinante {
namespace {

/// Ten times a second, as Source::flush() asks for, with room for a late frame.
constexpr Nanoseconds kLongestPause = std::chrono::milliseconds(80);

}  // namespace

Result<SendingSource> SendingSource::open(const Endpoint& to, const SendingSettings& settings) {
  auto sink = openSink(to);
  if (!sink) return sink.error();
  return into(std::move(*sink), settings);
}

Result<SendingSource> SendingSource::into(std::unique_ptr<DatagramSink> sink,
                                          const SendingSettings& settings) {
  auto trouble = std::make_unique<std::string>();
  const std::string run = settings.run.empty() ? randomId(5) : settings.run;
  SourceSettings how;
  how.source = settings.source;
  how.run = run;
  auto source =
      Source::open(how, [to = sink.get(), why = trouble.get()](std::span<std::byte> datagram) {
        const std::array payloads{ByteView(datagram)};
        const auto sent = to->sendWithoutWaiting(payloads);
        if (!sent) {
          *why = sent.error().text();
          return false;
        }
        if (*sent == 0) {
          *why = "the system has no room for more datagrams";
          return false;
        }
        why->clear();
        return true;
      });
  if (!source) return source.error();
  return SendingSource(std::move(sink), std::move(trouble), std::move(*source), settings.source,
                       run);
}

void SendingSource::noteAnswer(SourceResult answer, std::string_view what) {
  if (answer == SourceResult::done) {
    changed_ = true;
  } else {
    *trouble_ = fmt::format("{} is not sent: {}", plainText(what), sentenceOf(answer));
  }
}

void SendingSource::tick(SteadyTime now, WallTime wall) {
  if (flushed_at_) {
    const Nanoseconds since = now - *flushed_at_;
    if (since < (changed_ ? kPeriod : kLongestPause)) return;
  }
  finish(now, wall);
}

void SendingSource::finish(SteadyTime now, WallTime wall) {
  const SourceResult flushed = source_.flush(now.time_since_epoch(), wall);
  // The sink's own words say what could not be sent.
  if (flushed != SourceResult::done && flushed != SourceResult::not_sent) {
    *trouble_ = std::string(sentenceOf(flushed));
  }
  changed_ = false;
  flushed_at_ = now;
}

void SendingSource::withdraw(SteadyTime now, WallTime wall) {
  finish(now, wall);
  // Nothing makes up for a lost one, so there is another.
  for (std::uint32_t copy = 0; copy < 2; ++copy) {
    const std::string id = fmt::format("end{}", copy);
    PacketHeader header;
    header.source = name_;
    header.run = run_;
    header.sequence = source_.sent() + copy;
    header.time_ns = wall.time_since_epoch().count();
    header.restated = true;
    header.part = RestatementPart{id, 1, 1};
    const PacketTextWriter packet(header);
    const std::array payloads{bytesOf(packet.text())};
    const auto sent = sink_->sendWithoutWaiting(payloads);
    if (!sent) *trouble_ = sent.error().text();
  }
}

}  // namespace rocinante
