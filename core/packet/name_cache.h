#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rocinante {

namespace name_bytes {

template <class Unsigned>
std::uint64_t load(const char* from) {
  Unsigned bits;
  std::memcpy(&bits, from, sizeof bits);
  return bits;
}

/// Compares both ends of two texts of equal size, which may overlap, so that every byte is
/// compared.
template <class Unsigned>
bool sameEnds(const char* a, const char* b, std::size_t size) {
  const std::size_t last = size - sizeof(Unsigned);
  return load<Unsigned>(a) == load<Unsigned>(b) &&
         load<Unsigned>(a + last) == load<Unsigned>(b + last);
}

}  // namespace name_bytes

/// a == b. Names are short, and a stream compares a dozen per packet: calling memcmp for each took
/// a sixth of the time of checking a log.
inline bool sameName(std::string_view a, std::string_view b) {
  const std::size_t size = a.size();
  if (size != b.size()) return false;
  if (size > 16) return a == b;
  if (size >= 8) return name_bytes::sameEnds<std::uint64_t>(a.data(), b.data(), size);
  if (size >= 4) return name_bytes::sameEnds<std::uint32_t>(a.data(), b.data(), size);
  if (size >= 2) return name_bytes::sameEnds<std::uint16_t>(a.data(), b.data(), size);
  return size == 0 || a[0] == b[0];
}

/// Internal to SessionState, not for use outside the library. Caches where the values of recently
/// used names are in a map, so that a steady stream finds them without walking the map. Grows with
/// the map, so that a name of ten thousand costs what one of a hundred does. Points into its
/// owner's maps: a copied or moved cache starts empty, and an element must be forgotten before it
/// is erased.
template <class Found>
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

  /// Null when the name is not cached, which does not mean that it is not in the map.
  const Found* find(std::string_view name) const {
    if (slots_.empty()) return nullptr;
    const Slot* const slot = &slots_[firstOf(name)];
    if (slot[0].name != nullptr && sameName(*slot[0].name, name)) return &slot[0].found;
    if (slot[1].name != nullptr && sameName(*slot[1].name, name)) return &slot[1].found;
    return nullptr;
  }
  /// `names`: how many there are in the map.
  void remember(const std::string& name, Found found, std::size_t names = 0) {
    if (slots_.size() < std::min(names, kMostSlots) || slots_.empty()) makeRoom(names);
    put({&name, found});
  }
  /// Must be called before the element of this name is erased.
  void forget(std::string_view name) {
    if (slots_.empty()) return;
    Slot* const first = &slots_[firstOf(name)];
    for (Slot* const slot : {first, first + 1}) {
      if (slot->name != nullptr && sameName(*slot->name, name)) *slot = {};
    }
  }
  void clear() { slots_.clear(); }

 private:
  struct Slot {
    const std::string* name = nullptr;
    Found found{};
  };
  static constexpr std::size_t kLeastSlots = 256;
  static constexpr std::size_t kMostSlots = 65536;

  /// Two neighbours take the names of one hash; the older of them gives way.
  void put(const Slot& slot) {
    Slot* const first = &slots_[firstOf(*slot.name)];
    if (first->name != nullptr) first[1] = first[0];
    first[0] = slot;
  }
  void makeRoom(std::size_t names) {
    const std::size_t size = std::clamp(std::bit_ceil(2 * names), kLeastSlots, kMostSlots);
    const std::vector<Slot> before = std::exchange(slots_, std::vector<Slot>(size));
    shift_ = 65 - static_cast<unsigned>(std::bit_width(size - 1));
    for (const Slot& slot : before) {
      if (slot.name != nullptr) put(slot);
    }
  }

  /// The last eight bytes distinguish numbered names. Fixed-size loads that may overlap: a load of
  /// the name's size would stall on its own stores.
  std::size_t firstOf(std::string_view name) const {
    using name_bytes::load;
    const std::size_t size = name.size();
    const char* const end = name.data() + size;
    std::uint64_t bits = size;
    if (size >= 8) {
      bits ^= load<std::uint64_t>(end - 8);
    } else if (size >= 4) {
      bits ^= load<std::uint32_t>(name.data()) << 32U | load<std::uint32_t>(end - 4);
    } else if (size >= 2) {
      bits ^= load<std::uint16_t>(name.data()) << 16U | load<std::uint16_t>(end - 2);
    } else if (size == 1) {
      bits ^= load<std::uint8_t>(name.data());
    }
    return static_cast<std::size_t>(bits * 0x9E3779B97F4A7C15U >> shift_) * 2;
  }

  std::vector<Slot> slots_;
  unsigned shift_ = 64;  ///< of a hash, for the number of its pair of slots
};

}  // namespace rocinante
