#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace rocinante {

/// Remembers where the values of names used lately lie in a map, so that a steady stream finds
/// them without walking it. Points into its owner's maps: a copy or a moved one starts empty,
/// and clear() must be called before a remembered element is erased.
template <class Value>
class NameCache {
 public:
  NameCache() = default;
  NameCache(const NameCache&) {}
  NameCache(NameCache&& other) noexcept { other.clear(); }
  NameCache& operator=(const NameCache&) {
    clear();
    return *this;
  }
  NameCache& operator=(NameCache&& other) noexcept {
    clear();
    other.clear();
    return *this;
  }
  ~NameCache() = default;

  /// Null when it is not remembered, which says nothing about the map.
  Value* find(std::string_view name) const {
    const Slot& slot = slots_[slotOf(name)];
    return slot.name != nullptr && *slot.name == name ? slot.value : nullptr;
  }
  void remember(const std::string& name, Value* value) { slots_[slotOf(name)] = {&name, value}; }
  void clear() { slots_ = {}; }

 private:
  struct Slot {
    const std::string* name = nullptr;
    Value* value = nullptr;
  };
  static constexpr std::size_t kSlots = 256;

  /// The last eight bytes tell numbered names apart.
  static std::size_t slotOf(std::string_view name) {
    std::uint64_t bits = name.size();
    const std::size_t tail = name.size() < 8 ? name.size() : 8;
    std::memcpy(&bits, name.data() + name.size() - tail, tail);
    return static_cast<std::size_t>((bits ^ name.size()) * 0x9E3779B97F4A7C15U >> 56U);
  }

  std::array<Slot, kSlots> slots_{};
};

}  // namespace rocinante
