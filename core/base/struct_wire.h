#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/bytes.h"

// Structs as bytes of this machine: between processes of one program, and in a cache that the same
// version of it reads again. What a struct consists of is a function found by its argument,
//
//   template <class Fields>
//   void fields(Fields& io, Taken<Fields, Joint>& joint) {
//     auto& [name, type] = joint;
//     io(name, type);
//   }
//
// for writer and reader alike. Taken apart by a structured binding, a struct with another member
// does not compile until it is written too.

namespace rocinante {

/// `Struct` as `Fields` needs it: a reader changes it.
template <class Fields, class Struct>
using Taken = std::conditional_t<Fields::kReads, Struct, const Struct>;

class StructWriter {
 public:
  static constexpr bool kReads = false;

  template <class... Values>
  void operator()(const Values&... values) {
    (item(values), ...);
  }
  Bytes take() { return std::move(bytes_); }

 private:
  template <class T>
  void item(const T& value) {
    if constexpr (requires { fields(*this, value); }) {
      fields(*this, value);
    } else {
      static_assert(std::is_trivially_copyable_v<T>);
      append(&value, sizeof value);
    }
  }
  void item(const std::string& text) { list(text.data(), text.size()); }
  template <class T>
  void item(const std::optional<T>& value) {
    item(std::uint8_t{value.has_value()});
    if (value) item(*value);
  }
  template <class T>
  void item(const std::vector<T>& values) {
    if constexpr (std::is_arithmetic_v<T>) {
      list(values.data(), values.size());
    } else {
      each(values);
    }
  }
  template <class T>
  void item(const std::set<T>& values) {
    each(values);
  }
  template <class T>
  void item(const std::map<std::string, T, std::less<>>& values) {
    each(values);
  }
  template <class A, class B>
  void item(const std::pair<A, B>& pair) {
    (*this)(pair.first, pair.second);
  }

  template <class T>
  void list(const T* values, std::size_t count) {
    item(std::uint64_t{count});
    append(values, count * sizeof(T));
  }
  template <class List>
  void each(const List& list) {
    item(std::uint64_t{list.size()});
    for (const auto& one : list) item(one);
  }
  void append(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  Bytes bytes_;
};

/// Reads what StructWriter wrote. Takes no more memory than a small multiple of the bytes; after
/// the first fault readAll() is false, and what was read is unspecified.
class StructReader {
 public:
  static constexpr bool kReads = true;

  /// Borrows `bytes`.
  explicit StructReader(ByteView bytes) : bytes_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (item(values), ...);
  }
  /// Nothing was missing, nothing is left.
  bool readAll() const { return sound_ && bytes_.empty(); }

 private:
  template <class T>
  void item(T& value) {
    if constexpr (requires { fields(*this, value); }) {
      fields(*this, value);
    } else {
      static_assert(std::is_trivially_copyable_v<T>);
      append(&value, 1);
    }
  }
  void item(std::string& text) {
    text.resize(count(1));
    append(text.data(), text.size());
  }
  template <class T>
  void item(std::optional<T>& value) {
    std::uint8_t there = 0;
    item(there);
    // Read separately: with emplace(), g++ 14 warns that an uninitialized value is destroyed.
    std::optional<T> read;
    if (there != 0 && sound_) item(read.emplace());
    value = std::move(read);
  }
  template <class T>
  void item(std::vector<T>& values) {
    if constexpr (std::is_arithmetic_v<T>) {
      values.resize(count(sizeof(T)));
      append(values.data(), values.size());
    } else {
      values.clear();
      each([&] { item(values.emplace_back()); });
    }
  }
  template <class T>
  void item(std::set<T>& values) {
    values.clear();
    each([&] {
      T value;
      item(value);
      values.insert(std::move(value));
    });
  }
  template <class T>
  void item(std::map<std::string, T, std::less<>>& values) {
    values.clear();
    each([&] {
      std::string name;
      item(name);
      item(values[name]);
    });
  }

  template <class Read>
  void each(Read read) {
    for (std::size_t i = count(1); i > 0 && sound_; --i) read();
  }
  /// Limited by what remains: each takes at least `least_bytes`.
  std::size_t count(std::size_t least_bytes) {
    std::uint64_t many = 0;
    item(many);
    if (many > bytes_.size() / least_bytes) sound_ = false;
    return sound_ ? static_cast<std::size_t>(many) : 0;
  }
  template <class T>
  void append(T* values, std::size_t count) {
    const std::size_t size = count * sizeof(T);
    if (size > bytes_.size()) sound_ = false;
    if (!sound_ || size == 0) return;
    std::memcpy(values, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }

  ByteView bytes_;
  bool sound_ = true;
};

}  // namespace rocinante
