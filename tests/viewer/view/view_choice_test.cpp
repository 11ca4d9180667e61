#include "viewer/view/view_choice.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

/// A device `arm` in the layer `robots` with the links `base` and `a/b`.
class Seen {
 public:
  Seen() {
    model_.links.resize(2);
    model_.links[0].name = "base";
    model_.links[1].name = "a/b";
    device_.name = "arm";
    device_.model = &model_;
    device_.layer = "robots";
    device_.link_visible = {true, true};
  }
  bool part(const std::vector<std::string>& hide, const std::vector<std::string>& show,
            std::size_t link, const std::string& group) const {
    const auto choice = ViewChoice::make(hide, show);
    EXPECT_TRUE(choice.has_value());
    return choice && choice->partVisible(device_, link, group);
  }

 private:
  Model model_;
  PosedDevice device_;
};

TEST(ViewChoice, LeavesOutAPartByItsGroup) {
  const Seen seen;
  EXPECT_FALSE(seen.part({"arm/base#window*"}, {}, 0, "window_3"));
  EXPECT_TRUE(seen.part({"arm/base#window*"}, {}, 0, "wall"));
  EXPECT_TRUE(seen.part({"arm/base#window*"}, {}, 1, "window_3"));
  EXPECT_FALSE(seen.part({"arm#window*"}, {}, 1, "window_3"));
  EXPECT_FALSE(seen.part({"*#window*"}, {}, 1, "window_3"));
  EXPECT_TRUE(seen.part({"gantry#window*"}, {}, 1, "window_3"));
}

TEST(ViewChoice, ShowsOnePartOfWhatIsHidden) {
  const Seen seen;
  EXPECT_TRUE(seen.part({"arm"}, {"arm#hand"}, 0, "hand"));
  EXPECT_FALSE(seen.part({"arm"}, {"arm#hand"}, 0, "fist"));
  EXPECT_TRUE(seen.part({"arm#hand"}, {"arm/base#hand"}, 0, "hand"));
  EXPECT_FALSE(seen.part({"arm#hand"}, {"arm/base#hand"}, 1, "hand"));
}

TEST(ViewChoice, AStarIsEveryDeviceAndTheNearestChoiceDecides) {
  const Seen seen;
  EXPECT_FALSE(seen.part({"*"}, {}, 0, ""));
  EXPECT_TRUE(seen.part({"*"}, {"arm"}, 0, ""));
  EXPECT_TRUE(seen.part({"*"}, {"layer/robots"}, 0, ""));
  EXPECT_FALSE(seen.part({"*/base"}, {"arm"}, 0, ""));
  EXPECT_TRUE(seen.part({"*/base"}, {"arm/base"}, 0, ""));
  EXPECT_FALSE(seen.part({"arm"}, {"arm"}, 0, "")) << "hidden and shown is hidden";
}

TEST(ViewChoice, ALinksNameMayHoldASlashAndAnEncodedNumberSign) {
  const Seen seen;
  EXPECT_FALSE(seen.part({"arm/a/b"}, {}, 1, ""));
  EXPECT_FALSE(seen.part({"arm/a%2Fb"}, {}, 1, ""));
  EXPECT_FALSE(seen.part({"arm#a%23b"}, {}, 1, "a#b"));
}

TEST(ViewChoice, RefusesWhatIsNoPath) {
  for (const char* text : {"", "/", "arm/", "/base", "layer", "layer/x#y", "arm#", "#x", "a%zz"}) {
    EXPECT_FALSE(ViewChoice::make({text}, {}).has_value()) << text;
    EXPECT_FALSE(ViewChoice::make({}, {text}).has_value()) << text;
  }
}

}  // namespace
}  // namespace rocinante
