#include "viewer/ui/window/panel_colors.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace rocinante {
namespace {

std::string textOf(const ColorPair& pair) {
  std::string text(nameOf(pair.ink));
  for (const PanelColor ground : pair.grounds) text += " on " + std::string(nameOf(ground));
  return text;
}

TEST(PanelColors, AreReadOnEveryGroundInBothThemes) {
  for (const ColorPair& pair : colorPairs()) {
    for (const bool light : {false, true}) {
      EXPECT_GE(leastContrast(pair, light), pair.least)
          << textOf(pair) << (light ? ", light" : ", dark");
    }
  }
}

// A colour of text that no pair has is judged by nobody.
TEST(PanelColors, OfTextAreEachJudged) {
  std::set<PanelColor> judged;
  for (const ColorPair& pair : colorPairs()) {
    judged.insert(pair.ink);
    judged.insert(pair.grounds.begin(), pair.grounds.end());
  }
  for (std::size_t i = 0; i <= static_cast<std::size_t>(PanelColor::repeated_part_text); ++i) {
    EXPECT_TRUE(judged.contains(static_cast<PanelColor>(i))) << nameOf(static_cast<PanelColor>(i));
  }
}

TEST(PanelColors, ContrastIsThatOfWcag) {
  EXPECT_NEAR(contrastOf(0x000000FF, 0xFFFFFFFF), 21, 1e-9);
  EXPECT_NEAR(contrastOf(0x777777FF, 0xFFFFFFFF), 4.48, 0.005);
  EXPECT_NEAR(contrastOf(0xFFFFFFFF, 0x0000FFFF), 8.59, 0.005);
  EXPECT_EQ(contrastOf(0x123456FF, 0x123456FF), 1);
}

// White text on a translucent ground is judged over a white picture.
TEST(PanelColors, AreJudgedOverTheWorstPicture) {
  const ColorPair half{PanelColor::text, {PanelColor::plot_ground}};
  EXPECT_LT(leastContrast(half, false), 1.2);
  EXPECT_LT(leastContrast(half, true), 1.5);
}

TEST(PanelColors, BlackOrWhiteIsReadOnAnyColour) {
  for (std::uint32_t red = 0; red < 256; red += 15) {
    for (std::uint32_t green = 0; green < 256; green += 5) {
      for (std::uint32_t blue = 0; blue < 256; blue += 15) {
        const std::uint32_t ground = red << 24U | green << 16U | blue << 8U | 0xFFU;
        EXPECT_GE(contrastOf(blackOrWhiteOn(ground), ground), 4.5) << ground;
      }
    }
  }
}

TEST(PanelColors, OfCurvesBeginAnewAfterTheLast) {
  EXPECT_EQ(curveColorOf(0), PanelColor::curve_1);
  EXPECT_EQ(curveColorOf(19), PanelColor::curve_20);
  EXPECT_EQ(curveColorOf(20), PanelColor::curve_1);
  for (const bool light : {false, true}) {
    std::set<std::uint32_t> colors;
    for (std::size_t i = 0; i < 20; ++i) colors.insert(colorOf(curveColorOf(i), light));
    EXPECT_EQ(colors.size(), 20U);
  }
}

}  // namespace
}  // namespace rocinante
