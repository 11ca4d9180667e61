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

/// The parts of a captured message by which two logs are compared.
struct MatchItem {
  std::array<std::uint64_t, 2> digest{};  ///< of topic and payload, or of the payload only
  DiffPlace place;
};

/// Walks over two logs at once and matches their captured messages in order.
class MessageMatch {
 public:
  /// Both are borrowed and read from their current positions.
  MessageMatch(LogReader& a, LogReader& b) : sides_{Side{a}, Side{b}} {}
  /// Matches only messages on the chosen channels of each, by id, without comparing topics.
  MessageMatch(LogReader& a, LogReader& b, std::array<std::vector<bool>, 2> chosen)
      : sides_{Side{a}, Side{b}}, chosen_(std::move(chosen)) {}

  /// A message of both logs, or of only one.
  struct Step {
    std::optional<MatchItem> a, b;
  };
  /// Empty at the end of both.
  Result<std::optional<Step>> next();

  std::uint64_t count(std::size_t side) const { return sides_[side].count; }

  /// The message of either log at the first difference; empty where that log has ended.
  struct Parting {
    std::optional<DiffPlace> a, b;
  };
  const std::optional<Parting>& firstParting() const { return first_parting_; }

 private:
  /// Messages ahead that are searched for a place where the logs match again.
  static constexpr std::size_t kWindow = 4096;

  struct Side {
    explicit Side(LogReader& log) : reader(log) {}
    LogReader& reader;
    std::deque<MatchItem> ahead;
    std::uint64_t count = 0;  ///< read so far
    bool at_end = false;
  };

  bool compares(std::size_t side, const LogChannel& channel) const;
  Status fill(std::size_t side, std::size_t items);
  Status resynchronise();

  std::array<Side, 2> sides_;
  std::optional<std::array<std::vector<bool>, 2>> chosen_;
  /// Messages of only one log, known to precede the place where the logs match again.
  std::array<std::size_t, 2> alone_{0, 0};
  std::optional<Parting> first_parting_;
};

}  // namespace rocinante
