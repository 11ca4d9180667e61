#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/document/toml_table.h"
#include "core/foreign/decode/declaration.h"

namespace rocinante::decode {

/// Reads `[[decoder.field]]` tables, and finds fields by the names that lines use.
class FieldTable {
 public:
  FieldTable(Decoder& decoder, FaultList& faults) : decoder_(decoder), faults_(faults) {}

  void read(TomlTable& decoder_table, bool little_endian);
  /// The index of a field, which counts as used from now on; a fault, with the likely name, for an
  /// unknown one.
  std::optional<std::size_t> find(std::string_view name, Place place);

 private:
  void readField(TomlTable& table, bool little_endian);
  void checkDis(TomlTable& table, const std::string& path);
  void checkProtobuf(TomlTable& table, const std::string& path);
  void readStruct(TomlTable& table, Field& field, bool little_endian);
  void add(Field field, std::size_t count, std::size_t step, const std::string& elements_of);

  Decoder& decoder_;
  FaultList& faults_;
};

}  // namespace rocinante::decode
