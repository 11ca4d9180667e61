#include "core/packet/header_reader.h"

#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

constexpr std::string_view kVersionWord = "RK1";

bool readSource(std::string_view field, TextArena& arena, PacketHeader& header) {
  const std::size_t at_sign = field.find('@');
  const auto source = decodeName(field.substr(0, at_sign), arena);
  if (!source) return false;
  header.source = *source;
  if (at_sign == std::string_view::npos) return true;
  const auto run = decodeName(field.substr(at_sign + 1), arena);
  if (!run) return false;
  header.run = *run;
  return true;
}

bool readSequence(std::string_view field, PacketHeader& header) {
  if (field == "-") return true;
  header.sequence = readUnsigned(field);
  return header.sequence.has_value();
}

bool readTime(std::string_view field, PacketHeader& header) {
  if (field == "-") return true;
  header.time_ns = readSeconds(field);
  return header.time_ns.has_value();
}

/// Splits NAME:REST at the last colon, because a name may contain colons.
bool splitAtLastColon(std::string_view value, TextArena& arena, std::string_view& name,
                      std::string_view& rest) {
  const std::size_t colon = value.rfind(':');
  if (colon == std::string_view::npos) return false;
  const auto decoded = decodeName(value.substr(0, colon), arena);
  if (!decoded) return false;
  name = *decoded;
  rest = value.substr(colon + 1);
  return true;
}

bool readPart(std::string_view value, TextArena& arena, PacketHeader& header) {
  if (header.part) return false;
  RestatementPart part;
  std::string_view numbers;
  if (!splitAtLastColon(value, arena, part.id, numbers)) return false;
  const std::size_t slash = numbers.find('/');
  if (slash == std::string_view::npos) return false;
  const auto index = readUnsigned(numbers.substr(0, slash));
  const auto count = readUnsigned(numbers.substr(slash + 1));
  if (!index || !count || *index == 0 || *index > *count) return false;
  if (*count > limits::kRestatementParts) return false;
  part.index = static_cast<std::uint32_t>(*index);
  part.count = static_cast<std::uint32_t>(*count);
  header.part = part;
  return true;
}

bool readBy(std::string_view value, TextArena& arena, PacketHeader& header) {
  const auto name = decodeName(value, arena);
  if (!name || !header.by.empty()) return false;
  header.by = *name;
  return true;
}

bool readVia(std::string_view value, TextArena& arena, PacketHeader& header) {
  if (header.via) return false;
  Via via;
  std::string_view number;
  if (!splitAtLastColon(value, arena, via.relay, number)) return false;
  const auto sequence = readUnsigned(number);
  if (!sequence) return false;
  via.sequence = *sequence;
  header.via = via;
  return true;
}

bool readFlag(std::string_view rest, bool& flag) {
  if (!rest.empty() || flag) return false;
  flag = true;
  return true;
}

/// Resets field by field: assigning a new header costs as much as reading the line.
void clear(PacketHeader& header) {
  header.run = {};
  header.sequence.reset();
  header.time_ns.reset();
  header.restated = false;
  header.reset = false;
  header.part.reset();
  header.by = {};
  header.via.reset();
}

/// Reads a word of this version, or skips an unknown one.
bool readWord(std::string_view field, TextArena& arena, PacketHeader& header) {
  const std::size_t equals = field.find('=');
  const std::string_view word = field.substr(0, equals);
  const bool has_value = equals != std::string_view::npos;
  const std::string_view value = has_value ? field.substr(equals + 1) : std::string_view();
  if (word == "restated") return !has_value && readFlag(value, header.restated);
  if (word == "reset") return !has_value && readFlag(value, header.reset);
  if (word == "part") return readPart(value, arena, header);
  if (word == "by") return readBy(value, arena, header);
  if (word == "via") return readVia(value, arena, header);
  return true;
}

}  // namespace

bool isHeaderLine(std::string_view line) {
  TextFields fields(line);
  return !fields.atEnd() && fields.takeWord(kVersionWord);
}

bool readHeader(std::string_view line, TextArena& arena, PacketHeader& header,
                std::uint32_t& column) {
  TextFields fields(line);
  fields.take();
  clear(header);
  const auto malformed = [&](std::string_view field) {
    column = fields.columnOf(field.empty() ? fields.end() : field.data());
    return false;
  };
  const std::string_view source = fields.take();
  if (!readSource(source, arena, header)) return malformed(source);
  const std::string_view sequence = fields.take();
  if (!readSequence(sequence, header)) return malformed(sequence);
  const std::string_view time = fields.take();
  if (!readTime(time, header)) return malformed(time);
  while (!fields.atEnd()) {
    const std::string_view word = fields.take();
    if (!readWord(word, arena, header)) return malformed(word);
  }
  return true;
}

}  // namespace rocinante
