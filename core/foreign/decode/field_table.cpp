#include "core/foreign/decode/field_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/name_hint.h"
#include "core/base/plain_text.h"
#include "core/foreign/decode/dis_field.h"
#include "core/foreign/decode/number_type.h"
#include "core/foreign/decode/toml_values.h"
#include "core/foreign/protobuf/protobuf_schema.h"

namespace rocinante::decode {
namespace {

constexpr std::int64_t kMaxOffset = std::int64_t{1} << 20U;
constexpr std::int64_t kMaxCount = 1024;

bool isPointer(std::string_view path) {
  if (!path.starts_with('/')) return false;
  for (std::size_t at = path.find('~'); at != path.npos; at = path.find('~', at + 1)) {
    if (at + 1 >= path.size() || (path[at + 1] != '0' && path[at + 1] != '1')) return false;
  }
  return true;
}

bool isXmlPath(std::string_view path) {
  return !path.empty() && !path.starts_with('/') && !path.ends_with('/') && !path.ends_with('@') &&
         path.find("//") == path.npos && std::ranges::count(path, '@') <= 1 &&
         path.find("/@") == path.npos;
}

}  // namespace

void FieldTable::read(TomlTable& decoder_table, bool little_endian) {
  for (TomlTable& table : decoder_table.tables("field", "[[decoder.field]]")) {
    if (decoder_.fields.size() >= kMaxFields) {
      table.error(kBadValue, "name", fmt::format("a decoder has at most {} fields", kMaxFields));
      return;
    }
    readField(table, little_endian);
    table.finish();
  }
}

void FieldTable::readField(TomlTable& table, bool little_endian) {
  Field field;
  const std::optional<std::string> name = table.requiredText("name");
  field.name = name.value_or("");
  field.place = table.place();
  std::size_t count = 1;
  std::size_t step = 0;
  std::string elements_of;  // of protobuf: the repeated field
  switch (decoder_.kind) {
    case Kind::structure: {
      readStruct(table, field, little_endian);
      const std::size_t own_bytes =
          field.type == NumberType::text ? field.text_bytes : bytesOf(field.type);
      if (const auto many = wholeAt(table, "count", 1, kMaxCount)) {
        count = static_cast<std::size_t>(*many);
      }
      step = own_bytes;
      if (const auto apart = wholeAt(table, "step", 1, kMaxOffset)) {
        step = static_cast<std::size_t>(*apart);
      }
      break;
    }
    case Kind::delimited:
      if (const auto column = wholeAt(table, "column", 0, kMaxOffset)) {
        field.column = static_cast<std::size_t>(*column);
      } else if (!table.has("column")) {
        table.error("decoder.missing-key", "name", "a field of delimited text needs `column`",
                    "columns count from 0");
      }
      break;
    default:
      field.path = table.requiredText("at").value_or("");
      if (decoder_.kind == Kind::json && !field.path.empty() && !isPointer(field.path)) {
        table.error(kBadValue, "at", quotedInFault(field.path) + " is not a JSON pointer",
                    "one looks like \"/joints/0/position\"");
      }
      if (decoder_.kind == Kind::xml && !field.path.empty() && !isXmlPath(field.path)) {
        table.error(kBadValue, "at", quotedInFault(field.path) + " is not a path in XML",
                    "one looks like \"AIPos@A1\" or \"Pose/X\", below the root element");
      }
      if (decoder_.kind == Kind::dis && !field.path.empty()) checkDis(table, field.path);
      if (decoder_.kind != Kind::protobuf) break;
      if (const auto many = wholeAt(table, "count", 1, kMaxCount)) {
        count = static_cast<std::size_t>(*many);
        elements_of = std::exchange(field.path, field.path + "[0]");
      }
      if (!field.path.empty() && decoder_.schema) checkProtobuf(table, field.path);
  }
  if (name) add(std::move(field), count, step, elements_of);
}

void FieldTable::checkDis(TomlTable& table, const std::string& path) {
  const std::optional<DisField> known = disFieldNamed(path);
  if (!known) {
    table.error(kBadValue, "at", quotedInFault(path) + " is not a field of an Entity State PDU",
                "one looks like \"location.x\" or \"primary-turret-1.azimuth\"");
  } else if (known->isLocal() && !decoder_.origin) {
    table.error("decoder.missing-key", "at",
                fmt::format("decoder {} needs `origin` for {}", quotedInFault(decoder_.name),
                            quotedInFault(path)),
                "origin = { latitude = 48.1, longitude = 11.6, height = 520 }");
  }
}

void FieldTable::checkProtobuf(TomlTable& table, const std::string& path) {
  const Status found = decoder_.schema->find(path);
  if (!found) {
    table.error(kBadValue, "at",
                quotedInFault(path) + " leads to no value: " + plainText(found.error().what));
  }
}

void FieldTable::readStruct(TomlTable& table, Field& field, bool little_endian) {
  field.little_endian = isLittleEndian(table, little_endian);
  if (const auto at = wholeAt(table, "at", 0, kMaxOffset)) {
    field.at = static_cast<std::size_t>(*at);
  } else if (!table.has("at")) {
    table.error("decoder.missing-key", "name", "a field of a struct needs `at`, its first byte");
  }
  const std::optional<std::string> type = table.requiredText("type");
  if (type) {
    const std::optional<NumberType> known = numberTypeNamed(*type);
    if (!known) {
      table.error(kBadValue, "type", quotedInFault(*type) + " is not a type",
                  "u8 i8 u16 i16 u24 i24 u32 i32 u64 i64 f32 f64 text");
    }
    field.type = known.value_or(NumberType::u8);
  }
  if (field.type == NumberType::text) {
    if (const auto bytes = wholeAt(table, "bytes", 1, 255)) {
      field.text_bytes = static_cast<std::size_t>(*bytes);
    } else if (!table.has("bytes")) {
      table.error("decoder.missing-key", "type", "a field of text needs `bytes`, its length");
    }
  }
  const TomlNode* const bits = table.node("bits");
  if (bits == nullptr) return;
  const auto width = static_cast<std::int64_t>(bytesOf(field.type) * 8);
  if (!isWhole(field.type) || bits->kind != TomlNode::Kind::array || bits->items.size() != 2) {
    table.error(kBadValue, "bits", "`bits` is [first, how many] of a whole number",
                "bit 0 is the least significant");
    return;
  }
  const auto first = wholeOf(bits->items[0], "bits", 0, width - 1, faults_);
  if (!first) return;
  const auto many = wholeOf(bits->items[1], "bits", 1, width - *first, faults_);
  if (!many) return;
  field.first_bit = static_cast<unsigned>(*first);
  field.bits = static_cast<unsigned>(*many);
}

/// Several become NAME[0], NAME[1] and so on.
void FieldTable::add(Field field, std::size_t count, std::size_t step,
                     const std::string& elements_of) {
  const std::string name = field.name;
  for (std::size_t i = 0; i < count && decoder_.fields.size() < kMaxFields; ++i) {
    if (count > 1) field.name = fmt::format("{}[{}]", name, i);
    if (!elements_of.empty()) field.path = fmt::format("{}[{}]", elements_of, i);
    if (std::ranges::find(decoder_.fields, field.name, &Field::name) != decoder_.fields.end()) {
      faults_.error("decoder.same-name", field.place,
                    fmt::format("a second field {}", quotedInFault(field.name)));
      return;
    }
    decoder_.fields.push_back(field);
    field.at += step;
  }
}

std::optional<std::size_t> FieldTable::find(std::string_view name, Place place) {
  const auto found = std::ranges::find(decoder_.fields, name, &Field::name);
  if (found != decoder_.fields.end()) {
    found->used = true;
    return static_cast<std::size_t>(found - decoder_.fields.begin());
  }
  std::vector<std::string_view> known;
  for (const Field& field : decoder_.fields) known.push_back(field.name);
  faults_.error(
      "decoder.unknown-field", place,
      fmt::format("decoder {} has no field {}", quotedInFault(decoder_.name), quotedInFault(name)),
      faults_.lists("decoder.unknown-field") ? whatThereIs(name, known) : "");
  return std::nullopt;
}

}  // namespace rocinante::decode
