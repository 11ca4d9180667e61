#include "viewer/serve/byte_range.h"

#include <algorithm>
#include <charconv>

namespace rocinante {
namespace {

std::optional<std::uint64_t> numberOf(std::string_view text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, fault] = std::from_chars(text.data(), end, number);
  if (text.empty() || fault != std::errc() || at != end) return {};
  return number;
}

}  // namespace

std::optional<ByteRange> parseByteRange(std::string_view header, std::uint64_t size) {
  constexpr std::string_view kUnit = "bytes=";
  if (!header.starts_with(kUnit)) return {};
  header.remove_prefix(kUnit.size());
  const std::size_t dash = header.find('-');
  if (dash == std::string_view::npos) return {};
  const std::string_view from = header.substr(0, dash);
  const std::string_view to = header.substr(dash + 1);
  const auto last = numberOf(to);
  if (from.empty()) {
    if (!last) return {};
    const std::uint64_t count = std::min(*last, size);
    return ByteRange{size - count, count};
  }
  const auto first = numberOf(from);
  if (!first || (!to.empty() && !last)) return {};
  if (last && *last < *first) return {};
  if (*first >= size) return ByteRange{};
  const std::uint64_t end = last ? std::min(*last, size - 1) + 1 : size;
  return ByteRange{*first, end - *first};
}

}  // namespace rocinante
