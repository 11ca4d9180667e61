#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rocinante {

/// `part=ID:I/N`: this datagram is part `index` (from 1) of `count` of one whole restatement.
struct RestatementPart {
  std::string_view id;
  std::uint32_t index = 1;
  std::uint32_t count = 1;
};

/// `via=RELAY:N`: the relay's own count of what it sent on.
struct Via {
  std::string_view relay;
  std::uint64_t sequence = 0;
};

/// The first line of a packet (docs/packet-format.md, section "The header").
/// Views are borrowed from the decoder and the datagram; see Decoder::decode.
struct PacketHeader {
  std::string_view source;  ///< decoded name, never empty
  std::string_view run;     ///< empty when the source sends none
  std::optional<std::uint64_t> sequence;
  std::optional<std::int64_t> time_ns;  ///< since the epoch, on the source's clock
  bool restated = false;
  bool reset = false;
  std::optional<RestatementPart> part;
  std::string_view by;  ///< the restating program; empty when it is the source itself
  std::optional<Via> via;
};

enum class StatementKind : std::uint8_t {
  joints,   ///< device; order_tag; numbers
  order,    ///< device; names
  joint,    ///< device; names and numbers, one number a name
  pose,     ///< device; numbers = x y z qx qy qz qw (normalised); carrier
  add,      ///< device; text = MODEL; kinematics
  remove,   ///< device
  show,     ///< path; is_default
  hide,     ///< path
  color,    ///< path; rgba, or is_default
  line,     ///< id; part; rgba; size_px; carrier; numbers = x y z ...
  points,   ///< id; part; rgba; size_px; carrier; numbers = x y z ...
  label,    ///< id; carrier; numbers = x y z; text
  erase,    ///< id, or all of the source's drawings when the id is empty
  event,    ///< text
  view,     ///< id; numbers = ex ey ez tx ty tz fov_deg ux uy uz; ortho_height_m; carrier
  signal,   ///< path; names, numbers and signal_kinds of one; text; unit; or is_default
  signals,  ///< path; names, numbers and signal_kinds, as many of each; no text
  seen,     ///< device; seen_ns
};

/// The values of a device: where it is and how it stands.
constexpr bool isDeviceValue(StatementKind kind) {
  return kind == StatementKind::joints || kind == StatementKind::joint ||
         kind == StatementKind::pose;
}
/// What can change where something is.
constexpr bool movesDevice(StatementKind kind) {
  return isDeviceValue(kind) || kind == StatementKind::add || kind == StatementKind::remove;
}
/// What a source states of the device that it names first.
constexpr bool isOfDevice(StatementKind kind) {
  return movesDevice(kind) || kind == StatementKind::order;
}
constexpr bool isOfPath(StatementKind kind) {
  return kind == StatementKind::show || kind == StatementKind::hide || kind == StatementKind::color;
}
constexpr bool isSignal(StatementKind kind) {
  return kind == StatementKind::signal || kind == StatementKind::signals;
}
constexpr bool isDrawing(StatementKind kind) {
  return kind == StatementKind::line || kind == StatementKind::points ||
         kind == StatementKind::label;
}

/// Two names that address a thing: DEVICE, DEVICE/LINK, or layer/NAME (then `first` is "layer"
/// and `is_layer` is true). Names are decoded, so a link's name may itself hold a slash.
struct PathView {
  std::string_view first;
  std::string_view second;  ///< empty for a whole device
  bool is_layer = false;
};

/// What the value of a signal is.
enum class SignalKind : std::uint8_t {
  number,
  boolean,  ///< its number is 1 or 0
  text,     ///< its number is 0
};
inline constexpr std::size_t kSignalKindCount = 3;

/// A statement. The kind decides which fields have a meaning; the rest keep their defaults.
struct Statement {
  StatementKind kind = StatementKind::event;
  std::uint32_t line = 0;           ///< in the datagram, from 1 (the header's line)
  std::string_view name;            ///< DEVICE, or the ID of a drawing, or the NAME of a view
  PathView path;                    ///< show, hide, color; signal, signals: empty for `-`
  PathView carrier;                 ///< `in DEVICE/LINK`; empty `first` means the world
  std::string_view text;            ///< MODEL, or the unescaped string of label, event and signal
  std::span<const double> numbers;  ///< metres and radians; of signals in their units
  std::span<const std::string_view> names;  ///< of joints or signals
  std::span<const SignalKind> signal_kinds;
  std::string_view unit;                    ///< of the number of a `signal`; empty: it has none
  std::optional<std::uint64_t> kinematics;  ///< kin=HEX16
  std::optional<std::uint32_t> order_tag;   ///< @TAG of joints: the order that the values need
  std::uint32_t rgba = 0;                   ///< 0xRRGGBBAA
  bool is_default = false;                  ///< "the cell's own value" in place of a value
  std::optional<double> size_px;            ///< width= of a line, size= of points
  std::optional<double> ortho_height_m;     ///< view: orthographic
  std::uint32_t part_index = 1;             ///< ID:I/N of a long line or cloud
  std::uint32_t part_count = 1;
  std::int64_t seen_ns = 0;  ///< log time, nanoseconds since the epoch
};

/// True when a signal of the statement is no number, and so a state.
inline bool hasStateSignal(const Statement& statement) {
  for (const SignalKind kind : statement.signal_kinds) {
    if (kind != SignalKind::number) return true;
  }
  return false;
}

/// Faults of a datagram or one of its lines. A fault is counted; it is not an error.
enum class PacketFault : std::uint8_t {
  not_a_packet,       ///< no header line: the whole datagram is ignored
  bad_header,         ///< a header word is malformed: the whole datagram is dropped
  unknown_statement,  ///< skipped, so that later versions can add statements
  missing_field,
  extra_field,
  bad_name,
  bad_number,
  bad_color,
  bad_string,
  bad_path,
  zero_quaternion,
  unnormalised_quaternion,  ///< more than 1e-3 from unit length; normalised and applied
  too_many,                 ///< beyond a limit of docs/packet-format.md
  order_mismatch,           ///< found by the fold: `joints` with another count than its `order`
  unknown_order,            ///< found by the fold: `joints @TAG` without the order of that TAG
};
inline constexpr std::size_t kPacketFaultCount = 15;

/// "bad_number" and so on: the names that reports use.
std::string_view nameOf(PacketFault fault);
std::string_view nameOf(StatementKind kind);
/// "number", "boolean", "text"
std::string_view nameOf(SignalKind kind);

/// A fault in a datagram. `column` counts bytes from 1.
struct FaultAt {
  PacketFault fault;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// A field of octets that a decoder reads for a value, and that is NaN or infinite: it makes none.
/// Borrowed from the decoder.
struct NotFiniteField {
  std::string_view source;  ///< "decoded:NAME"
  std::string_view field;   ///< as the declaration calls it
};

/// The decoded meaning of one datagram. Borrowed: see Decoder::decode.
struct Packet {
  PacketHeader header;
  std::span<const Statement> statements;
  std::span<const FaultAt> faults;  ///< in order of lines
};

}  // namespace rocinante
