#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/restatement.h"
#include "core/packet/session_state.h"

namespace rocinante::test {

inline LogTime atSeconds(double seconds) {
  return LogTime(Nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
}

/// Folds packets written as text into a state of its own.
class TextFold {
 public:
  Applied fold(double seconds, std::string_view text) {
    const Packet* const packet = decoder_.decode(bytesOf(text));
    EXPECT_NE(packet, nullptr) << text;
    return packet == nullptr ? Applied::late : state.apply(atSeconds(seconds), *packet);
  }
  void foldAll(double seconds, const std::vector<std::string>& datagrams) {
    for (const std::string& datagram : datagrams) fold(seconds, datagram);
  }
  const DeviceState& device(std::string_view name) const {
    static const DeviceState kNothing;
    const auto found = state.devices().find(name);
    return found == state.devices().end() ? kNothing : found->second;
  }
  const SourceCounts& counts(std::string_view source) const {
    return state.counts().find(source)->second;
  }

  SessionState state;

 private:
  PacketTextDecoder decoder_;
};

/// The faults of `text` as lines of "line column fault".
inline std::string faultsOf(std::string_view text) {
  PacketTextDecoder decoder;
  decoder.decode(bytesOf(text));
  std::string lines;
  for (const FaultAt& fault : decoder.faults()) {
    lines += std::to_string(fault.line) + ' ' + std::to_string(fault.column) + ' ' +
             std::string(nameOf(fault.fault)) + '\n';
  }
  return lines;
}

}  // namespace rocinante::test
