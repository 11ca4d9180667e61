#include "recorder/spy/spy_decoders.h"

#include <utility>

#include "core/base/plain_text.h"
#include "core/foreign/decode/carried_decoders.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxUndeclared = 200;
constexpr std::size_t kMaxValueBytes = 80;

std::string shownValue(std::string_view text) {
  const std::string plain = plainText(text.substr(0, kMaxValueBytes));
  return text.size() > kMaxValueBytes ? plain + "..." : plain;
}

}  // namespace

SpyDecoders::SpyDecoders(std::shared_ptr<const decode::DecoderSet> set,
                         std::vector<ListenedEndpoint> endpoints)
    : received_(std::move(set), std::move(endpoints)) {
  for (const decode::Decoder& each : this->set().decoders) {
    last_.push_back({decode::makeFieldReader(each), {}});
  }
}

const MadePacket* SpyDecoders::decode(std::size_t endpoint, const ReceivedDatagram& datagram,
                                      LogTime time) {
  const MadePacket* const made = received_.decode(endpoint, datagram, time);
  if (encodingOf(datagram.payload) == "rk1") return made;
  const FlowChannel& channel = received_.channelOf(endpoint, datagram);
  const decode::Route route = decode::routeOf(channel.topic, channel.metadata);
  for (std::size_t i = 0; i < last_.size(); ++i) {
    const bool is_its = made != nullptr && made->decoder == i;
    // One that gave a packet tells more than one that only fits.
    const bool tells = is_its || (!last_[i].decoded &&
                                  received_.decoder().decoders().fits(i, route, datagram.payload));
    if (tells) {
      last_[i].datagram.assign(datagram.payload.begin(), datagram.payload.end());
      last_[i].any = true;
      last_[i].decoded = is_its;
    }
    if (is_its) break;
  }
  return made;
}

void SpyDecoders::readFields(std::size_t decoder, SpyDecoder& report) {
  Last& last = last_[decoder];
  const decode::Decoder& declared = set().decoders[decoder];
  std::vector<decode::FieldValue> values(declared.fields.size());
  (void)last.reader->read(last.datagram, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    SpyField& field = report.fields.emplace_back();
    field.name = declared.fields[i].name;
    field.used = declared.fields[i].used;
    if (values[i].kind == decode::FieldValue::Kind::missing) continue;
    field.number = values[i].asNumber();
    field.value = shownValue(decode::valueText(values[i]));
  }
  for (const decode::FoundField& each : last.reader->undeclared(last.datagram, kMaxUndeclared)) {
    SpyField& field = report.fields.emplace_back();
    field.name = shownValue(each.name);
    field.value = shownValue(each.value);
    field.declared = field.used = false;
  }
}

std::vector<SpyDecoder> SpyDecoders::report() {
  std::vector<SpyDecoder> report;
  for (std::size_t i = 0; i < last_.size(); ++i) {
    const decode::Decoder& declared = set().decoders[i];
    const decode::DecodeCounts& counts = received_.decoder().decoders().counts()[i];
    SpyDecoder& each = report.emplace_back();
    each.name = declared.name;
    each.kind = decode::nameOf(declared.kind);
    each.packets = counts.decoded;
    each.refused = counts.refused;
    each.empty = counts.empty;
    each.reason = counts.last_reason;
    if (last_[i].any) readFields(i, each);
  }
  return report;
}

}  // namespace rocinante
