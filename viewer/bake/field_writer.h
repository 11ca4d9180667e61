#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/kinematics/model.h"
#include "viewer/bake/pointer_table.h"

namespace rocinante {

/// What values of a cell share: each is written once, and named by its number.
struct BakedSharing {
  PointerTable<Model> models;
  PointerTable<Mesh> meshes;
  PointerTable<Bytes> images;  ///< embedded in a mesh's file
  /// What a path is written as; empty: itself.
  std::function<std::string(const std::filesystem::path&)> path_text;
};

/// Writes values one after the other (docs/baked-cell.md, "Values"). What a struct consists of is
/// said by the functions `fields` of cell_fields.h, which serve FieldReader too.
class FieldWriter {
 public:
  static constexpr bool kReads = false;

  explicit FieldWriter(BakedSharing& sharing) : sharing_(sharing) {}

  template <class... Field>
  void operator()(const Field&... values) {
    (put(values), ...);
  }
  Bytes take() { return std::move(bytes_); }

 private:
  void put(bool value) { putNumber<std::uint8_t>(value ? 1 : 0); }
  void put(const std::string& text) { putText(text); }
  void put(const std::filesystem::path& path) {
    putText(sharing_.path_text ? sharing_.path_text(path) : path.string());
  }
  void put(const Vec3& value) { (*this)(value.x, value.y, value.z); }
  void put(const glm::vec2& value) { (*this)(value.x, value.y); }
  void put(const glm::vec3& value) { (*this)(value.x, value.y, value.z); }
  void put(const glm::vec4& value) { (*this)(value.x, value.y, value.z, value.w); }
  void put(const Quat& value) { (*this)(value.x, value.y, value.z, value.w); }
  void put(const std::shared_ptr<const Model>& shared) {
    putNumber(sharing_.models.number(shared));
  }
  void put(const std::shared_ptr<const Mesh>& shared) { putNumber(sharing_.meshes.number(shared)); }
  void put(const std::shared_ptr<const Bytes>& shared) {
    putNumber(sharing_.images.number(shared));
  }

  template <class Value>
  void put(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      putNumber(static_cast<std::uint8_t>(value));
    } else if constexpr (std::is_same_v<Value, std::size_t>) {
      putNumber<std::uint64_t>(value);  // as long on every machine
    } else if constexpr (std::is_arithmetic_v<Value>) {
      putNumber(value);
    } else {
      fields(*this, value);
    }
  }
  template <class Value>
  void put(const std::optional<Value>& value) {
    put(value.has_value());
    if (value) put(*value);
  }
  template <class A, class B>
  void put(const std::pair<A, B>& value) {
    (*this)(value.first, value.second);
  }
  template <class Value>
  void put(const std::vector<Value>& values) {
    putNumber<std::uint64_t>(values.size());
    if constexpr (kIsRaw<Value>) {
      putRaw(std::as_bytes(std::span(values)));
    } else {
      for (const Value& value : values) put(value);
    }
  }
  template <class Key, class Value, class Less>
  void put(const std::map<Key, Value, Less>& values) {
    putNumber<std::uint64_t>(values.size());
    for (const auto& [key, value] : values) (*this)(key, value);
  }

  void putText(const std::string& text) {
    putNumber<std::uint32_t>(static_cast<std::uint32_t>(text.size()));
    putRaw(bytesOf(text));
  }
  template <class Number>
  void putNumber(Number number) {
    static_assert(std::endian::native == std::endian::little);
    putRaw(std::as_bytes(std::span(&number, 1)));
  }
  void putRaw(ByteView raw) { bytes_.insert(bytes_.end(), raw.begin(), raw.end()); }

  BakedSharing& sharing_;
  Bytes bytes_;
};

}  // namespace rocinante
