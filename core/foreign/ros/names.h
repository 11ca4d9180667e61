#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/log/log_profile.h"
#include "core/packet/packet_limits.h"

namespace rocinante::ros {

/// The metadata `decoder` of the channels of packets that are made here.
inline constexpr std::string_view kDecoderName = "ros";

/// Before the topics of other programs that begin like our own.
inline constexpr std::string_view kImportedPrefix = "/imported";

/// Whether a packet can say the name: 1 to 255 bytes of UTF-8 without control characters.
inline bool isName(std::string_view name) {
  const auto is_control = [](char byte) {
    return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F;
  };
  return !name.empty() && name.size() <= limits::kNameBytes && isUtf8(bytesOf(name)) &&
         std::ranges::none_of(name, is_control);
}

/// The SOURCE of the packets made of a topic: "decoded:ros:arm:joint_states".
inline std::string sourceOf(std::string_view topic, std::string_view decoder = kDecoderName) {
  const std::string first = std::string(profile::kDecodedSource) + std::string(decoder);
  std::string name = first + (topic.starts_with('/') ? "" : ":");
  for (const char byte : topic) name += byte == '/' ? ':' : byte;
  return isName(name) ? name : first + ":" + hexOf(xxh3(bytesOf(topic)));
}

}  // namespace rocinante::ros
