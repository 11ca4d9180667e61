// A picture that is drawn in slices has the pixels of one drawn at once.
#include "viewer/render/rest_picture.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tests/viewer/render/looks_studio.h"

namespace rocinante {
namespace {

constexpr int kWidth = 150, kHeight = 110;

class RestPictureTest : public testing::Test {
 protected:
  void SetUp() override {
    cell_.cell().scene.grid = true;
    cell_.cell().scene.background_top = {0.3F, 0.4F, 0.6F};
    cell_.add("box", boxMesh({2, 2, 2}), {1, 0, 1}, test::colored(1, 0, 0))
        .add("wall", test::squareMesh(6), {0, 2, 0}, test::colored(0, 0.6F, 0.4F))
        .add("glass", boxMesh({1, 1, 3}), {-1, -1, 0}, test::colored(0, 0, 1));
    scene_ = cell_.scene();
    auto context = makeOffscreenContext(Profile::reproducible);
    ASSERT_TRUE(context.has_value());
    context_ = std::move(*context);
    auto renderer = Renderer::create(*context_, cell_.cell(), Profile::reproducible);
    ASSERT_TRUE(renderer.has_value()) << renderer.error().text();
    renderer_.emplace(std::move(*renderer));
    view_.eye = {3, -14, 6};
    insets_ = {{{4, 30, 50, 40}, test::frontView(), "front", 0x14181CFF, 1},
               {{90, 60, 56, 46}, view_, "", 0xFF0000FF, 2}};
  }

  SceneFrame frameOf(const RenderStyle& style) const {
    SceneFrame frame{&scene_, view_, &choice_, &style};
    frame.insets = insets_;
    return frame;
  }

  Picture atOnce(const RenderStyle& style, int samples) {
    auto target = FrameBuffer::create(renderer_->gl(), kWidth, kHeight, samples);
    EXPECT_TRUE(target.has_value());
    EXPECT_TRUE(renderer_->draw(frameOf(style), *target).has_value());
    target->resolve();
    return target->read();
  }

  Picture inSlices(const RenderStyle& style, int samples, const std::vector<int>& slices,
                   bool others_between = true) {
    RestPicture rest;
    int drawn = 0;
    for (const int rows : slices) {
      const Status done = rest.drawRows(*renderer_, frameOf(style), kWidth, kHeight, samples, drawn,
                                        std::min(rows, kHeight - drawn));
      EXPECT_TRUE(done.has_value()) << done.error().text();
      drawn = std::min(drawn + rows, kHeight);
      if (others_between) atOnce(style, 1);
    }
    EXPECT_EQ(drawn, kHeight);
    return rest.picture().read();
  }

  test::TestCell cell_;
  PosedScene scene_;
  ViewChoice choice_;
  CameraView view_;
  std::vector<FrameInset> insets_;
  std::unique_ptr<RenderContext> context_;
  std::optional<Renderer> renderer_;
};

TEST_F(RestPictureTest, SlicesHaveThePixelsOfTheWhole) {
  const std::vector<std::vector<std::string>> looks = {
      {},
      {"shadows=on", "edges=on"},
      {"shadows=on", "contact=on"},
      {"transparent=glass@0.4", "outlined=box", "scale-bar=on"},
      {"wireframe=wall", "edges=only"}};
  for (const auto& words : looks) {
    const RenderStyle style = test::styled(words);
    for (const int samples : {1, 4}) {
      SCOPED_TRACE(testing::PrintToString(words) + std::to_string(samples));
      const Picture whole = atOnce(style, samples);
      EXPECT_TRUE(inSlices(style, samples, {kHeight}) == whole);
      EXPECT_TRUE(inSlices(style, samples, {1, 33, 7, 40, 29}) == whole);
      EXPECT_TRUE(inSlices(style, samples, std::vector<int>(10, 11)) == whole);
      EXPECT_TRUE(inSlices(style, samples, std::vector<int>(10, 11), false) == whole);
    }
  }
}

}  // namespace
}  // namespace rocinante
