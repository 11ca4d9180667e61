#pragma once

#include <span>
#include <string>

#include "core/foreign/decode/declaration.h"
#include "core/foreign/decode/field_reader.h"

namespace rocinante::decode {

/// Writes the packet text that a decoder's lines make of field values. Holds scratch memory.
class PacketLines {
 public:
  /// The decoder must outlive it.
  explicit PacketLines(const Decoder& decoder) : decoder_(decoder) {}

  /// Appends the statement lines, each with LF before it. A joint, pose or event whose fields are
  /// missing is left out. `before` are the values of the EventLine::changes fields in the sender's
  /// last datagram, as valueText(): empty at its first. False when no line could be written.
  bool append(std::string& text, std::span<const FieldValue> values,
              std::span<const std::string> before);

 private:
  bool appendJoints(std::string& text, const JointsLine& line, std::span<const FieldValue> values);
  bool appendPose(std::string& text, const PoseLine& line, std::span<const FieldValue> values);
  bool fillName(const TextTemplate& name, std::span<const FieldValue> values);

  const Decoder& decoder_;
  std::string name_;
};

/// A value as people read it; "" for a missing one.
std::string valueText(const FieldValue& value);

/// Appends the template with its values; false when one is missing.
bool appendTemplate(std::string& text, const TextTemplate& of, std::span<const FieldValue> values);

/// The number of a term; empty when its field is missing or the result is not finite.
std::optional<double> numberOf(const Term& term, std::span<const FieldValue> values);

}  // namespace rocinante::decode
