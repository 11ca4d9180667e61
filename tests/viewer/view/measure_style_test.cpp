#include "viewer/view/measure_style.h"

#include <gtest/gtest.h>

#include "viewer/view/render_style.h"

namespace rocinante {
namespace {

TEST(MeasureStyle, ComesBackFromItsText) {
  const auto measure = parseMeasure("arm%201/hand@0.1,-2e-3,0.3333333333333333~tray@0,0,0");
  ASSERT_TRUE(measure.has_value());
  EXPECT_EQ(measure->from.path, "arm%201/hand");
  EXPECT_EQ(measure->from.at, Vec3(0.1, -0.002, 1.0 / 3));
  EXPECT_EQ(measure->to.path, "tray");
  EXPECT_EQ(parseMeasure(measureText(*measure)), measure);
}

TEST(MeasureStyle, RefusesWhatIsNoTwoPointsOfLinks) {
  for (const char* text :
       {"", "arm", "arm@0,0,0", "arm@0,0~b@0,0,0", "arm@0,0,0~b", "*@0,0,0~b@0,0,0",
        "layer/x@0,0,0~b@0,0,0", "arm#g@0,0,0~b@0,0,0", "arm@0,0,nan~b@0,0,0",
        "arm@0,0,0,0~b@0,0,0", "@0,0,0~b@0,0,0", "arm@0,0,0~b@0,0,0~c@0,0,0"}) {
    EXPECT_FALSE(parseMeasure(text).has_value()) << text;
  }
}

TEST(MeasureStyle, OfADeviceThatIsNotThereHasNoLength) {
  const PosedScene nothing;
  const auto measure = parseMeasure("a@0,0,0~b@0,0,1");
  ASSERT_TRUE(measure.has_value());
  EXPECT_FALSE(distanceOf(*measure, nothing).has_value());
}

}  // namespace
}  // namespace rocinante
