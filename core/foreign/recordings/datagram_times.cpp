#include "core/foreign/recordings/datagram_times.h"

#include <algorithm>
#include <charconv>
#include <compare>
#include <limits>
#include <optional>

namespace rocinante {
namespace {

bool isNameDigit(char each) { return each >= '0' && each <= '9'; }
bool areNameDigits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, isNameDigit);
}

/// The name without its ending; ".25" of "1700000000.25" is none.
std::string_view stemOfName(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == name.npos || dot == 0 || areNameDigits(name.substr(dot + 1))) return name;
  return name.substr(0, dot);
}

/// Nanoseconds since 1970 of "1700000000.25" or "1700000000250000": the number of digits before the
/// point says what they count.
std::optional<std::int64_t> timeInName(std::string_view name) {
  const std::string_view stem = stemOfName(name);
  const std::size_t dot = stem.find('.');
  const std::string_view whole = stem.substr(0, dot);
  const std::string_view part = dot == stem.npos ? std::string_view() : stem.substr(dot + 1);
  if (!areNameDigits(whole) || whole.size() < 9 || whole.size() > 19) return std::nullopt;
  if (dot != stem.npos && (!areNameDigits(part) || part.size() > 9 || whole.size() > 11)) {
    return std::nullopt;
  }
  std::int64_t value = 0;
  if (std::from_chars(whole.data(), whole.data() + whole.size(), value).ec != std::errc()) {
    return std::nullopt;
  }
  std::int64_t unit = 1;
  if (whole.size() <= 17) unit = 1000;
  if (whole.size() <= 14) unit = 1'000'000;
  if (whole.size() <= 11) unit = 1'000'000'000;
  if (value > std::numeric_limits<std::int64_t>::max() / unit - 1) return std::nullopt;
  value *= unit;
  std::int64_t digit_ns = 100'000'000;
  for (const char each : part) {
    value += (each - '0') * digit_ns;
    digit_ns /= 10;
  }
  return value;
}

/// The last digits of the name without its ending, without zeros in front; empty: none.
std::optional<std::string_view> numberInName(std::string_view name) {
  const std::string_view stem = stemOfName(name);
  std::size_t end = stem.size();
  while (end > 0 && !isNameDigit(stem[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && isNameDigit(stem[begin - 1])) --begin;
  if (begin == end) return std::nullopt;
  while (begin + 1 < end && stem[begin] == '0') ++begin;
  return stem.substr(begin, end - begin);
}

std::weak_ordering byNameNumber(std::string_view left, std::string_view right) {
  if (left.size() != right.size()) return left.size() <=> right.size();
  return left.compare(right) <=> 0;
}

}  // namespace

DatagramOrder orderedDatagrams(std::vector<DatagramFile> files) {
  DatagramOrder order;
  const auto all = [&](const auto& has) {
    return std::ranges::all_of(
        files, [&](const DatagramFile& file) { return has(file.name).has_value(); });
  };
  if (all(timeInName)) {
    order.rule = DatagramOrder::Rule::names_are_times;
    for (DatagramFile& file : files) file.changed_ns = *timeInName(file.name);
  } else if (all(numberInName)) {
    order.rule = DatagramOrder::Rule::names_are_numbers;
  }
  std::ranges::sort(files, [&](const DatagramFile& left, const DatagramFile& right) {
    if (order.rule == DatagramOrder::Rule::names_are_numbers) {
      const std::weak_ordering number =
          byNameNumber(*numberInName(left.name), *numberInName(right.name));
      return number != 0 ? number < 0 : left.name < right.name;
    }
    if (left.changed_ns != right.changed_ns) return left.changed_ns < right.changed_ns;
    return left.name < right.name;
  });
  std::int64_t reached = std::numeric_limits<std::int64_t>::min();
  for (DatagramFile& file : files) {
    if (file.changed_ns < reached) ++order.held;
    reached = std::max(reached, file.changed_ns);
    order.datagrams.push_back({std::move(file.name), LogTime(Nanoseconds(reached))});
  }
  return order;
}

}  // namespace rocinante
