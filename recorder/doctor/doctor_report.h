#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/report/finding.h"

namespace rocinante {

/// The result of examining a log. Keeps the first breaches of each rule (docs/programs/log.md,
/// "log doctor"), and counts all.
class DoctorReport {
 public:
  static constexpr std::uint64_t kMaxListed = 20;

  /// `offset` in the file: of the record, or of the chunk that holds it.
  void add(std::string_view rule, std::uint64_t offset, std::string text) {
    auto found = counts_.find(rule);
    if (found == counts_.end()) found = counts_.emplace(rule, 0).first;
    if (found->second++ < kMaxListed) {
      breaches_.push_back({.rule = std::string(rule), .text = std::move(text), .byte = offset});
    }
  }

  bool clean() const { return counts_.empty(); }
  bool broke(std::string_view rule) const { return counts_.find(rule) != counts_.end(); }
  /// In the order found.
  const Findings& breaches() const { return breaches_; }
  /// Number of breaches of every broken rule.
  const std::map<std::string, std::uint64_t, std::less<>>& counts() const { return counts_; }

  std::string name;     ///< of the file
  std::string profile;  ///< of its header; our rules apply if it is `rocinante`
  std::uint64_t file_bytes = 0;
  std::uint64_t chunks = 0;
  std::uint64_t messages = 0;

 private:
  Findings breaches_;
  std::map<std::string, std::uint64_t, std::less<>> counts_;
};

}  // namespace rocinante
