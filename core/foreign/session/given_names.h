#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace rocinante {

/// Names that are given once each: of several that would be written alike, the second one gets
/// `_2`, the third one `_3`. A name costs the same however many are alike. The caller bounds how
/// many are taken. One thread.
class GivenNames {
 public:
  /// `wanted`, or with the first number that makes it a name that nobody has; it stays free.
  std::string free(const std::string& wanted);
  /// The same, and it is given.
  std::string take(const std::string& wanted);

  std::size_t size() const { return next_.size(); }
  /// How often it was looked whether a name is given: what the names cost so far.
  std::uint64_t lookups() const { return lookups_; }

 private:
  std::map<std::string, std::uint64_t> next_;  ///< by given name: the number to be tried next
  std::uint64_t lookups_ = 0;
};

}  // namespace rocinante
