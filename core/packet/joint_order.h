#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/session_state.h"

namespace rocinante {

/// The TAG of an order: the CRC-32 of its names, joined by line feeds
/// (docs/packet-format.md, "Values under a named order").
std::uint32_t orderTag(std::span<const std::string> names);

/// What a `joints` statement says.
struct JointsMeaning {
  /// The joints that its values are of; null: they are positions.
  const std::vector<std::string>* names = nullptr;
  /// order_mismatch, unknown_order: it has no effect.
  std::optional<PacketFault> fault;
};
/// `device`: what was said of it before; null: nothing.
JointsMeaning meaningOfJoints(const DeviceState* device, std::string_view source,
                              const Statement& joints);

}  // namespace rocinante
