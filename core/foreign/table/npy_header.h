#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rocinante {

/// The largest header that is written: more columns than that are refused.
inline constexpr std::size_t kMaxNpyHeaderBytes = std::size_t{64} << 20;

/// `text` as a Python string literal.
std::string pythonText(std::string_view text);

/// The beginning of a .npy file (NEP 1): magic, version, and the dictionary for a C-ordered array
/// of one dimension. `descr` is a Python expression, "'<f8'" or a list of fields. Its length
/// depends only on `descr`, not on `rows`, and is a multiple of 64: so the row count can be filled
/// in later. Names that are not ASCII need version 3.0, which is UTF-8.
std::string npyHeader(std::string_view descr, std::uint64_t rows);

}  // namespace rocinante
