#pragma once

#include <cstdint>
#include <vector>

#include "golden/why/pixel_blame.h"

namespace rocinante::test {

/// A grey picture on which rectangles are painted; later ones lie over earlier ones.
class Painting {
 public:
  Painting() {
    picture_ = {kWidth, kHeight, std::vector<std::uint8_t>(kWidth * kHeight * 4, 128)};
    identity_ = {kWidth, kHeight, std::vector<std::uint32_t>(kWidth * kHeight), {}};
  }
  Painting& add(const IdentityName& name, int left, int top, int size, std::uint8_t red) {
    identity_.names.push_back(name);
    for (int y = top; y < top + size; ++y) {
      for (int x = left; x < left + size; ++x) {
        const auto at = static_cast<std::size_t>(y * kWidth + x);
        picture_.rgba[at * 4] = red;
        identity_.ids[at] = static_cast<std::uint32_t>(identity_.names.size());
      }
    }
    return *this;
  }
  BlameSide side() const { return {picture_, identity_}; }
  Picture& picture() { return picture_; }

 private:
  static constexpr int kWidth = 64, kHeight = 48;
  Picture picture_;
  IdentityFrame identity_;
};

inline const IdentityName kHand{"arm", "hand"};
inline const IdentityName kWall{"hall", "wall"};

}  // namespace rocinante::test
