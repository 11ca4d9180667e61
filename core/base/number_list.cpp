#include "core/base/number_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/plain_text.h"

namespace rocinante {

Result<std::vector<double>> parseNumbers(std::string_view text) {
  std::vector<double> numbers;
  constexpr std::string_view kBetween = " \t,";
  for (std::size_t at = text.find_first_not_of(kBetween); at != std::string_view::npos;
       at = text.find_first_not_of(kBetween, at)) {
    const std::size_t end = std::min(text.find_first_of(kBetween, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const std::string_view digits = word.substr(word.front() == '+' ? 1 : 0);
    double value = 0;
    const auto [stop, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (fault != std::errc() || stop != digits.data() + digits.size() || !std::isfinite(value)) {
      return Error{ErrorKind::bad_argument, fmt::format("`{}` is not a number", plainText(word)),
                   ""};
    }
    numbers.push_back(value);
    at = end;
  }
  return numbers;
}

}  // namespace rocinante
