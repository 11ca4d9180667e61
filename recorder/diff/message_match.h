#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "recorder/diff/log_diff.h"

namespace rocinante {

/// A captured message, as far as two logs are compared by it.
struct MatchItem {
  std::array<std::uint64_t, 2> digest{};  ///< of topic and payload, or of the payload alone
  DiffPlace place;
};

/// Walks over two logs at once and matches their captured messages in order.
class MessageMatch {
 public:
  /// Both are borrowed, and read from where they stand.
  MessageMatch(LogReader& a, LogReader& b) : sides_{Side{a}, Side{b}} {}
  /// Those alone that are on the chosen channels of each, by id; their topics are not compared.
  MessageMatch(LogReader& a, LogReader& b, std::array<std::vector<bool>, 2> chosen)
      : sides_{Side{a}, Side{b}}, chosen_(std::move(chosen)) {}

  /// A message of both, or of one alone.
  struct Step {
    std::optional<MatchItem> a, b;
  };
  /// Empty at the end of both.
  Result<std::optional<Step>> next();

  std::uint64_t count(std::size_t side) const { return sides_[side].count; }

  /// What stands in either log where they part for the first time: empty where it has ended.
  struct Parting {
    std::optional<DiffPlace> a, b;
  };
  const std::optional<Parting>& firstParting() const { return first_parting_; }

 private:
  /// So many messages ahead are looked at for a place where the logs go on together.
  static constexpr std::size_t kWindow = 4096;

  struct Side {
    explicit Side(LogReader& log) : reader(log) {}
    LogReader& reader;
    std::deque<MatchItem> ahead;
    std::uint64_t count = 0;  ///< read so far
    bool at_end = false;
  };

  bool wants(std::size_t side, const LogChannel& channel) const;
  Status fill(std::size_t side, std::size_t items);
  Status resynchronise();

  std::array<Side, 2> sides_;
  std::optional<std::array<std::vector<bool>, 2>> chosen_;
  /// Messages that only one has, known to come before the logs go on together.
  std::array<std::size_t, 2> alone_{0, 0};
  std::optional<Parting> first_parting_;
};

}  // namespace rocinante
