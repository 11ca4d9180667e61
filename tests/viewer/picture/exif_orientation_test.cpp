#include "viewer/picture/exif_orientation.h"

#include <gtest/gtest.h>

#include <string>

namespace rocinante {
namespace {

using namespace std::string_literals;

int orientationIn(const std::string& exif) { return exifOrientation(bytesOf(exif)); }

const std::string kBig = "MM\0*\0\0\0\x08\0\x02"s + "\x01\x0F\0\x02\0\0\0\x01\0\0\0\0"s +
                         "\x01\x12\0\x03\0\0\0\x01\0\x06\0\0"s + "\0\0\0\0"s;
const std::string kLittle =
    "II*\0\x08\0\0\0\x01\0"s + "\x12\x01\x03\0\x01\0\0\0\x03\0\0\0"s + "\0\0\0\0"s;

TEST(ExifOrientation, IsReadInEitherByteOrder) {
  EXPECT_EQ(orientationIn(kBig), 6);
  EXPECT_EQ(orientationIn(kLittle), 3);
  EXPECT_EQ(orientationText(6), "turned by 90 degrees to the right");
  EXPECT_EQ(orientationText(1), "as stored");
  EXPECT_EQ(orientationText(99), "as stored");
}

TEST(ExifOrientation, OfBrokenMetadataIsAsStored) {
  for (std::size_t size = 0; size < kBig.size() - 6; ++size) {
    EXPECT_EQ(orientationIn(kBig.substr(0, size)), 1) << size;
  }
  std::string broken = kLittle;
  broken[18] = 9;  // there are eight
  EXPECT_EQ(orientationIn(broken), 1);
  broken = kLittle;
  broken[4] = broken[5] = broken[6] = broken[7] = '\xFF';
  EXPECT_EQ(orientationIn(broken), 1);
  broken = kLittle;
  broken[2] = 'x';
  EXPECT_EQ(orientationIn(broken), 1);
}

}  // namespace
}  // namespace rocinante
