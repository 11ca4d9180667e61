#pragma once

#include <cstring>

namespace rocinante {

/// A value that is set only when it changes; the first value always is.
template <class T>
class LatestValue {
 public:
  bool changesTo(const T& value) {
    // Bitwise, so that NaN equals itself and is not set repeatedly.
    if (known_ && std::memcmp(&value_, &value, sizeof(T)) == 0) return false;
    known_ = true;
    value_ = value;
    return true;
  }

 private:
  bool known_ = false;
  T value_{};
};

}  // namespace rocinante
