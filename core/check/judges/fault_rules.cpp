#include "core/check/judges/fault_rules.h"

#include <array>

namespace rocinante {
namespace {

// In the order of PacketFault.
constexpr std::array<FaultRule, kPacketFaultCount> kFaultRules = {{
    {"packet.not-a-packet", "datagrams that begin like packet text but are not packets"},
    {"packet.bad-header", "datagrams whose first line is malformed"},
    {"packet.unknown-statement", "statements of an unknown kind"},
    {"packet.missing-field", "lines that end too soon"},
    {"packet.extra-field", "lines with too many fields"},
    {"packet.bad-name", "lines with a malformed name"},
    {"packet.bad-number", "lines with a malformed number"},
    {"packet.bad-color", "lines with a malformed colour"},
    {"packet.bad-string", "lines with a malformed string"},
    {"packet.bad-path", "lines with a malformed path"},
    {"packet.zero-quaternion", "poses whose quaternion is zero"},
    {"packet.unnormalised-quaternion",
     "poses whose quaternion is off unit length by more than 0.001; they are normalised"},
    {"packet.too-many", "packets or statements that exceed a limit of the packet format"},
    {"packet.joint-count", "`joints` whose count differs from their order"},
}};

}  // namespace

const FaultRule& ruleOf(PacketFault fault) { return kFaultRules[static_cast<std::size_t>(fault)]; }

}  // namespace rocinante
