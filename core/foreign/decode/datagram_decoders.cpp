#include "core/foreign/decode/datagram_decoders.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/pattern.h"
#include "core/log/log_profile.h"
#include "core/packet/text_number.h"

namespace rocinante::decode {
namespace {

/// Senders whose last values are remembered for events, per decoder.
constexpr std::size_t kMaxSenders = 4096;

/// "10.0.0.1" of "10.0.0.1:4000"; "::1" of "[::1]:4000".
std::string_view hostOf(std::string_view sender) {
  const std::size_t colon = sender.rfind(':');
  std::string_view host = sender.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  return host;
}

/// As it is declared: "robot-{number}".
std::string nameOf(const TextTemplate& text, const Decoder& decoder) {
  std::string name;
  for (const TextTemplate::Part& part : text.parts) {
    name += part.text;
    if (part.field) name += "{" + decoder.fields[*part.field].name + "}";
  }
  return name;
}

/// Of the poses of one line, what is not as their packets have it.
void addRotations(Account& account, const Decoder& decoder, const PoseLine& line,
                  const PacketLines::Rotations& rotations) {
  const auto add = [&](const char* kind, std::string reason, std::uint64_t count) {
    if (count == 0) return;
    account.leaveOut({.kind = kind,
                      .name = nameOf(line.device, decoder),
                      .reason = std::move(reason),
                      .first = decoder.name,
                      .count = count,
                      .severity = Severity::warning});
  };
  add("length",
      fmt::format("of quaternions off unit length by more than 0.001, normalised; the first has "
                  "length {:.6g}",
                  rotations.first_length),
      rotations.off_unit);
  add("pose", "a quaternion that is zero is no rotation", rotations.zero);
}

bool isFrom(const std::vector<std::string>& patterns, std::string_view sender) {
  if (patterns.empty()) return true;
  return !sender.empty() &&
         (anyPatternMatches(patterns, sender) || anyPatternMatches(patterns, hostOf(sender)));
}

}  // namespace

DatagramDecoders::DatagramDecoders(std::shared_ptr<const DecoderSet> set) : set_(std::move(set)) {
  for (const Decoder& decoder : set_->decoders) {
    readers_.push_back({makeFieldReader(decoder),
                        PacketLines(decoder),
                        std::vector<FieldValue>(decoder.fields.size()),
                        std::string(profile::kDecodedSource) + decoder.name,
                        {}});
  }
  counts_.resize(readers_.size());
}

Result<DatagramDecoders> DatagramDecoders::open(const std::filesystem::path& file) {
  auto set = readDecoders(file);
  if (!set) return set.error();
  return DatagramDecoders(std::move(*set));
}

bool DatagramDecoders::fits(const Match& match, const Route& route, ByteView payload) const {
  if (payload.size() < match.least_bytes || payload.size() > match.most_bytes) return false;
  if (!std::ranges::equal(payload.first(std::min(payload.size(), match.begins.size())),
                          match.begins)) {
    return false;
  }
  if (!match.ports.empty() && std::ranges::find(match.ports, route.port) == match.ports.end()) {
    return false;
  }
  if (!match.topics.empty() && !anyPatternMatches(match.topics, route.topic)) return false;
  return isFrom(match.from, route.sender);
}

const DecodedPacket* DatagramDecoders::decode(const Route& route, std::int64_t publish_time_ns,
                                              ByteView payload) {
  not_finite_.clear();
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    if (!fits(set_->decoders[i].match, route, payload)) continue;
    if (decodeBy(i, route, publish_time_ns, payload)) return &packet_;
  }
  return nullptr;
}

bool DatagramDecoders::decodeBy(std::size_t index, const Route& route, std::int64_t publish_time_ns,
                                ByteView payload) {
  Reader& reader = readers_[index];
  DecodeCounts& counts = counts_[index];
  const Decoder& decoder = set_->decoders[index];
  std::ranges::fill(reader.values, FieldValue());
  if (!reader.fields->read(payload, reader.values)) {
    ++counts.refused;
    counts.last_reason = reader.fields->reason();
    return false;
  }
  // Another decoder may be declared for the datagrams that these leave.
  for (const Condition& condition : decoder.match.where) {
    if (reader.values[condition.field].asNumber() != condition.equals) return false;
  }
  PacketHeader header;
  header.source = reader.source;
  if (publish_time_ns >= 0) header.time_ns = publish_time_ns;
  writer_.begin(header);
  std::vector<std::string>* before = nullptr;
  static const std::vector<std::string> kNone;
  if (!decoder.events.empty()) {
    key_ = route.sender;
    key_ += ' ';
    appendUnsigned(key_, route.port);
    auto found = reader.before.find(key_);
    if (found == reader.before.end() && reader.before.size() < kMaxSenders) {
      found = reader.before.emplace(key_, decoder.events.size()).first;
    }
    if (found != reader.before.end()) before = &found->second;
  }
  reader.lines.add(writer_, reader.values, before == nullptr ? kNone : *before);
  for (const std::size_t field : reader.lines.notFinite()) {
    not_finite_.push_back({reader.source, decoder.fields[field].name});
  }
  if (before != nullptr) {
    for (std::size_t i = 0; i < decoder.events.size(); ++i) {
      const FieldValue& value = reader.values[decoder.events[i].changes];
      if (value.kind != FieldValue::Kind::missing) (*before)[i] = valueText(value);
    }
  }
  if (!writer_.hasStatements()) {
    ++counts.empty;
    return false;
  }
  // These packets have no LF at their end.
  const std::string_view text = std::string_view(writer_.text()).substr(0, writer_.byteCount() - 1);
  if (text.size() > kMaxPacketBytes) {
    ++counts.refused;
    counts.last_reason = "its packet would be longer than a datagram";
    return false;
  }
  ++counts.decoded;
  packet_ = {index, reader.source, text};
  return true;
}

Account DatagramDecoders::leftOut() const {
  Account account;
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    const Decoder& decoder = set_->decoders[i];
    const auto add = [&](const std::string& name, const char* reason, std::uint64_t count) {
      if (count == 0) return;
      account.leaveOut(
          {.kind = "value", .name = name, .reason = reason, .first = decoder.name, .count = count});
    };
    for (std::size_t field = 0; field < decoder.fields.size(); ++field) {
      add(decoder.fields[field].name, "not a number, infinite, or not of the declared kind",
          readers_[i].lines.unusable()[field]);
      add(decoder.fields[field].name,
          "empty, over 255 bytes or otherwise no name that packets have",
          readers_[i].lines.noName()[field]);
    }
    for (std::size_t line = 0; line < decoder.poses.size(); ++line) {
      addRotations(account, decoder, decoder.poses[line], readers_[i].lines.rotations()[line]);
    }
    for (std::size_t line = 0; line < decoder.signals.size(); ++line) {
      add(decoder.fields[*decoder.signals[line].value.field].name,
          "without a name in `values`, stated as it is", readers_[i].lines.unnamed()[line]);
    }
  }
  return account;
}

std::vector<FoundField> DatagramDecoders::undeclared(const Route& route, ByteView payload,
                                                     std::size_t most) {
  for (std::size_t i = 0; i < readers_.size(); ++i) {
    if (!fits(set_->decoders[i].match, route, payload)) continue;
    return readers_[i].fields->undeclared(payload, most);
  }
  return {};
}

}  // namespace rocinante::decode
