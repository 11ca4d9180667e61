#include "core/series/series_key.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(SeriesKey, TextIsReadBack) {
  for (const char* text :
       {"arm.shoulder", "arm.wrist.1", "tray:x", "cell:arm:qw", "rate", "loss", "rate/controller",
        "loss/a/b", "signal arm mode", "signal arm/tip a%20b", "signal - estop", "signal %2D odd",
        "arm/tool0:x", "arm/tool0:qw in gantry", "arm/tool0:z in other arm/base", "arm/a:b/c:y",
        "arm/x in y:z"}) {
    const auto key = parseSeriesKey(text);
    ASSERT_TRUE(key.has_value()) << text;
    EXPECT_EQ(key->text(), text);
  }
  const auto wrist = parseSeriesKey("arm.wrist.1");
  EXPECT_EQ(wrist->name, "arm");
  EXPECT_EQ(wrist->part, "wrist.1");
  EXPECT_EQ(parseSeriesKey("cell:arm:qw")->name, "cell:arm");
  const auto tool = parseSeriesKey("arm/tool0:qx in other/base:x in y");
  EXPECT_EQ(tool->kind, SeriesKey::Kind::link);
  EXPECT_EQ(tool->name, "arm");
  EXPECT_EQ(tool->link, "tool0");
  EXPECT_EQ(tool->part, "qx");
  EXPECT_EQ(tool->frame, "other");
  EXPECT_EQ(tool->frame_link, "base:x in y");
}

TEST(SeriesKey, OtherTextIsRefused) {
  for (const char* text : {"",
                           "arm",
                           "arm.",
                           ".j",
                           "arm:w",
                           ":x",
                           "rate/",
                           "rates",
                           "signal arm",
                           "signal layer/x y",
                           "signal a b c",
                           "signal arm load 5",
                           "signal arm x 1\nremove arm",
                           "arm/:x",
                           "/tool0:x",
                           "arm/tool0",
                           "arm/tool0:x in",
                           "arm/tool0:x in ",
                           "arm/tool0:w",
                           "arm:x in gantry",
                           "arm/tool0:x in a/"}) {
    EXPECT_FALSE(parseSeriesKey(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace rocinante
