#include "core/series/series_key.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(SeriesKey, TextIsReadBack) {
  for (const char* text : {"arm.shoulder", "arm.wrist.1", "tray:x", "cell:arm:qw", "rate", "loss",
                           "rate/controller", "loss/a/b", "signal arm mode", "signal arm/tip a%20b",
                           "signal - estop", "signal %2D odd"}) {
    const auto key = parseSeriesKey(text);
    ASSERT_TRUE(key.has_value()) << text;
    EXPECT_EQ(key->text(), text);
  }
  const auto wrist = parseSeriesKey("arm.wrist.1");
  EXPECT_EQ(wrist->name, "arm");
  EXPECT_EQ(wrist->part, "wrist.1");
  EXPECT_EQ(parseSeriesKey("cell:arm:qw")->name, "cell:arm");
}

TEST(SeriesKey, OtherTextIsRefused) {
  for (const char* text :
       {"", "arm", "arm.", ".j", "arm:w", ":x", "rate/", "rates", "signal arm", "signal layer/x y",
        "signal a b c", "signal arm load 5", "signal arm x 1\nremove arm"}) {
    EXPECT_FALSE(parseSeriesKey(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace rocinante
