// A gradient that is copied is the gradient that was drawn, wherever it lands.
#include "viewer/passes/background_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "viewer/gl/frame_buffer.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/gl/render_context.h"

namespace rocinante {
namespace {

class Background : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    auto context = makeOffscreenContext(Profile::reproducible);
    ASSERT_TRUE(context.has_value());
    context_ = std::move(*context);
    auto gl = fillGlTable([&](const char* name) { return context_->procAddress(name); });
    ASSERT_TRUE(gl.has_value());
    gl_ = *gl;
    pass_.emplace(gl_);
    const Status ready = pass_->prepare();
    ASSERT_TRUE(ready.has_value()) << ready.error().text();
    look_.background_top = {0.2F, 0.4F, 0.6F};
    look_.background_bottom = {0.8F, 0.6F, 0.4F};
  }
  void TearDown() override { pass_.reset(); }

  /// A frame of `sides`, green where the pass drew nothing.
  Picture drawn(int sides, const PixelRectangle& part) {
    const auto target = FrameBuffer::create(gl_, sides, sides, GetParam());
    EXPECT_TRUE(target.has_value());
    target->bind();
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.ClearColor(0, 1, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    pass_->draw(look_, part, sides);
    gl_.Disable(GL_SCISSOR_TEST);
    target->resolve();
    return target->read();
  }

  std::unique_ptr<RenderContext> context_;
  GlTable gl_;
  std::optional<BackgroundPass> pass_;
  CellScene look_;
};

const std::uint8_t* pixel(const Picture& picture, int x, int y) {
  return picture.rgba.data() + (static_cast<std::size_t>(y * picture.width + x)) * 4;
}

TEST_P(Background, RunsFromTopToBottomAndIsOpaque) {
  const Picture frame = drawn(40, {0, 0, 40, 40});
  for (int x = 0; x < 40; ++x) {
    EXPECT_NEAR(pixel(frame, x, 0)[0], 0.2 * 255, 3);
    EXPECT_NEAR(pixel(frame, x, 39)[0], 0.8 * 255, 3);
    for (int y = 0; y < 40; ++y) ASSERT_EQ(pixel(frame, x, y)[3], 255);
  }
}

TEST_P(Background, TheSecondTimeIsTheFirst) {
  const Picture first = drawn(40, {0, 0, 40, 40});
  EXPECT_EQ(drawn(40, {0, 0, 40, 40}).rgba, first.rgba);
  // More sizes and colours than are kept.
  for (int sides = 20; sides < 30; ++sides) drawn(sides, {0, 0, sides, sides});
  const CellScene before = look_;
  look_.background_top = {0, 0, 0};
  EXPECT_NE(drawn(40, {0, 0, 40, 40}).rgba, first.rgba);
  look_ = before;
  EXPECT_EQ(drawn(40, {0, 0, 40, 40}).rgba, first.rgba);
}

TEST_P(Background, APartIsThatPartAlone) {
  const Picture whole = drawn(16, {0, 0, 16, 16});
  const Picture frame = drawn(40, {7, 3, 16, 16});
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool inside = x >= 7 && x < 23 && y >= 3 && y < 19;
      const std::uint8_t outside[] = {0, 255, 0, 0};
      const std::uint8_t* const wanted = inside ? pixel(whole, x - 7, y - 3) : outside;
      ASSERT_TRUE(std::equal(wanted, wanted + 4, pixel(frame, x, y))) << x << ", " << y;
    }
  }
}

TEST_P(Background, OneTooLargeToKeepIsDrawnEachTime) {
  const int sides = GetParam() == 1 ? 4200 : 2100;  // 67 MiB
  const Picture first = drawn(sides, {0, 0, sides, sides});
  EXPECT_EQ(drawn(sides, {0, 0, sides, sides}).rgba, first.rgba);
  EXPECT_NEAR(pixel(first, sides - 1, 0)[2], 0.6 * 255, 1);
  EXPECT_NEAR(pixel(first, sides - 1, sides - 1)[2], 0.4 * 255, 1);
}

INSTANTIATE_TEST_SUITE_P(Samples, Background, ::testing::Values(1, 4));

}  // namespace
}  // namespace rocinante
