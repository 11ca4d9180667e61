#include "core/packet/channel_names.h"

#include <algorithm>
#include <span>

#include "core/base/bytes.h"
#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

constexpr const char* kPath = "rocinante.path";
constexpr const char* kName = "rocinante.name";
constexpr const char* kUnit = "rocinante.unit";
constexpr std::string_view kHeader = "RK1 s 0 -\n";
/// Each byte of a name may be written as three; a path has two names.
constexpr std::size_t kWordBytes = 6 * limits::kNameBytes + 1;

bool isWord(std::string_view text) {
  return !text.empty() && text.size() <= kWordBytes &&
         std::ranges::all_of(text, [](char byte) { return byte > ' ' && byte != '\x7F'; });
}

std::string_view valueOf(const ChannelMetadata& metadata, const char* key) {
  const auto found = metadata.find(key);
  return found == metadata.end() ? std::string_view() : std::string_view(found->second);
}

}  // namespace

ChannelMetadata channelMetadata(const ChannelNames& names) {
  const std::string_view name = names.signal.empty() ? "x" : std::string_view(names.signal);
  const double number = 1;
  const SignalKind kind = SignalKind::number;
  Statement statement;
  statement.kind = StatementKind::signal;
  statement.path = {names.device, names.link, false};
  statement.names = std::span(&name, 1);
  statement.numbers = std::span(&number, 1);
  statement.signal_kinds = std::span(&kind, 1);
  PacketHeader header;
  header.source = "s";
  PacketTextWriter writer(header);
  writer.add(statement);
  // "signal PATH NAME 1"
  std::string_view rest = writer.text();
  rest.remove_prefix(rest.find("\nsignal ") + std::string_view("\nsignal ").size());
  ChannelMetadata metadata;
  const std::size_t blank = rest.find(' ');
  metadata[kPath] = rest.substr(0, blank);
  if (names.signal.empty()) return metadata;
  rest.remove_prefix(blank + 1);
  metadata[kName] = rest.substr(0, rest.find(' '));
  if (!names.unit.empty()) metadata[kUnit] = names.unit;
  return metadata;
}

bool hasChannelNames(const ChannelMetadata& metadata) { return metadata.contains(kPath); }

std::optional<ChannelNames> channelNamesIn(const ChannelMetadata& metadata) {
  const std::string_view path = valueOf(metadata, kPath), name = valueOf(metadata, kName);
  const std::string_view unit = valueOf(metadata, kUnit);
  const bool is_signal = metadata.contains(kName);
  if (!isWord(path) || (is_signal && !isWord(name)) || (!unit.empty() && !isWord(unit))) {
    return std::nullopt;
  }
  // What packets may say is decided where they are read.
  std::string text(kHeader);
  text.append("signal ").append(path).append(" ").append(is_signal ? name : "x").append(" 1");
  if (!unit.empty()) text.append(" ").append(unit);
  text.append("\n");
  PacketTextDecoder decoder;
  // It points into the text.
  const Packet* const packet = decoder.decode(bytesOf(text));
  if (packet == nullptr || !packet->faults.empty() || packet->statements.size() != 1) {
    return std::nullopt;
  }
  const Statement& statement = packet->statements.front();
  if (statement.kind != StatementKind::signal || statement.names.size() != 1) return std::nullopt;
  ChannelNames names{std::string(statement.path.first), std::string(statement.path.second), {}, {}};
  if (is_signal) {
    names.signal = statement.names.front();
    names.unit = statement.unit;
  } else if (names.device.empty() || !names.link.empty()) {
    return std::nullopt;
  }
  return names;
}

}  // namespace rocinante
