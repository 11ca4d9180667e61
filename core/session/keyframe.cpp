#include "core/session/keyframe.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/log/log_profile.h"
#include "core/packet/decoder.h"
#include "core/packet/restatement.h"

namespace rocinante {
namespace {

constexpr std::string_view kSeparator = "\n\n";

/// Reads one keyframe from text into a state.
class Reading {
 public:
  Reading(Decoder& decoder, LogTime moment) : decoder_(decoder), moment_(moment) {}

  Status add(std::string_view datagram) {
    ++number_;
    const Packet* const packet = decoder_.decode(bytesOf(datagram));
    if (packet == nullptr) return fault("is not a packet");
    for (const FaultAt& found : decoder_.faults()) {
      if (found.fault == PacketFault::unknown_statement) continue;
      return fault(fmt::format("has a fault in its line {}: {}", found.line, nameOf(found.fault)));
    }
    const PacketHeader& header = packet->header;
    if (header.by.empty() || !header.restated || !header.part || header.reset || header.via) {
      return fault("is not part of a keyframe");
    }
    // Each source must be stated once and in whole: otherwise reading could take for ever.
    const auto left = parts_left_.try_emplace(std::string(header.source), header.part->count).first;
    if (left->second == 0) return fault("repeats a source");
    --left->second;
    if (state_.apply(moment_, *packet) != Applied::yes) return fault("contradicts one before it");
    for (const Statement& statement : packet->statements) {
      if (statement.kind == StatementKind::seen) seen_.emplace(statement.name);
    }
    return {};
  }

  Result<SessionState> finish() {
    if (state_.restatementOpen()) return damaged("parts are missing");
    for (const auto& [source, counts] : state_.counts()) {
      for (std::size_t i = 0; i < kPacketFaultCount; ++i) {
        const auto kind = static_cast<PacketFault>(i);
        if (counts.faults[i] == 0 || kind == PacketFault::unknown_statement) continue;
        return damaged(fmt::format("its contents cannot be kept: {}", nameOf(kind)));
      }
    }
    for (const auto& device : state_.devices()) {
      if (!seen_.contains(device.first)) return damaged("a device lacks its last write");
    }
    return std::move(state_);
  }

 private:
  static Error damaged(std::string what) { return {ErrorKind::damaged, std::move(what), {}}; }
  Status fault(std::string_view what) const {
    return damaged(fmt::format("datagram {} {}", number_, what));
  }

  Decoder& decoder_;
  LogTime moment_;
  SessionState state_;
  std::size_t number_ = 0;
  std::map<std::string, std::uint32_t, std::less<>> parts_left_;  ///< by SOURCE
  std::set<std::string, std::less<>> seen_;                       ///< devices with a last write
};

}  // namespace

std::string keyframeText(const SessionState& state) {
  RestatementOptions options;
  options.by = "keyframe";
  options.with_seen = true;
  options.part_id = "k";
  std::string text;
  for (const std::string& datagram : restateAll(state, options)) {
    if (!text.empty()) text += '\n';
    text += datagram;
  }
  return text;
}

std::vector<std::string_view> keyframeDatagrams(ByteView payload) {
  std::vector<std::string_view> datagrams;
  std::string_view rest = textOf(payload);
  while (!rest.empty()) {
    const std::size_t end = rest.find(kSeparator);
    // The first LF of the separator ends the datagram's last line.
    datagrams.push_back(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + kSeparator.size());
  }
  return datagrams;
}

bool isKeyframeChannel(const LogChannel& channel) {
  return channel.topic == profile::kKeyframeTopic && channel.encoding == profile::kKeyframeEncoding;
}

KeyframeReader::KeyframeReader() : decoder_(makeDecoder("rk1")) {}
KeyframeReader::~KeyframeReader() = default;
KeyframeReader::KeyframeReader(KeyframeReader&&) noexcept = default;
KeyframeReader& KeyframeReader::operator=(KeyframeReader&&) noexcept = default;

Result<SessionState> KeyframeReader::read(ByteView payload, LogTime moment) {
  Reading reading(*decoder_, moment);
  for (const std::string_view datagram : keyframeDatagrams(payload)) {
    if (Status added = reading.add(datagram); !added) return added.error();
  }
  return reading.finish();
}

}  // namespace rocinante
