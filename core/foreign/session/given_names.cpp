#include "core/foreign/session/given_names.h"

namespace rocinante {

std::string GivenNames::free(const std::string& wanted) {
  ++lookups_;
  const auto given = next_.find(wanted);
  if (given == next_.end()) return wanted;
  // No name is given back, so the numbers before this one stay taken.
  for (std::uint64_t& number = given->second;; ++number) {
    std::string name = wanted + "_" + std::to_string(number);
    ++lookups_;
    if (!next_.contains(name)) return name;
  }
}

std::string GivenNames::take(const std::string& wanted) {
  std::string name = free(wanted);
  next_.emplace(name, 2);
  return name;
}

}  // namespace rocinante
