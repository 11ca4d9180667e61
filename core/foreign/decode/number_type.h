#pragma once

#include <optional>
#include <string_view>

#include "core/foreign/decode/declaration.h"

namespace rocinante::decode {

/// "f64", "u16", "text"; empty for another name.
std::optional<NumberType> numberTypeNamed(std::string_view name);
/// 1 to 8; 0 for text.
std::size_t bytesOf(NumberType type);
bool isWhole(NumberType type);
bool isSigned(NumberType type);

/// The number of a field of `structure`; `bytes` are as many as its type has. May be NaN.
double numberIn(const Field& field, ByteView bytes);

}  // namespace rocinante::decode
