#include <array>
#include <optional>

#include "core/foreign/decode/dis_field.h"
#include "core/foreign/decode/field_reader.h"
#include "core/foreign/decode/geo_frame.h"
#include "core/foreign/decode/number_type.h"
#include "core/foreign/decode/packet_lines.h"

namespace rocinante::decode {
namespace {

using Quantity = DisField::Quantity;

constexpr std::size_t kEntityStateBytes = 144;
constexpr std::size_t kParameterBytes = 16;
constexpr std::uint8_t kEntityStateType = 1;
constexpr std::uint8_t kArticulatedPart = 0;

double bigEndian(ByteView pdu, std::size_t at, NumberType type) {
  Field field;
  field.type = type;
  field.little_endian = false;
  return numberIn(field, pdu.subspan(at, bytesOf(type)));
}

std::size_t wholeBigEndian(ByteView pdu, std::size_t at, std::size_t bytes) {
  std::size_t whole = 0;
  for (const std::byte each : pdu.subspan(at, bytes)) {
    whole = (whole << 8U) | std::to_integer<std::size_t>(each);
  }
  return whole;
}

/// Where a number lies in an Entity State PDU.
struct NumberPlace {
  std::size_t at;
  NumberType type;
};

NumberPlace disPlaceOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::version:
      return {0, NumberType::u8};
    case Quantity::exercise:
      return {1, NumberType::u8};
    case Quantity::site:
      return {12, NumberType::u16};
    case Quantity::application:
      return {14, NumberType::u16};
    case Quantity::entity:
      return {16, NumberType::u16};
    case Quantity::force:
      return {18, NumberType::u8};
    case Quantity::kind:
      return {20, NumberType::u8};
    case Quantity::domain:
      return {21, NumberType::u8};
    case Quantity::country:
      return {22, NumberType::u16};
    case Quantity::category:
      return {24, NumberType::u8};
    case Quantity::subcategory:
      return {25, NumberType::u8};
    case Quantity::specific:
      return {26, NumberType::u8};
    case Quantity::extra:
      return {27, NumberType::u8};
    case Quantity::velocity_x:
      return {36, NumberType::f32};
    case Quantity::velocity_y:
      return {40, NumberType::f32};
    case Quantity::velocity_z:
      return {44, NumberType::f32};
    case Quantity::location_x:
      return {48, NumberType::f64};
    case Quantity::location_y:
      return {56, NumberType::f64};
    case Quantity::location_z:
      return {64, NumberType::f64};
    case Quantity::psi:
      return {72, NumberType::f32};
    case Quantity::theta:
      return {76, NumberType::f32};
    case Quantity::phi:
      return {80, NumberType::f32};
    default:
      return {84, NumberType::u32};  // appearance
  }
}

double numberAt(ByteView pdu, Quantity quantity) {
  const NumberPlace place = disPlaceOf(quantity);
  return bigEndian(pdu, place.at, place.type);
}

/// Reads Entity State PDUs of DIS (IEEE 1278.1): the first PDU of a datagram. Big endian.
class DisReader final : public FieldReader {
 public:
  explicit DisReader(const Decoder& decoder) {
    if (decoder.origin) frame_.emplace(*decoder.origin);
    for (const Field& field : decoder.fields) {
      fields_.push_back(disFieldNamed(field.path).value_or(DisField()));
      any_local_ = any_local_ || fields_.back().isLocal();
    }
  }

  bool read(ByteView datagram, std::span<FieldValue> values) override {
    const std::optional<ByteView> pdu = entityState(datagram);
    if (!pdu) return false;
    Local local;
    if (any_local_ && frame_) local = localOf(*pdu);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const DisField& field = fields_[i];
      if (field.quantity == Quantity::marking) {
        values[i] = FieldValue::of(markingOf(*pdu));
      } else if (field.quantity == Quantity::articulation) {
        if (const auto number = articulation(*pdu, field.parameter_type)) {
          values[i] = FieldValue::of(*number);
        }
      } else if (!field.isLocal()) {
        values[i] = FieldValue::of(numberAt(*pdu, field.quantity));
      } else if (frame_) {
        const auto which =
            static_cast<std::size_t>(field.quantity) - static_cast<std::size_t>(Quantity::local_x);
        values[i] = FieldValue::of(local[which]);
      }
    }
    return true;
  }

  std::vector<FoundField> undeclared(ByteView datagram, std::size_t most) override {
    std::vector<FoundField> found;
    const std::optional<ByteView> pdu = entityState(datagram);
    for (std::size_t i = 0; pdu && i < parametersOf(*pdu) && found.size() < most; ++i) {
      const ByteView parameter = parameterAt(*pdu, i);
      if (!isArticulated(parameter)) continue;
      const std::uint32_t type = typeOf(parameter);
      bool declared = false;
      for (const DisField& field : fields_) {
        declared =
            declared || (field.quantity == Quantity::articulation && field.parameter_type == type);
      }
      if (declared) continue;
      found.push_back({articulationName(type), valueText(FieldValue::of(valueOf(parameter)))});
    }
    return found;
  }

 private:
  /// x y z qx qy qz qw.
  using Local = std::array<double, 7>;

  /// The first PDU of the datagram, whole.
  std::optional<ByteView> entityState(ByteView datagram) {
    if (datagram.size() < kEntityStateBytes) {
      refuse("it is shorter than an Entity State PDU");
      return std::nullopt;
    }
    if (std::to_integer<std::uint8_t>(datagram[2]) != kEntityStateType) {
      refuse("it is not an Entity State PDU");
      return std::nullopt;
    }
    const std::size_t length = wholeBigEndian(datagram, 8, 2);
    if (length < kEntityStateBytes || length > datagram.size()) {
      refuse("its length is not the one that it states");
      return std::nullopt;
    }
    const ByteView pdu = datagram.first(length);
    if (parametersOf(pdu) * kParameterBytes > length - kEntityStateBytes) {
      refuse("it ends before its articulation parameters");
      return std::nullopt;
    }
    return pdu;
  }

  static std::size_t parametersOf(ByteView pdu) { return std::to_integer<std::size_t>(pdu[19]); }
  static ByteView parameterAt(ByteView pdu, std::size_t index) {
    return pdu.subspan(kEntityStateBytes + index * kParameterBytes, kParameterBytes);
  }
  static bool isArticulated(ByteView parameter) {
    return std::to_integer<std::uint8_t>(parameter[0]) == kArticulatedPart;
  }
  static std::uint32_t typeOf(ByteView parameter) {
    return static_cast<std::uint32_t>(wholeBigEndian(parameter, 4, 4));
  }
  static double valueOf(ByteView parameter) { return bigEndian(parameter, 8, NumberType::f32); }

  static std::optional<double> articulation(ByteView pdu, std::uint32_t type) {
    for (std::size_t i = 0; i < parametersOf(pdu); ++i) {
      const ByteView parameter = parameterAt(pdu, i);
      if (isArticulated(parameter) && typeOf(parameter) == type) return valueOf(parameter);
    }
    return std::nullopt;
  }

  static std::string_view markingOf(ByteView pdu) {
    std::string_view text = textOf(pdu.subspan(129, 11));
    text = text.substr(0, text.find('\0'));
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
  }

  Local localOf(ByteView pdu) const {
    const Vec3 earth(numberAt(pdu, Quantity::location_x), numberAt(pdu, Quantity::location_y),
                     numberAt(pdu, Quantity::location_z));
    const Vec3 at = frame_->positionOf(earth);
    const Quat turn = frame_->orientationOf(
        numberAt(pdu, Quantity::psi), numberAt(pdu, Quantity::theta), numberAt(pdu, Quantity::phi));
    return {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w};
  }

  std::vector<DisField> fields_;
  std::optional<GeoFrame> frame_;
  bool any_local_ = false;
};

}  // namespace

std::unique_ptr<FieldReader> makeDisReader(const Decoder& decoder) {
  return std::make_unique<DisReader>(decoder);
}

}  // namespace rocinante::decode
