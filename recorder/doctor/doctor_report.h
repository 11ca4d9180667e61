#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// A rule of the format or of the profile, broken at one place.
struct Breach {
  std::string rule;          ///< its id (docs/programs/log.md, "log doctor")
  std::uint64_t offset = 0;  ///< in the file: of the record, or of the chunk that holds it
  std::string what;          ///< one sentence
};

/// What an examination of a log found. Of each rule the first breaches are kept, and all counted.
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
  /// In the order in which they were found.
  const std::vector<Breach>& breaches() const { return breaches_; }
  /// Of every rule that is broken: how often.
  const std::map<std::string, std::uint64_t, std::less<>>& counts() const { return counts_; }

  std::string name;     ///< of the file
  std::string profile;  ///< of its header: rules of ours are looked at where it is `rocinante`
  std::uint64_t file_bytes = 0;
  std::uint64_t chunks = 0;
  std::uint64_t messages = 0;

 private:
  std::vector<Breach> breaches_;
  std::map<std::string, std::uint64_t, std::less<>> counts_;
};

}  // namespace rocinante
