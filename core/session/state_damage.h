#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// What a state, or a picture of several, may lack because its log is damaged: empty when it is
/// whole. Of several states it is their union, in whatever order they were asked for; at most a
/// hundred places are named. A plain value.
class StateDamage {
 public:
  /// One place: bytes that cannot be used, and between which times, since the log's origin, the
  /// messages lie that this cost. min() and max() of Nanoseconds where nobody knows.
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
  /// Those parts whose messages may lie in [from, until], since the origin.
  StateDamage within(Nanoseconds from, Nanoseconds until) const;

  /// "the log is damaged from 10.212 to 12.345 s: the chunk fails its checksum"
  std::string what() const;
  /// "half.mcap, byte 1048620"
  std::string where() const;
  /// what() with where() behind it, as an error prints.
  std::string text() const;

  bool operator==(const StateDamage&) const = default;

 private:
  std::vector<Part> parts_;
  bool is_more_ = false;  ///< than can be named
};

/// Adds the damage of a log between two places: what cannot be read of the messages behind `base`
/// (that of the keyframe that the fold began with) and not later than `moment`. The reader must
/// have read all of that once; what it knows of elsewhere makes no difference.
void addDamageBetween(const LogReader& log, LogPosition base, LogTime moment, StateDamage& damage);

}  // namespace rocinante
