#pragma once

#include <memory>

#include "core/base/bytes.h"

namespace rocinante {

/// A message to any number of clients. In front of its bytes is room for the head of a frame, which
/// the library writes there.
class SharedMessage {
 public:
  static constexpr std::size_t kRoom = 32;

  /// Empty bytes to append to.
  static Bytes begin() {
    Bytes bytes;
    bytes.reserve(512);
    bytes.resize(kRoom);
    return bytes;
  }

  SharedMessage() = default;
  explicit SharedMessage(Bytes with_room) : bytes_(std::make_shared<Bytes>(std::move(with_room))) {}

  explicit operator bool() const { return bytes_ != nullptr; }
  std::size_t size() const { return bytes_->size() - kRoom; }
  std::byte* data() const { return bytes_->data() + kRoom; }

 private:
  std::shared_ptr<Bytes> bytes_;
};

}  // namespace rocinante
