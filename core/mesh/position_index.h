#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "core/math/vector.h"

namespace rocinante {

/// Numbers distinct positions from 0 in the order of first use. Equal means equal floats: no
/// tolerance, so the answer does not depend on the order of the file; -0 equals 0.
class PositionIndex {
 public:
  explicit PositionIndex(std::size_t expected) {
    std::size_t slots = 16;
    while (slots < expected * 2) slots *= 2;
    slots_.assign(slots, kFree);
  }

  std::uint32_t numberOf(const glm::vec3& position) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash(position)) & mask;
    while (slots_[slot] != kFree) {
      if (positions_[slots_[slot]] == position) return slots_[slot];
      slot = (slot + 1) & mask;
    }
    const auto number = static_cast<std::uint32_t>(positions_.size());
    positions_.push_back(position);
    slots_[slot] = number;
    if (positions_.size() * 4 > slots_.size() * 3) grow();
    return number;
  }

  /// By number.
  const std::vector<glm::vec3>& positions() const { return positions_; }
  std::vector<glm::vec3> takePositions() { return std::move(positions_); }

 private:
  static constexpr std::uint32_t kFree = 0xFFFFFFFF;

  static std::uint64_t hash(const glm::vec3& position) {
    // Adding zero turns -0 into 0.
    const std::uint64_t x = std::bit_cast<std::uint32_t>(position.x + 0.0F);
    const std::uint64_t y = std::bit_cast<std::uint32_t>(position.y + 0.0F);
    const std::uint64_t z = std::bit_cast<std::uint32_t>(position.z + 0.0F);
    std::uint64_t mixed = (x | y << 32U) * 0x9E3779B97F4A7C15U;
    mixed = (mixed ^ mixed >> 32U ^ z) * 0xD6E8FEB86659FD93U;
    return mixed ^ mixed >> 32U;
  }

  void grow() {
    slots_.assign(slots_.size() * 2, kFree);
    const std::size_t mask = slots_.size() - 1;
    for (std::uint32_t number = 0; number < positions_.size(); ++number) {
      std::size_t slot = static_cast<std::size_t>(hash(positions_[number])) & mask;
      while (slots_[slot] != kFree) slot = (slot + 1) & mask;
      slots_[slot] = number;
    }
  }

  std::vector<std::uint32_t> slots_;
  std::vector<glm::vec3> positions_;
};

}  // namespace rocinante
