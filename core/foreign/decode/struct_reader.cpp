#include <array>

#include "core/foreign/decode/checksum.h"
#include "core/foreign/decode/field_reader.h"
#include "core/foreign/decode/number_type.h"

namespace rocinante::decode {
namespace {

class StructReader final : public FieldReader {
 public:
  explicit StructReader(const Decoder& decoder) : decoder_(decoder) {}

  bool read(ByteView datagram, std::span<FieldValue> values) override {
    ByteView body = datagram;
    if (decoder_.checksum) {
      if (!checksumHolds(*decoder_.checksum, datagram)) return refuse("its checksum is wrong");
      if (decoder_.zero_filled) {
        body = datagram.first(*positionIn(decoder_.checksum->at, datagram.size()));
      }
    }
    for (std::size_t i = 0; i < decoder_.fields.size(); ++i) {
      const Field& field = decoder_.fields[i];
      const std::size_t bytes = bytesOfField(field);
      if (field.at <= body.size() && bytes <= body.size() - field.at) {
        values[i] = valueOf(field, body.subspan(field.at, bytes));
      } else if (!decoder_.zero_filled) {
        return refuse("it ends before a field");
      } else {
        values[i] = filledValue(field, body);
      }
    }
    return true;
  }

 private:
  static std::size_t bytesOfField(const Field& field) {
    return field.type == NumberType::text ? field.text_bytes : bytesOf(field.type);
  }

  static FieldValue valueOf(const Field& field, ByteView bytes) {
    if (field.type == NumberType::text) {
      std::string_view text = textOf(bytes);
      text = text.substr(0, text.find('\0'));
      while (text.ends_with(' ')) text.remove_suffix(1);
      return FieldValue::of(text);
    }
    return FieldValue::of(numberIn(field, bytes));
  }

  /// A sender may leave out the zeros at the end of the body.
  static FieldValue filledValue(const Field& field, ByteView body) {
    if (field.type == NumberType::text) return FieldValue::of(std::string_view());
    std::array<std::byte, 8> whole{};
    const std::size_t bytes = bytesOf(field.type);
    for (std::size_t i = 0; i < bytes && field.at + i < body.size(); ++i) {
      whole[i] = body[field.at + i];
    }
    return FieldValue::of(numberIn(field, ByteView(whole).first(bytes)));
  }

  const Decoder& decoder_;
};

}  // namespace

std::unique_ptr<FieldReader> makeStructReader(const Decoder& decoder) {
  return std::make_unique<StructReader>(decoder);
}

}  // namespace rocinante::decode
