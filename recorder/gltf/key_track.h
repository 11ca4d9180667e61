#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/unnamed_file.h"

namespace rocinante {

/// Many growing lists of numbers in one unnamed file, so that they can be read list by list. One
/// small block of each is in memory. One thread.
class KeySpill {
 public:
  /// unreadable when no file can be made in `folder`.
  static Result<KeySpill> make(const std::string& folder);

  /// A new, empty list.
  std::size_t addList();
  Status append(std::size_t list, std::span<const float> numbers);
  std::uint64_t bytesOf(std::size_t list) const;

  /// Gives the list's bytes in order, in pieces that are borrowed for the call.
  Status read(std::size_t list, const std::function<Status(ByteView)>& use) const;

 private:
  struct List {
    std::vector<std::uint64_t> blocks;  ///< places in the file, in blocks
    std::vector<float> open;            ///< what is not in the file yet
  };

  explicit KeySpill(UnnamedFile file) : file_(std::move(file)) {}
  Status writeBlock(List& list);

  UnnamedFile file_;
  std::vector<List> lists_;
  std::uint64_t blocks_ = 0;  ///< in the file
};

/// One property of a node over time: a translation in metres, a unit quaternion x y z w, or a
/// scale. Nothing is written to the spill until a second value comes. Keys are floats, as glTF has
/// them: a translation is kept from offset(), so that it is as exact far from the origin as near
/// it, and what floats could not hold is counted.
class KeyTrack {
 public:
  enum class Kind : std::uint8_t { translation, rotation, scale };
  explicit KeyTrack(Kind kind) : kind_(kind) {}

  /// The value at `seconds`, which never decreases. Of a translation or rotation: it blends from
  /// the value before, over a second at most; before that the value holds, as packets leave it. A
  /// scale steps.
  Status add(KeySpill& spill, double seconds, std::span<const double> value);
  /// Call once, last.
  Status end(KeySpill& spill);

  Kind kind() const { return kind_; }
  bool empty() const { return !first_.has_value(); }
  bool animated() const { return lists_.has_value(); }
  /// The first value: 3 numbers, or 4 of a rotation.
  std::span<const float> first() const { return std::span(*first_).first(width()); }
  std::size_t width() const { return kind_ == Kind::rotation ? 4 : 3; }
  /// Of a translation: to be added to every value; exact as floats. 0 within a kilometre.
  const std::array<double, 3>& offset() const { return offset_; }
  bool hasOffset() const { return offset_ != std::array<double, 3>{}; }

  /// Values that have the time of a later one, as floats count seconds.
  std::uint64_t merged() const { return merged_; }
  /// Metres by which the worst value of a translation is off.
  double worstError() const { return worst_error_; }

  // Once it has ended, when it is animated.
  std::uint64_t keys() const { return keys_; }
  float firstTime() const { return first_time_; }
  float lastTime() const { return key_time_; }
  std::size_t timeList() const { return lists_->first; }
  std::size_t valueList() const { return lists_->second; }

 private:
  using Value = std::array<float, 4>;
  bool isSame(const Value& value) const;
  void chooseOffset(std::span<const double> value);
  Value rounded(std::span<const double> value);
  Status setKey(KeySpill& spill, double seconds, const Value& value);
  Status writeKey(KeySpill& spill);

  Kind kind_;
  std::optional<Value> first_;
  Value key_{};         ///< the last one, which the spill does not have yet
  float key_time_ = 0;  ///< seconds
  float first_time_ = 0;
  double key_s_ = 0;   ///< its time as it was given
  double seen_s_ = 0;  ///< when the last key's value was given again
  std::optional<std::pair<std::size_t, std::size_t>> lists_;  ///< times, values
  std::uint64_t keys_ = 0;
  std::array<double, 3> offset_{};
  std::uint64_t merged_ = 0;
  double worst_error_ = 0;
};

}  // namespace rocinante
