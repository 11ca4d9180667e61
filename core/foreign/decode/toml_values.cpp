#include "core/foreign/decode/toml_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/hex_digit.h"
#include "core/base/name_hint.h"

namespace rocinante::decode {

std::optional<std::int64_t> wholeOf(const TomlNode& node, std::string_view key, std::int64_t least,
                                    std::int64_t most, FaultList& faults) {
  if (node.kind == TomlNode::Kind::integer && node.integer >= least && node.integer <= most) {
    return node.integer;
  }
  faults.error(kBadValue, node.place,
               fmt::format("`{}` must be a whole number from {} to {}", key, least, most));
  return std::nullopt;
}

std::optional<std::int64_t> wholeAt(TomlTable& table, std::string_view key, std::int64_t least,
                                    std::int64_t most) {
  const TomlNode* const node = table.node(key);
  if (node == nullptr) return std::nullopt;
  return wholeOf(*node, key, least, most, table.faults());
}

std::vector<std::string> oneOrMoreTexts(TomlTable& table, std::string_view key) {
  const TomlNode* const node = table.node(key);
  if (node == nullptr) return {};
  if (node->kind == TomlNode::Kind::text) return {node->text};
  return table.texts(key);
}

Bytes hexBytes(TomlTable& table, std::string_view key) {
  Bytes bytes;
  const std::optional<std::string> text = table.text(key);
  if (!text) return bytes;
  int high = -1;
  for (const char each : *text) {
    if (each == ' ') continue;
    const int digit = hexDigit(each);
    if (digit < 0) {
      table.error(kBadValue, key, fmt::format("`{}` is not bytes in hexadecimal", key),
                  "write two digits for each byte, as in \"fd 1e 00\"");
      return {};
    }
    if (high < 0) {
      high = digit;
    } else {
      bytes.push_back(static_cast<std::byte>(high * 16 + digit));
      high = -1;
    }
  }
  if (high >= 0) table.error(kBadValue, key, fmt::format("`{}` ends within a byte", key));
  return bytes;
}

bool isLittleEndian(TomlTable& table, bool otherwise) {
  const auto choice = choiceAt(table, "byte_order", {"little", "big"});
  return choice ? *choice == 0 : otherwise;
}

std::optional<std::size_t> choiceAt(TomlTable& table, std::string_view key,
                                    const std::vector<std::string_view>& choices) {
  const std::optional<std::string> text = table.text(key);
  if (!text) return std::nullopt;
  const auto found = std::ranges::find(choices, *text);
  if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  table.error(kBadValue, key, fmt::format("{} is not a `{}`", quotedInFault(*text), key),
              whatThereIs(*text, choices));
  return std::nullopt;
}

}  // namespace rocinante::decode
