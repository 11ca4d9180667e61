#include "core/packet/packet.h"

namespace rocinante {

std::string_view nameOf(PacketFault fault) {
  switch (fault) {
    case PacketFault::not_a_packet:
      return "not_a_packet";
    case PacketFault::bad_header:
      return "bad_header";
    case PacketFault::unknown_statement:
      return "unknown_statement";
    case PacketFault::missing_field:
      return "missing_field";
    case PacketFault::extra_field:
      return "extra_field";
    case PacketFault::bad_name:
      return "bad_name";
    case PacketFault::bad_number:
      return "bad_number";
    case PacketFault::bad_color:
      return "bad_color";
    case PacketFault::bad_string:
      return "bad_string";
    case PacketFault::bad_path:
      return "bad_path";
    case PacketFault::zero_quaternion:
      return "zero_quaternion";
    case PacketFault::unnormalised_quaternion:
      return "unnormalised_quaternion";
    case PacketFault::too_many:
      return "too_many";
    case PacketFault::order_mismatch:
      return "order_mismatch";
    case PacketFault::unknown_order:
      return "unknown_order";
  }
  return "?";
}

std::string_view nameOf(StatementKind kind) {
  switch (kind) {
    case StatementKind::joints:
      return "joints";
    case StatementKind::order:
      return "order";
    case StatementKind::joint:
      return "joint";
    case StatementKind::pose:
      return "pose";
    case StatementKind::add:
      return "add";
    case StatementKind::remove:
      return "remove";
    case StatementKind::show:
      return "show";
    case StatementKind::hide:
      return "hide";
    case StatementKind::color:
      return "color";
    case StatementKind::line:
      return "line";
    case StatementKind::points:
      return "points";
    case StatementKind::label:
      return "label";
    case StatementKind::erase:
      return "erase";
    case StatementKind::event:
      return "event";
    case StatementKind::view:
      return "view";
    case StatementKind::signal:
      return "signal";
    case StatementKind::signals:
      return "signals";
    case StatementKind::seen:
      return "seen";
  }
  return "?";
}

std::string_view nameOf(SignalKind kind) {
  switch (kind) {
    case SignalKind::number:
      return "number";
    case SignalKind::boolean:
      return "boolean";
    case SignalKind::text:
      return "text";
  }
  return "?";
}

}  // namespace rocinante
