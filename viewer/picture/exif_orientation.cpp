#include "viewer/picture/exif_orientation.h"

#include <array>
#include <cstdint>

namespace rocinante {
namespace {

constexpr std::size_t kEntryBytes = 12;
constexpr std::uint32_t kOrientationTag = 0x0112, kShort = 3;

/// Numbers of a TIFF structure; beyond its end they are 0.
class TiffNumbers {
 public:
  explicit TiffNumbers(ByteView bytes) : bytes_(bytes) {
    is_big_ = byteAt(0) == 'M' && byteAt(1) == 'M';
  }
  bool isTiff() const {
    return (is_big_ || (byteAt(0) == 'I' && byteAt(1) == 'I')) && numberAt(2, 2) == 42;
  }
  std::uint32_t numberAt(std::size_t at, std::size_t size) const {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < size; ++i) {
      number = number << 8U | byteAt(at + (is_big_ ? i : size - 1 - i));
    }
    return number;
  }

 private:
  std::uint32_t byteAt(std::size_t at) const {
    return at < bytes_.size() ? std::to_integer<std::uint32_t>(bytes_[at]) : 0;
  }

  ByteView bytes_;
  bool is_big_ = false;
};

}  // namespace

int exifOrientation(ByteView exif) {
  const TiffNumbers tiff(exif);
  if (!tiff.isTiff()) return 1;
  const std::size_t directory = tiff.numberAt(4, 4);
  const std::size_t entries = tiff.numberAt(directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + i * kEntryBytes;
    if (tiff.numberAt(entry, 2) != kOrientationTag || tiff.numberAt(entry + 2, 2) != kShort) {
      continue;
    }
    const std::uint32_t value = tiff.numberAt(entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

std::string orientationText(int orientation) {
  static constexpr std::array kTexts = {"as stored",
                                        "mirrored",
                                        "turned by 180 degrees",
                                        "mirrored top to bottom",
                                        "mirrored and turned by 90 degrees to the left",
                                        "turned by 90 degrees to the right",
                                        "mirrored and turned by 90 degrees to the right",
                                        "turned by 90 degrees to the left"};
  const bool is_known = orientation >= 1 && orientation <= 8;
  return kTexts[is_known ? static_cast<std::size_t>(orientation - 1) : 0];
}

}  // namespace rocinante
