#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rocinante {

/// "1.2 MB": decimal units, one decimal.
std::string sizeText(std::uint64_t bytes);

/// "100MB", "64MiB", "1.5GB", "4096", "4096B": decimal units (kB MB GB TB) and binary ones (KiB MiB
/// GiB TiB), upper or lower case, a space before the unit allowed. At most six decimals; a part of
/// a byte is cut off. bad_argument for anything else, and from 2^63 on.
Result<std::uint64_t> parseSize(std::string_view text);

/// "1 frame", "2000 frames". cli::counted() groups the digits, for tables and summaries.
std::string countText(std::uint64_t number, std::string_view one);

/// An angle for people: "23.6°", six significant digits. Files and JSON keep radians.
std::string angleText(double radians);

}  // namespace rocinante
