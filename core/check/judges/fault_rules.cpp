#include "core/check/judges/fault_rules.h"

#include <array>

namespace rocinante {
namespace {

// In the order of PacketFault.
constexpr std::array<FaultRule, kPacketFaultCount> kFaultRules = {{
    {"packet.not-a-packet", "datagrams that begin like packet text but are not packets",
     "the first line must be RK1 SOURCE SEQUENCE TIME; the shortest is: RK1 me - -"},
    {"packet.bad-header", "datagrams whose first line is malformed",
     "SOURCE[@RUN], then a count from 0 or -, then seconds since the epoch or -"},
    {"packet.unknown-statement", "statements of an unknown kind",
     "a typing error, or a statement of a later version: it is skipped"},
    {"packet.missing-field", "lines that end too soon",
     "docs/packet-format.md lists the fields of each statement"},
    {"packet.extra-field", "lines with too many fields",
     "names and units with spaces are written with %20, numbers without thousands' separators"},
    {"packet.bad-name", "lines with a malformed name",
     "1 to 255 bytes of A-Z a-z 0-9 _ . - : and %XX for everything else"},
    {"packet.bad-number", "lines with a malformed number",
     "decimal with a point: no comma, no nan, no inf, no unit; of a signal also true, false, or a "
     "text in \"quotes\""},
    {"packet.bad-color", "lines with a malformed colour", "#RRGGBB or #RRGGBBAA"},
    {"packet.bad-string", "lines with a malformed string",
     "put it in double quotes, with \\\" \\\\ and \\n as the only escapes"},
    {"packet.bad-path", "lines with a malformed path",
     "DEVICE, DEVICE/LINK or layer/NAME; of a signal DEVICE, DEVICE/LINK or -"},
    {"packet.zero-quaternion", "poses whose quaternion is zero",
     "the identity rotation is 0 0 0 1: x y z w, w last"},
    {"packet.unnormalised-quaternion",
     "poses whose quaternion is off unit length by more than 0.001; they are normalised",
     "is the order x y z w, w last?"},
    {"packet.too-many", "packets or statements that exceed a limit of the packet format",
     "docs/packet-format.md lists the limits; what exceeds one is ignored"},
    {"packet.joint-count", "`joints` whose count differs from their order",
     "no value is applied: send as many values as the `order` of the device has names"},
    {"packet.unknown-order", "`joints @TAG` without the `order` of that TAG",
     "no value is applied until the order is sent again: was it lost, or is it never restated?"},
}};

}  // namespace

const FaultRule& ruleOf(PacketFault fault) { return kFaultRules[static_cast<std::size_t>(fault)]; }

}  // namespace rocinante
