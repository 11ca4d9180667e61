#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/foreign/decode/declaration.h"

namespace rocinante::decode {

/// What a datagram says for a field. A number has no text, a text may be a number too.
struct FieldValue {
  enum class Kind : std::uint8_t { missing, number, text };
  Kind kind = Kind::missing;
  double number = 0;         ///< finite
  std::string_view text{};   ///< borrowed from the datagram or the reader, until its next read()
  bool is_infinite = false;  ///< missing because it is not a number, or infinite

  static FieldValue of(double number);
  static FieldValue of(std::string_view text) { return {Kind::text, 0, text}; }
  /// The number, or the one that the text spells; empty for anything else.
  std::optional<double> asNumber() const;
};

/// A field that a datagram has, declared or not, for people who write a declaration.
struct FoundField {
  std::string name;  ///< as a declaration would point to it
  std::string value;
};

/// Reads the declared fields of one kind of datagram. Bounded by the size of the datagram whatever
/// its bytes are. Holds scratch memory: one per thread.
class FieldReader {
 public:
  virtual ~FieldReader() = default;

  /// Fills one value per declared field. False, with a reason that lives as long as the program,
  /// when the datagram is not of the declared form.
  virtual bool read(ByteView datagram, std::span<FieldValue> values) = 0;
  std::string_view reason() const { return reason_; }

  /// The fields of the datagram that no declaration points to; at most `most`. Kinds whose bytes do
  /// not name their fields find none.
  virtual std::vector<FoundField> undeclared(ByteView datagram, std::size_t most);

 protected:
  bool refuse(std::string_view reason) {
    reason_ = reason;
    return false;
  }

 private:
  std::string_view reason_;
};

/// The reader of a decoder's fields. The decoder must outlive it.
std::unique_ptr<FieldReader> makeFieldReader(const Decoder& decoder);

std::unique_ptr<FieldReader> makeStructReader(const Decoder& decoder);
std::unique_ptr<FieldReader> makeDelimitedReader(const Decoder& decoder);
std::unique_ptr<FieldReader> makeJsonReader(const Decoder& decoder);
std::unique_ptr<FieldReader> makeXmlReader(const Decoder& decoder);
std::unique_ptr<FieldReader> makeDisReader(const Decoder& decoder);
std::unique_ptr<FieldReader> makeProtobufReader(const Decoder& decoder);

}  // namespace rocinante::decode
