#pragma once

#include <string_view>

#include "core/model/model_fault.h"
#include "core/packet/packet.h"

namespace rocinante {

/// How a fault of packet text is reported.
struct FaultRule {
  std::string_view rule;
  Severity severity;
  std::string_view text;
};
const FaultRule& ruleOf(PacketFault fault);

}  // namespace rocinante
