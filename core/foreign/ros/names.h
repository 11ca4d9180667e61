#pragma once

#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/log/log_profile.h"
#include "core/packet/packet_text.h"

namespace rocinante::ros {

/// The metadata `decoder` of the channels of packets that are made here.
inline constexpr std::string_view kDecoderName = "ros";
/// The metadata `decoder_version`, raised whenever the same messages become other packets: 1, which
/// was not written, knew of signals only those of joints.
inline constexpr std::string_view kDecoderVersionKey = "decoder_version";
inline constexpr std::string_view kDecoderVersion = "2";

/// Before the topics of other programs that begin like our own.
inline constexpr std::string_view kImportedPrefix = "/imported";

/// The SOURCE of the packets made of a topic: "decoded:ros:arm:joint_states".
inline std::string sourceOf(std::string_view topic, std::string_view decoder = kDecoderName) {
  const std::string first = std::string(profile::kDecodedSource) + std::string(decoder);
  std::string name = first + (topic.starts_with('/') ? "" : ":");
  for (const char byte : topic) name += byte == '/' ? ':' : byte;
  return isName(name) ? name : first + ":" + hexOf(xxh3(bytesOf(topic)));
}

}  // namespace rocinante::ros
