#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/kinematics/model.h"
#include "viewer/bake/pointer_table.h"

namespace rocinante {

/// What values of a cell share, by number.
struct ReadSharing {
  std::vector<std::shared_ptr<const Model>> models;
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<std::shared_ptr<const Bytes>> images;
};

/// Reads what FieldWriter wrote. Nothing is trusted: lengths are checked before memory is taken,
/// numbers must be finite, enumerators and numbers of shared values known. After the first fault
/// ok() is false, and values are zero or empty.
class FieldReader {
 public:
  static constexpr bool kReads = true;

  FieldReader(ByteView bytes, const ReadSharing& sharing) : left_(bytes), sharing_(sharing) {}

  template <class... Field>
  void operator()(Field&... values) {
    (take(values), ...);
  }
  bool ok() const { return ok_; }
  ByteView left() const { return left_; }
  /// Everything was read, without a fault.
  bool finished() const { return ok_ && left_.empty(); }

 private:
  void take(bool& value) {
    const auto byte = takeNumber<std::uint8_t>();
    if (byte > 1) fail();
    value = byte == 1;
  }
  void take(std::string& text) { text = takeText(); }
  void take(std::filesystem::path& path) { path = takeText(); }
  void take(Vec3& value) { (*this)(value.x, value.y, value.z); }
  void take(glm::vec2& value) { (*this)(value.x, value.y); }
  void take(glm::vec3& value) { (*this)(value.x, value.y, value.z); }
  void take(glm::vec4& value) { (*this)(value.x, value.y, value.z, value.w); }
  void take(Quat& value) { (*this)(value.x, value.y, value.z, value.w); }
  void take(std::shared_ptr<const Model>& shared) { shared = takeShared(sharing_.models); }
  void take(std::shared_ptr<const Mesh>& shared) { shared = takeShared(sharing_.meshes); }
  void take(std::shared_ptr<const Bytes>& shared) { shared = takeShared(sharing_.images); }

  template <class Value>
  void take(Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      const auto number = takeNumber<std::uint8_t>();
      if (number >= enumeratorCount(Value{})) fail();
      value = ok_ ? static_cast<Value>(number) : Value{};
    } else if constexpr (std::is_same_v<Value, std::size_t>) {
      const auto number = takeNumber<std::uint64_t>();
      value = static_cast<std::size_t>(number);
      if (value != number) fail();
    } else if constexpr (std::is_floating_point_v<Value>) {
      value = takeNumber<Value>();
      if (!std::isfinite(value)) fail();
    } else if constexpr (std::is_arithmetic_v<Value>) {
      value = takeNumber<Value>();
    } else {
      fields(*this, value);
    }
  }
  template <class Value>
  void take(std::optional<Value>& value) {
    bool there = false;
    take(there);
    if (there && ok_) take(value.emplace());
  }
  template <class A, class B>
  void take(std::pair<A, B>& value) {
    (*this)(value.first, value.second);
  }
  template <class Value>
  void take(std::vector<Value>& values) {
    const auto count = takeNumber<std::uint64_t>();
    if constexpr (kIsRaw<Value>) {
      if (count > left_.size() / sizeof(Value)) return fail();
      if (count == 0) return;
      values.resize(static_cast<std::size_t>(count));
      std::memcpy(values.data(), left_.data(), values.size() * sizeof(Value));
      left_ = left_.subspan(values.size() * sizeof(Value));
    } else {
      // Grows with what was read, as no element is less than a byte long.
      for (std::uint64_t i = 0; i < count && ok_; ++i) take(values.emplace_back());
    }
  }
  template <class Key, class Value, class Less>
  void take(std::map<Key, Value, Less>& values) {
    const auto count = takeNumber<std::uint64_t>();
    for (std::uint64_t i = 0; i < count && ok_; ++i) {
      std::pair<Key, Value> each;
      take(each);
      if (!values.insert(std::move(each)).second) fail();
    }
  }

  template <class Value>
  std::shared_ptr<const Value> takeShared(const std::vector<std::shared_ptr<const Value>>& values) {
    const auto number = takeNumber<std::uint32_t>();
    if (number == PointerTable<Value>::kNone) return nullptr;
    if (number < values.size()) return values[number];
    fail();
    return nullptr;
  }
  std::string takeText() {
    const auto size = takeNumber<std::uint32_t>();
    if (size > left_.size()) {
      fail();
      return {};
    }
    std::string text(textOf(left_.first(size)));
    left_ = left_.subspan(size);
    return text;
  }
  template <class Number>
  Number takeNumber() {
    static_assert(std::endian::native == std::endian::little);
    Number number{};
    if (left_.size() < sizeof number) {
      fail();
      return number;
    }
    std::memcpy(&number, left_.data(), sizeof number);
    left_ = left_.subspan(sizeof number);
    return number;
  }
  void fail() {
    ok_ = false;
    left_ = {};
  }

  ByteView left_;
  const ReadSharing& sharing_;
  bool ok_ = true;
};

}  // namespace rocinante
