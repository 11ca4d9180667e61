#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// A breach of a rule of the format or the profile at one place.
struct Breach {
  std::string rule;          ///< its id (docs/programs/log.md, "log doctor")
  std::uint64_t offset = 0;  ///< in the file; of the record, or of the chunk that holds it
  std::string what;          ///< one sentence
};

/// The result of examining a log. Keeps the first breaches of each rule, and counts all.
class DoctorReport {
 public:
  static constexpr std::uint64_t kMaxListed = 20;

  void add(std::string_view rule, std::uint64_t offset, std::string what) {
    auto found = counts_.find(rule);
    if (found == counts_.end()) found = counts_.emplace(rule, 0).first;
    if (found->second++ < kMaxListed) {
      breaches_.push_back({std::string(rule), offset, std::move(what)});
    }
  }

  bool clean() const { return counts_.empty(); }
  bool broke(std::string_view rule) const { return counts_.find(rule) != counts_.end(); }
  /// In the order found.
  const std::vector<Breach>& breaches() const { return breaches_; }
  /// Number of breaches of every broken rule.
  const std::map<std::string, std::uint64_t, std::less<>>& counts() const { return counts_; }

  std::string name;     ///< of the file
  std::string profile;  ///< of its header; our rules apply if it is `rocinante`
  std::uint64_t file_bytes = 0;
  std::uint64_t chunks = 0;
  std::uint64_t messages = 0;

 private:
  std::vector<Breach> breaches_;
  std::map<std::string, std::uint64_t, std::less<>> counts_;
};

}  // namespace rocinante
