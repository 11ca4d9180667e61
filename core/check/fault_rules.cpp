#include "core/check/fault_rules.h"

#include <array>

namespace rocinante {
namespace {

// In the order of PacketFault.
constexpr std::array<FaultRule, kPacketFaultCount> kRules = {{
    {"packet.not-a-packet", Severity::error, "datagrams that begin like packet text and are none"},
    {"packet.bad-header", Severity::error, "datagrams whose first line is malformed"},
    {"packet.unknown-statement", Severity::note, "statements of a kind that is not known here"},
    {"packet.missing-field", Severity::error, "lines that end too soon"},
    {"packet.extra-field", Severity::error, "lines with more fields than they may have"},
    {"packet.bad-name", Severity::error, "lines with a malformed name"},
    {"packet.bad-number", Severity::error, "lines with a malformed number"},
    {"packet.bad-color", Severity::error, "lines with a malformed colour"},
    {"packet.bad-string", Severity::error, "lines with a malformed string"},
    {"packet.bad-path", Severity::error, "lines with a malformed path"},
    {"packet.zero-quaternion", Severity::error, "poses whose quaternion is zero"},
    {"packet.unnormalised-quaternion", Severity::warning,
     "poses whose quaternion is off unit length by more than 0.001; they are normalised"},
    {"packet.too-many", Severity::error, "what exceeds a limit of the packet format"},
    {"packet.joint-count", Severity::error, "joints with another count than their order"},
}};

}  // namespace

const FaultRule& ruleOf(PacketFault fault) { return kRules[static_cast<std::size_t>(fault)]; }

}  // namespace rocinante
