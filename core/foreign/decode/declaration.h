#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/document/fault_list.h"

namespace rocinante::protobuf {
class Schema;
}

/// What a file of decoders declares (docs/decoders.md): plain values, checked, with every name of a
/// field resolved to its index.
namespace rocinante::decode {

enum class Kind : std::uint8_t { structure, delimited, json, xml, dis, protobuf };

/// "struct", "delimited" and so on.
std::string_view nameOf(Kind kind);

/// Limits of one file.
inline constexpr std::size_t kMaxDecoders = 256;
inline constexpr std::size_t kMaxFields = 4096;  ///< of one decoder, elements of arrays counted
inline constexpr std::size_t kMaxLines = 4096;   ///< of one decoder
inline constexpr std::size_t kMaxFileBytes = std::size_t{1} << 20U;

enum class NumberType : std::uint8_t {
  u8,
  i8,
  u16,
  i16,
  u24,
  i24,
  u32,
  i32,
  u64,
  i64,
  f32,
  f64,
  text
};

/// A field of a datagram. Which members count depends on the decoder's kind.
struct Field {
  std::string name;
  Place place;
  // structure
  std::size_t at = 0;
  NumberType type = NumberType::u8;
  bool little_endian = true;
  std::size_t text_bytes = 0;  ///< of NumberType::text
  unsigned first_bit = 0;      ///< 0 is the least significant
  unsigned bits = 0;           ///< 0: the whole number
  // delimited
  std::size_t column = 0;
  // json: a JSON pointer; xml: ELEMENT/ELEMENT or ELEMENT@ATTRIBUTE, below the root;
  // dis: a name of dis_field.h; protobuf: a.b[2].c
  std::string path;
  /// A line, a condition or the decoder itself reads it.
  bool used = false;
};

enum class ChecksumKind : std::uint8_t {
  sum8,
  xor8,
  crc16_ccitt,
  crc16_modbus,
  crc16_mcrf4xx,
  crc32
};

/// Positions below 0 count from the end of the datagram.
struct Checksum {
  ChecksumKind kind = ChecksumKind::sum8;
  std::int64_t from = 0;
  std::int64_t until = 0;  ///< not included
  std::int64_t at = 0;
  bool little_endian = true;
  /// Bytes that are summed after the others, and not sent.
  Bytes then;
};

/// A number made of a field, or a constant.
struct Term {
  std::optional<std::size_t> field;  ///< index in Decoder::fields
  double times = 1;
  double plus = 0;  ///< without a field: the constant
};

/// Text with the values of fields in it: "ship-{id}".
struct TextTemplate {
  struct Part {
    std::string text;                  ///< before the field
    std::optional<std::size_t> field;  ///< none behind the last text
    bool operator==(const Part&) const = default;
  };
  std::vector<Part> parts;
  bool operator==(const TextTemplate&) const = default;
};

struct JointsLine {
  struct Joint {
    std::string name;
    Term value;
  };
  TextTemplate device;
  std::vector<Joint> joints;
};

struct PoseLine {
  enum class Rotation : std::uint8_t { none, quaternion, euler };
  TextTemplate device;
  std::array<Term, 3> position{};
  Rotation rotation = Rotation::none;
  std::array<Term, 4> quaternion{};  ///< x y z w
  std::array<Term, 3> angles{};      ///< radians, in the order of `axes`
  std::array<int, 3> axes{};         ///< 0 x, 1 y, 2 z
  bool fixed_axes = false;           ///< else each about the axes that the ones before it turned
};

/// What a `[[decoder.signal]]` declares: one signal of a field.
struct SignalLine {
  TextTemplate path;  ///< DEVICE, DEVICE/LINK or -
  TextTemplate name;
  Term value;
  std::string unit;
  bool is_text = false;     ///< the field as it is
  bool is_boolean = false;  ///< true where the bit is 1
  unsigned first_bit = 0;
  unsigned bits = 0;  ///< of a whole number, before all else; 0: the number as it is
  /// An enumeration: the text of a value that reads so.
  std::map<std::string, std::string, std::less<>> words;
};

struct EventLine {
  TextTemplate text;
  /// The event is said when this field differs from the sender's last datagram.
  std::size_t changes = 0;
};

/// A number that a field must have.
struct Condition {
  std::size_t field = 0;
  double equals = 0;
};

/// Which datagrams a decoder reads: those that fit everything.
struct Match {
  std::vector<std::uint16_t> ports;  ///< local; empty: any
  std::vector<std::string> from;     ///< patterns of ADDRESS or ADDRESS:PORT; empty: any
  std::vector<std::string> topics;   ///< patterns; empty: any
  Bytes begins;
  std::size_t least_bytes = 0;
  std::size_t most_bytes = SIZE_MAX;
  std::vector<Condition> where;
};

/// A place on the WGS 84 ellipsoid, or above it.
struct GeoPlace {
  double latitude_deg = 0;   ///< -90 to 90
  double longitude_deg = 0;  ///< -360 to 360, positive to the east
  double height_m = 0;
};

struct Decoder {
  std::string name;  ///< 1 to 200 bytes
  Place place;
  Kind kind = Kind::structure;
  Match match;
  std::vector<Field> fields;
  // structure, delimited
  std::optional<Checksum> checksum;
  /// structure: fields that reach past the checksum read as zero there (MAVLink 2).
  bool zero_filled = false;
  // delimited
  std::string separator = ",";
  // dis
  std::optional<GeoPlace> origin;
  // protobuf
  std::shared_ptr<const protobuf::Schema> schema;

  std::vector<JointsLine> joints;
  std::vector<PoseLine> poses;
  std::vector<SignalLine> signals;
  std::vector<EventLine> events;
};

}  // namespace rocinante::decode
