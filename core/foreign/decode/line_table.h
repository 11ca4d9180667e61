#pragma once

#include "core/document/toml_table.h"
#include "core/foreign/decode/declaration.h"
#include "core/foreign/decode/field_table.h"

namespace rocinante::decode {

/// Reads what a decoder says with its fields: `[[decoder.joint]]`, `[[decoder.joints]]`,
/// `[[decoder.pose]]`, `[[decoder.signal]]`, `[[decoder.signals]]` and `[[decoder.event]]`.
class LineTable {
 public:
  LineTable(Decoder& decoder, FieldTable& fields, FaultList& faults)
      : decoder_(decoder), fields_(fields), faults_(faults) {}

  void read(TomlTable& decoder_table);

 private:
  struct Scale {
    double times = 1;
    double plus = 0;
  };
  void readJoint(TomlTable& table);
  void readJoints(TomlTable& table);
  void readPose(TomlTable& table);
  void readEuler(TomlTable& table, PoseLine& line);
  void readSignal(TomlTable& table);
  void readSignals(TomlTable& table);
  bool readPath(TomlTable& table, SignalLine& line);
  /// `scale`, `offset` and `unit`.
  void readNumber(TomlTable& table, SignalLine& line);
  void readBits(TomlTable& table, SignalLine& line);
  void readWords(TomlTable& table, SignalLine& line);
  void readEvent(TomlTable& table);
  void addJoint(const TextTemplate& device, std::string joint, Term value);
  Scale scaleOf(TomlTable& table);
  std::optional<std::vector<Term>> termsAt(TomlTable& table, std::string_view key,
                                           std::size_t count, double times);
  std::optional<TextTemplate> templateAt(TomlTable& table, std::string_view key);

  Decoder& decoder_;
  FieldTable& fields_;
  FaultList& faults_;
  std::size_t lines_ = 0;
};

}  // namespace rocinante::decode
