#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// The parts that a state, or a picture of several, may lack because its log is damaged: empty when
/// it is whole. For several states it is their union, independent of the order of queries; at most
/// a hundred places are named. A plain value.
class StateDamage {
 public:
  /// One place: unusable bytes, and the times, since the log's origin, between which the lost
  /// messages were. min() and max() of Nanoseconds when unknown.
  struct Part {
    std::string log;
    std::uint64_t from_byte = 0, to_byte = 0;
    Nanoseconds from{}, until{};
    std::string cause;
    auto operator<=>(const Part&) const = default;
  };

  bool empty() const { return parts_.empty(); }
  /// By log and byte, each once.
  const std::vector<Part>& parts() const { return parts_; }
  void add(Part part);
  void add(const StateDamage& other);
  /// The parts whose messages may be in [from, until], since the origin.
  StateDamage within(Nanoseconds from, Nanoseconds until) const;

  /// "the log is damaged from 10.212 to 12.345 s: the chunk fails its checksum"
  std::string what() const;
  /// "half.mcap, byte 1048620"
  std::string where() const;
  /// what() followed by where(), as an error prints.
  std::string text() const;

  bool operator==(const StateDamage&) const = default;

 private:
  std::vector<Part> parts_;
  bool is_more_ = false;  ///< more than can be named
};

/// Adds the damage of a log between two positions: the unreadable messages behind `base` (that of
/// the keyframe that the fold began with) and not behind `last`. The reader must have read all of
/// that once; damage known elsewhere is ignored.
void addDamageBetween(const LogReader& log, LogPosition base, LogPosition last,
                      StateDamage& damage);

}  // namespace rocinante
