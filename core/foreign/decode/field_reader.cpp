#include "core/foreign/decode/field_reader.h"

#include <cmath>

#include "core/packet/text_number.h"

namespace rocinante::decode {

FieldValue FieldValue::of(double number) {
  if (!std::isfinite(number)) return {Kind::missing, 0, {}, true};
  return {Kind::number, number, {}};
}

std::optional<double> FieldValue::asNumber() const {
  if (kind == Kind::number) return number;
  if (kind == Kind::missing) return std::nullopt;
  const char* at = text.data();
  const char* const end = at + text.size();
  double read = 0;
  if (!readNumber(at, end, read) || at != end) return std::nullopt;
  return read;
}

std::vector<FoundField> FieldReader::undeclared(ByteView, std::size_t) { return {}; }

std::unique_ptr<FieldReader> makeFieldReader(const Decoder& decoder) {
  switch (decoder.kind) {
    case Kind::structure:
      return makeStructReader(decoder);
    case Kind::delimited:
      return makeDelimitedReader(decoder);
    case Kind::json:
      return makeJsonReader(decoder);
    case Kind::xml:
      return makeXmlReader(decoder);
    case Kind::dis:
      return makeDisReader(decoder);
    case Kind::protobuf:
      return makeProtobufReader(decoder);
  }
  return nullptr;
}

}  // namespace rocinante::decode
