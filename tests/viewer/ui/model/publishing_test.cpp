#include "viewer/ui/model/publishing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/kept_datagrams.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/commands/key_commands.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

/// A window at the end of a session in which `ann` and `bob` publish their windows.
class ShownToOthers : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeSession(folder_ / "s.mcap",
                       {{0, "view ann 5 0 1 0 0 0 40\nview bob 0 5 1 0 0 0 40\n"},
                        {1000, "points pointer #ff0000 1 0 0\nline line-1 #ff0000 0 0 0 1 1 1\n"},
                        {2000, "view ann 6 0 1 0 0 0 40\n"}});
    auto cell = loadCell(folder_ / "arm.urdf", {});
    auto session = Timeline::open(folder_ / "s.mcap");
    auto model = ViewModel::make(std::move(*cell), std::move(*session), std::nullopt, {}, {});
    model_.emplace(std::move(*model));
    model_->cursor()->seek(model_->cursor()->start(), now_);
    update();
  }
  void publishAs(const std::string& name) {
    ASSERT_TRUE(
        model_->publishing.begin(std::make_unique<test::KeptDatagrams>(kept_), {name, "r"}));
    update();
  }
  void update() { ASSERT_TRUE(model_->update(now_).ok()); }
  Status run(const std::string& command, const std::vector<std::string>& words) {
    ViewerRequests requests;
    Status done = runCommand(command, words, {*model_, now_, 100, requests});
    update();
    return done;
  }
  std::size_t drawingsOf(const std::string& source) const {
    return static_cast<std::size_t>(
        std::ranges::count(model_->scene().drawings, source, &PosedDrawing::source));
  }

  const test::TemporaryFolder folder_;
  std::shared_ptr<test::KeptDatagrams::Kept> kept_ = std::make_shared<test::KeptDatagrams::Kept>();
  std::optional<ViewModel> model_;
  SteadyTime now_{};
};

TEST_F(ShownToOthers, WatchingGoesFromOneToTheNextAndFollows) {
  EXPECT_EQ(model_->viewsOfOthers(), (std::vector<std::string>{"ann", "bob"}));
  ASSERT_TRUE(run("watch", {}));
  EXPECT_EQ(model_->watched(), "ann");
  EXPECT_EQ(model_->cameraView().eye, (Vec3{5, 0, 1}));
  model_->cursor()->seek(model_->cursor()->end(), now_);
  update();
  EXPECT_EQ(model_->cameraView().eye, (Vec3{6, 0, 1}));
  ASSERT_TRUE(run("watch", {}));
  EXPECT_EQ(model_->watched(), "bob");
  ASSERT_TRUE(run("watch", {}));
  EXPECT_EQ(model_->watched(), "");
  EXPECT_NEAR(model_->cameraView().eye.y, 5, 1e-9);  // nothing jumps
  ASSERT_TRUE(run("watch", {"ann"}));
  ASSERT_TRUE(run("watch", {"off"}));
  EXPECT_EQ(model_->watched(), "");
  EXPECT_NE(run("watch", {"eve"}).error().what.find("ann, bob"), std::string::npos);
}

TEST_F(ShownToOthers, ItsOwnViewAndPointerAreNotShownToItself) {
  model_->cursor()->seek(model_->cursor()->end(), now_);
  update();
  EXPECT_EQ(drawingsOf("robot"), 2U);
  publishAs("robot");  // as if it heard itself
  EXPECT_EQ(drawingsOf("robot"), 1U);
  model_->publishing.end(now_, WallTime{});
  publishAs("ann");
  EXPECT_EQ(model_->viewsOfOthers(), std::vector<std::string>{"bob"});
}

TEST_F(ShownToOthers, WhatIsDrawnShowsHereThoughNobodySendsItBack) {
  publishAs("me");
  ASSERT_TRUE(run("draw", {}));
  EXPECT_TRUE(model_->publishing.takesClicks());
  model_->publishing.clicked(model_->scene(), {"arm", "hand"}, {1, 0, 0});
  model_->publishing.clicked(model_->scene(), {"arm", "hand"}, {1, 1, 0});
  update();
  EXPECT_EQ(drawingsOf("me"), 1U);
  ASSERT_TRUE(run("clear", {}));  // Esc
  EXPECT_FALSE(model_->publishing.takesClicks());
  ASSERT_TRUE(run("label", {"a", "worn", "edge"}));
  EXPECT_EQ(model_->publishing.label(), "a worn edge");
  model_->publishing.clicked(model_->scene(), {"arm", "hand"}, {1, 0, 0.2});
  EXPECT_FALSE(model_->publishing.takesClicks());
  update();
  ASSERT_EQ(drawingsOf("me"), 2U);
  EXPECT_EQ(model_->scene().drawings.back().drawing->carrier.second, "hand");
  ASSERT_TRUE(run("draw", {"none"}));
  EXPECT_EQ(drawingsOf("me"), 0U);
}

TEST_F(ShownToOthers, CommandsThatNeedIt) {
  for (const char* command : {"pointer", "draw"}) EXPECT_FALSE(run(command, {}));
  EXPECT_FALSE(run("say", {"x"}));
  EXPECT_FALSE(run("label", {"x"}));
  EXPECT_FALSE(run("publish", {"127.0.0.1:19999"}));
  EXPECT_FALSE(run("publish", {"127.0.0.1:19999,"}));
  EXPECT_FALSE(run("publish", {"nowhere at all,me"}));
  EXPECT_TRUE(run("publish", {"off"}));
  publishAs("me");
  EXPECT_TRUE(model_->publishing.points());
  EXPECT_TRUE(run("pointer", {"off"}));
  EXPECT_FALSE(model_->publishing.points());
}

}  // namespace
}  // namespace rocinante
