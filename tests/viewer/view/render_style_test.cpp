#include "viewer/view/render_style.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

RenderStyle styleSaid(const std::vector<std::string>& words) {
  RenderStyle style;
  for (const std::string& word : words) {
    const Status set = setStyle(style, word);
    EXPECT_TRUE(set.has_value()) << word << ": " << (set ? "" : set.error().text());
  }
  return style;
}

TEST(RenderStyle, SaysNothingByDefault) {
  EXPECT_TRUE(styleWords(RenderStyle{}).empty());
  EXPECT_EQ(styleSaid({"shadows=off", "edges=off", "shading=standard"}), RenderStyle{});
}

TEST(RenderStyle, ComesBackFromItsOwnWords) {
  const RenderStyle style = styleSaid({"shading=plain",
                                       "edges=only",
                                       "labels=apart",
                                       "ghosts=clear",
                                       "limits=on",
                                       "clearance",
                                       "scale-bar",
                                       "camera-cone",
                                       "layer-looks=off",
                                       "outlined=arm",
                                       "outlined=gantry/x",
                                       "wireframe=*",
                                       "transparent=hall@0.25",
                                       "collision=arm",
                                       "collision-over=layer/robots",
                                       "trail=arm/tool0@2.5s",
                                       "trail=gantry@250ms",
                                       "axes=arm",
                                       "axes=gantry/x",
                                       "measure=arm/tool0@0,0,0.1~gantry@1,2,3",
                                       "lengths=m"});
  RenderStyle again;
  for (const auto& [key, value] : styleWords(style)) {
    ASSERT_TRUE(setStyle(again, key, value).has_value()) << key << "=" << value;
  }
  EXPECT_EQ(again, style);
  EXPECT_EQ(style.transparent.at(0).opacity, 0.25);
  EXPECT_EQ(style.trails.at(1).window, std::chrono::milliseconds(250));
}

TEST(RenderStyle, HasEveryKeyInItsWords) {
  for (const StyleKey& key : styleKeys()) {
    RenderStyle style;
    // The last value that is written is one that differs from the default, or the key is a switch.
    const std::string values(key.values);
    const bool path = values.rfind("PATH", 0) == 0;
    bool any = false;
    for (const char* value :
         {"arm/tool", "plain", "on", "apart", "clear", "off", "m", "arm/tool@0,0,0~arm@0,0,1"}) {
      RenderStyle one;
      if (setStyle(one, key.key, value) && !(one == style)) {
        any = true;
        ASSERT_EQ(styleWords(one).size(), 1U) << key.key;
        EXPECT_EQ(styleWords(one)[0].first, key.key);
        EXPECT_EQ(path, std::string(value).starts_with("arm/tool")) << key.key;
      }
      if (any) break;
    }
    EXPECT_TRUE(any) << key.key;
    EXPECT_EQ(key.repeats, path) << key.key;
  }
}

TEST(RenderStyle, TakesUnderscoresAndTrueAsFilesWriteThem) {
  EXPECT_EQ(styleSaid({"scale_bar=true", "collision_over=arm"}),
            styleSaid({"scale-bar=on", "collision-over=arm"}));
}

TEST(RenderStyle, RefusesWhatItDoesNotKnowAndStaysAsItWas) {
  for (const char* word :
       {"shadow", "shadows=yes", "edges=thick", "outlined=", "outlined=layer", "wireframe=a%2",
        "transparent=arm@1.5", "transparent=arm@nan", "transparent=arm@", "trail=arm@0",
        "trail=arm@-1s", "trail=arm@25h", "trail=layer/robots", "trail=*", "trail=arm#hand",
        "collision=arm#hand", "shading=plain", "=", ""}) {
    RenderStyle style = styleSaid({"shadows", "trail=arm"});
    const RenderStyle before = style;
    EXPECT_FALSE(setStyle(style, word).has_value()) << word;
    EXPECT_EQ(style, before) << word;
  }
}

TEST(RenderStyle, ContactComesBackAndIsNotOfPlainLight) {
  RenderStyle style = styleSaid({"contact"});
  EXPECT_EQ(styleWords(style),
            (std::vector<std::pair<std::string, std::string>>{{"contact", "on"}}));
  const Status refused = setStyle(style, "shading=plain");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().what,
            "plain shading draws no contact: leave out one of the two styles");
  EXPECT_EQ(style, styleSaid({"contact=on"}));
}

TEST(RenderStyle, NamesThingsOnce) {
  EXPECT_EQ(styleSaid({"outlined=arm", "outlined=arm"}).outlined.size(), 1U);
}

}  // namespace
}  // namespace rocinante
