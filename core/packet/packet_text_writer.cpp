#include <algorithm>
#include <array>
#include <charconv>

#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"
#include "core/packet/text_name.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

void appendField(std::string& text, std::string_view name) {
  text += ' ';
  appendName(text, name);
}

void appendNumbers(std::string& text, std::span<const double> numbers) {
  for (const double number : numbers) {
    text += ' ';
    appendNumber(text, number);
  }
}

void appendCarrier(std::string& text, const PathView& carrier) {
  if (carrier.first.empty()) return;
  text += " in";
  appendField(text, carrier.first);
  text += '/';
  appendName(text, carrier.second);
}

void appendPath(std::string& text, const PathView& path) {
  if (path.is_layer) {
    text += " layer/";
    appendName(text, path.second);
    return;
  }
  if (path.second.empty()) return appendField(text, path.first);
  // A link of a device named "layer" must not read as a layer.
  text += path.first == "layer" ? " %6Cayer" : " ";
  if (path.first != "layer") appendName(text, path.first);
  text += '/';
  appendName(text, path.second);
}

void appendColor(std::string& text, std::uint32_t rgba) {
  text += " #";
  const bool opaque = (rgba & 0xFFU) == 0xFF;
  appendHex(text, opaque ? rgba >> 8U : rgba, opaque ? 6 : 8);
}

void appendDrawing(std::string& text, const Statement& statement) {
  appendField(text, statement.name);
  if (statement.part_count != 1) {
    text += ':';
    appendUnsigned(text, statement.part_index);
    text += '/';
    appendUnsigned(text, statement.part_count);
  }
  appendColor(text, statement.rgba);
  if (statement.size_px) {
    text += statement.kind == StatementKind::line ? " width=" : " size=";
    appendNumber(text, *statement.size_px);
  }
  appendCarrier(text, statement.carrier);
  appendNumbers(text, statement.numbers);
}

void appendView(std::string& text, const Statement& statement) {
  appendField(text, statement.name);
  appendNumbers(text, statement.numbers.first(7));
  const std::span<const double> up = statement.numbers.subspan(7);
  if (up[0] != 0 || up[1] != 0 || up[2] != 1) {
    text += " up";
    appendNumbers(text, up);
  }
  if (statement.ortho_height_m) {
    text += " ortho ";
    appendNumber(text, *statement.ortho_height_m);
  }
  appendCarrier(text, statement.carrier);
}

void appendSpaceAndString(std::string& text, std::string_view string) {
  text += ' ';
  appendString(text, string);
}

/// The digits of a double with sign, point and exponent, and a blank, `=` and "false", fit in.
constexpr std::size_t kValueRoom = 34;

/// isNameByte() where the compiler can inline it.
const std::array<bool, 256>& nameBytes() {
  static const std::array<bool, 256> kBytes = [] {
    std::array<bool, 256> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = isNameByte(static_cast<char>(i));
    return bytes;
  }();
  return kBytes;
}

/// Appends " NAME=NUMBER" of each, most of what a recording of a robot is: in place, where every
/// byte of the names stands for itself; else it appends nothing and returns false.
bool appendPlainValues(std::string& text, const Statement& statement) {
  const std::array<bool, 256>& is_plain = nameBytes();
  std::size_t room = 0;
  for (const std::string_view name : statement.names) room += name.size() + kValueRoom;
  const std::size_t begin = text.size();
  text.resize(begin + room);
  char* out = text.data() + begin;
  for (std::size_t i = 0; i < statement.names.size(); ++i) {
    *out++ = ' ';
    for (const char byte : statement.names[i]) {
      if (!is_plain[static_cast<unsigned char>(byte)]) {
        text.resize(begin);
        return false;
      }
      *out++ = byte;
    }
    *out++ = '=';
    const double number = statement.numbers[i];
    const bool is_number =
        statement.signal_kinds.empty() || statement.signal_kinds[i] == SignalKind::number;
    if (!is_number) {
      const std::string_view word = number != 0 ? "true" : "false";
      out = std::copy(word.begin(), word.end(), out);
    } else if (number == 0) {
      *out++ = '0';
    } else {
      out = std::to_chars(out, out + kValueRoom - 2, number).ptr;
    }
  }
  text.resize(static_cast<std::size_t>(out - text.data()));
  return true;
}

void appendSignal(std::string& text, const Statement& statement, std::size_t index) {
  switch (statement.signal_kinds[index]) {
    case SignalKind::number:
      return appendNumber(text, statement.numbers[index]);
    case SignalKind::boolean:
      text += statement.numbers[index] != 0 ? "true" : "false";
      return;
    case SignalKind::text:
      return appendString(text, statement.text);
  }
}

void appendSignals(std::string& text, const Statement& statement) {
  const PathView& path = statement.path;
  if (path.first.empty()) {
    text += " -";
  } else if (path.first == "-" && path.second.empty()) {
    text += " %2D";
  } else {
    appendPath(text, path);
  }
  if (statement.kind == StatementKind::signals) {
    if (appendPlainValues(text, statement)) return;
    for (std::size_t i = 0; i < statement.names.size(); ++i) {
      appendField(text, statement.names[i]);
      text += '=';
      appendSignal(text, statement, i);
    }
    return;
  }
  appendField(text, statement.names.front());
  text += ' ';
  if (statement.is_default) {
    text += "default";
    return;
  }
  appendSignal(text, statement, 0);
  if (!statement.unit.empty()) (text += ' ') += statement.unit;
}

void appendStatement(std::string& text, const Statement& statement) {
  text += nameOf(statement.kind);
  switch (statement.kind) {
    case StatementKind::joints:
      appendField(text, statement.name);
      if (statement.order_tag) {
        text += " @";
        appendHex(text, *statement.order_tag, 8);
      }
      appendNumbers(text, statement.numbers);
      break;
    case StatementKind::order:
      appendField(text, statement.name);
      for (const std::string_view joint : statement.names) appendField(text, joint);
      break;
    case StatementKind::joint:
      appendField(text, statement.name);
      if (appendPlainValues(text, statement)) break;
      for (std::size_t i = 0; i < statement.names.size(); ++i) {
        appendField(text, statement.names[i]);
        text += '=';
        appendNumber(text, statement.numbers[i]);
      }
      break;
    case StatementKind::pose:
      appendField(text, statement.name);
      appendNumbers(text, statement.numbers);
      appendCarrier(text, statement.carrier);
      break;
    case StatementKind::add:
      appendField(text, statement.name);
      appendField(text, statement.text);
      if (statement.kinematics) {
        text += " kin=";
        appendHex(text, *statement.kinematics, 16);
      }
      break;
    case StatementKind::remove:
      appendField(text, statement.name);
      break;
    case StatementKind::show:
      appendPath(text, statement.path);
      if (statement.is_default) text += " default";
      break;
    case StatementKind::hide:
      appendPath(text, statement.path);
      break;
    case StatementKind::color:
      appendPath(text, statement.path);
      if (statement.is_default) {
        text += " default";
      } else {
        appendColor(text, statement.rgba);
      }
      break;
    case StatementKind::line:
    case StatementKind::points:
      appendDrawing(text, statement);
      break;
    case StatementKind::label:
      appendField(text, statement.name);
      appendCarrier(text, statement.carrier);
      appendNumbers(text, statement.numbers);
      appendSpaceAndString(text, statement.text);
      break;
    case StatementKind::erase:
      if (statement.name.empty()) {
        text += " *";
      } else {
        appendField(text, statement.name);
      }
      break;
    case StatementKind::event:
      appendSpaceAndString(text, statement.text);
      break;
    case StatementKind::view:
      appendView(text, statement);
      break;
    case StatementKind::signal:
    case StatementKind::signals:
      appendSignals(text, statement);
      break;
    case StatementKind::seen:
      appendField(text, statement.name);
      text += ' ';
      appendUnsigned(text, static_cast<std::uint64_t>(statement.seen_ns));
      break;
  }
}

void appendHeader(std::string& text, const PacketHeader& header) {
  text += "RK1";
  appendField(text, header.source);
  if (!header.run.empty()) {
    text += '@';
    appendName(text, header.run);
  }
  text += ' ';
  if (header.sequence) {
    appendUnsigned(text, *header.sequence);
  } else {
    text += '-';
  }
  text += ' ';
  if (header.time_ns) {
    appendSeconds(text, *header.time_ns);
  } else {
    text += '-';
  }
  if (header.restated) text += " restated";
  if (header.part) {
    text += " part=";
    appendName(text, header.part->id);
    text += ':';
    appendUnsigned(text, header.part->index);
    text += '/';
    appendUnsigned(text, header.part->count);
  }
  if (!header.by.empty()) {
    text += " by=";
    appendName(text, header.by);
  }
  if (header.reset) text += " reset";
  if (header.via) {
    text += " via=";
    appendName(text, header.via->relay);
    text += ':';
    appendUnsigned(text, header.via->sequence);
  }
}

}  // namespace

void PacketTextWriter::begin(const PacketHeader& header) {
  text_.clear();
  appendHeader(text_, header);
  text_ += '\n';
  header_bytes_ = text_.size();
}

void PacketTextWriter::add(const Statement& statement) {
  appendStatement(text_, statement);
  text_ += '\n';
}

std::string headerText(const PacketHeader& header) {
  std::string text;
  appendHeader(text, header);
  return text;
}

std::string statementText(const Statement& statement) {
  std::string text;
  appendStatement(text, statement);
  return text;
}

}  // namespace rocinante
