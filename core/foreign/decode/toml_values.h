#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/document/toml_table.h"

namespace rocinante::decode {

inline constexpr const char* kBadValue = "decoder.bad-value";

/// A whole number within [least, most]; a fault for any other value.
std::optional<std::int64_t> wholeAt(TomlTable& table, std::string_view key, std::int64_t least,
                                    std::int64_t most);
std::optional<std::int64_t> wholeOf(const TomlNode& node, std::string_view key, std::int64_t least,
                                    std::int64_t most, FaultList& faults);
/// One text, or an array of them.
std::vector<std::string> oneOrMoreTexts(TomlTable& table, std::string_view key);
/// "fd 00 1e" as bytes.
Bytes hexBytes(TomlTable& table, std::string_view key);
/// "little" or "big"; `otherwise` without the key.
bool isLittleEndian(TomlTable& table, bool otherwise);
/// The index of the key's text in `choices`; a fault that lists them for any other text.
std::optional<std::size_t> choiceAt(TomlTable& table, std::string_view key,
                                    const std::vector<std::string_view>& choices);

}  // namespace rocinante::decode
