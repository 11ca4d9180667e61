#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rocinante {

/// What a channel of an exported file is, by our own names, which its topic has no bytes for: a
/// signal, or what a device's joints do.
struct ChannelNames {
  std::string device, link;  ///< whose it is; empty: of none
  std::string signal;        ///< empty: joint states of `device`
  std::string unit;          ///< of the signal's numbers; empty: none

  auto operator<=>(const ChannelNames&) const = default;
};

using ChannelMetadata = std::map<std::string, std::string>;

/// The channel's metadata, as packet text writes names: `rocinante.path`, and of a signal
/// `rocinante.name` and `rocinante.unit`.
ChannelMetadata channelMetadata(const ChannelNames& names);

/// Of anybody's channel: empty where it says nothing, or what no packet could say.
std::optional<ChannelNames> channelNamesIn(const ChannelMetadata& metadata);
/// Whether it says something, usable or not.
bool hasChannelNames(const ChannelMetadata& metadata);

}  // namespace rocinante
