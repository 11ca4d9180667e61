#pragma once

#include <string_view>

#include "core/packet/packet.h"

namespace rocinante {

/// How a fault of packet text is reported.
struct FaultRule {
  std::string_view rule;
  std::string_view text;  ///< of any number of them
  std::string_view hint;
};
const FaultRule& ruleOf(PacketFault fault);

}  // namespace rocinante
