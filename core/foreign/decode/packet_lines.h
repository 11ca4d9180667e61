#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/foreign/decode/declaration.h"
#include "core/foreign/decode/field_reader.h"
#include "core/packet/packet_text.h"

namespace rocinante::decode {

/// Writes the packet text that a decoder's lines make of field values. Holds scratch memory.
class PacketLines {
 public:
  /// The decoder must outlive it.
  explicit PacketLines(const Decoder& decoder);

  /// Adds the statements. A joint, pose, signal or event whose fields are missing is left out.
  /// `before` are the values of the EventLine::changes fields in the sender's last datagram, as
  /// valueText(): empty at its first.
  void add(PacketTextWriter& packet, std::span<const FieldValue> values,
           std::span<const std::string> before);

  /// By field: how often a line needed another value than it had: not a number, or infinite; text
  /// in place of a number; too long a text. Once a datagram.
  const std::vector<std::uint64_t>& unusable() const { return unusable_; }
  /// Of the last add(): the fields that a line needed and that are NaN or infinite, each once.
  const std::vector<std::size_t>& notFinite() const { return not_finite_; }
  /// By field: how often its value made no name that packets have, and a line stated nothing. Once
  /// a datagram.
  const std::vector<std::uint64_t>& noName() const { return no_name_; }
  /// Of the quaternions of a PoseLine.
  struct Rotations {
    std::uint64_t off_unit = 0;  ///< off unit length, and normalised
    double first_length = 0;     ///< of the first of these
    std::uint64_t zero = 0;      ///< no rotation: no pose was stated
  };
  /// By PoseLine.
  const std::vector<Rotations>& rotations() const { return rotations_; }
  /// By SignalLine: values that its `values` do not name.
  const std::vector<std::uint64_t>& unnamed() const { return unnamed_; }

 private:
  void addJoints(PacketTextWriter& packet, const JointsLine& line,
                 std::span<const FieldValue> values);
  void addPose(PacketTextWriter& packet, std::size_t line, std::span<const FieldValue> values);
  void addSignal(PacketTextWriter& packet, std::size_t line, std::span<const FieldValue> values);
  /// Into name_; false, and counted, for what is no name.
  bool fillName(const TextTemplate& name, std::span<const FieldValue> values);
  /// Into path_, which `path` borrows.
  bool fillPath(PathView& path, const TextTemplate& of, std::span<const FieldValue> values);
  /// numberOf(), which counts a value that is none.
  std::optional<double> numberOrCount(const Term& term, std::span<const FieldValue> values);
  template <std::size_t count>
  std::optional<std::array<double, count>> numbersOf(const std::array<Term, count>& terms,
                                                     std::span<const FieldValue> values);
  void countUnusable(std::size_t field, const FieldValue& value);
  /// Its fields; where one is missing, those alone that are infinite.
  void countNoName(const TextTemplate& name, std::span<const FieldValue> values);

  const Decoder& decoder_;
  std::string name_;
  std::vector<std::string_view> joints_;
  std::vector<double> numbers_;
  std::string path_;
  std::string text_;
  std::uint64_t datagrams_ = 0;
  std::vector<std::uint64_t> unusable_, counted_at_;  ///< by field; at which datagram the last one
  std::vector<std::uint64_t> no_name_, named_at_;     ///< the same
  std::vector<std::uint64_t> unnamed_;
  std::vector<Rotations> rotations_;
  std::vector<std::size_t> not_finite_;
};

/// A value as people read it; "" for a missing one.
std::string valueText(const FieldValue& value);

/// Appends the template with its values; false when one is missing.
bool appendTemplate(std::string& text, const TextTemplate& of, std::span<const FieldValue> values);

/// The number of a term; empty when its field is missing or the result is not finite.
std::optional<double> numberOf(const Term& term, std::span<const FieldValue> values);

}  // namespace rocinante::decode
