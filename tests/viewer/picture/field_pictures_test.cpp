// ../shared/field, the picture cases 37, 38 and 39: stored values count
// (docs/comparing-pictures.md), whatever kind of PNG holds them, and whatever its metadata say.

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/shared_data.h"
#include "viewer/picture/picture.h"

namespace rocinante {
namespace {

struct FieldPair {
  const char *folder, *one, *other;
  bool is_same;
};
void PrintTo(const FieldPair& pair, std::ostream* out) { *out << pair.one << " " << pair.other; }

class FieldPictures : public testing::TestWithParam<FieldPair> {};

TEST_P(FieldPictures, AreTheSameWhereTheirStoredValuesAre) {
  const auto& [folder, one, other, is_same] = GetParam();
  const std::filesystem::path at = test::sharedData("../field") / folder;
  if (!std::filesystem::exists(at)) GTEST_SKIP() << "no field cases here: " << at;
  const auto first = readPicture(at / one), second = readPicture(at / other);
  ASSERT_TRUE(first.ok()) << first.error().text();
  ASSERT_TRUE(second.ok()) << second.error().text();
  EXPECT_EQ(*first == *second, is_same);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, FieldPictures,
    testing::Values(FieldPair{"38-png-kinds", "ga16.png", "ga16i.png", true},
                    FieldPair{"38-png-kinds", "pal4.png", "rgb.png", true},
                    FieldPair{"38-png-kinds", "pal8i.png", "rgb.png", true},
                    FieldPair{"38-png-kinds", "palt.png", "rgba.png", true},
                    FieldPair{"38-png-kinds", "key.png", "keya.png", true},
                    FieldPair{"38-png-kinds", "g1.png", "g8.png", true},
                    FieldPair{"38-png-kinds", "gam.png", "rgb.png", true},
                    FieldPair{"38-png-kinds", "r16.png", "rgb.png", true},
                    FieldPair{"37-transparent-rgb", "black0.png", "white0.png", false},
                    FieldPair{"37-transparent-rgb", "opaqueblack.png", "black0.png", false},
                    FieldPair{"37-transparent-rgb", "opaquewhite.png", "white0.png", false},
                    FieldPair{"39-exif-orientation", "exif3.png", "upright.png", false}));

}  // namespace
}  // namespace rocinante
