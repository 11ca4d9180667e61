#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/viewer/support/test_scene.h"
#include "viewer/gl/offscreen_context.h"
#include "viewer/render/renderer.h"

namespace rocinante::test {

struct Rgb {
  int r, g, b;
  int sum() const { return r + g + b; }
  bool operator==(const Rgb&) const = default;
};
inline void PrintTo(const Rgb& color, std::ostream* out) {
  *out << "(" << color.r << ", " << color.g << ", " << color.b << ")";
}

inline Rgb at(const Picture& picture, int x, int y) {
  const std::uint8_t* p = &picture.rgba[static_cast<std::size_t>(y * picture.width + x) * 4];
  EXPECT_EQ(p[3], 255) << "a frame is opaque";
  return {p[0], p[1], p[2]};
}

/// 10 m high at the plane y = 0: 16 pixels a metre, (80, 80) in the middle.
inline CameraView frontView() {
  CameraView view;
  view.eye = {0, -20, 0};
  view.target = {0, 0, 0};
  view.ortho_height_m = 10;
  return view;
}

inline RenderStyle styled(const std::vector<std::string>& words) {
  RenderStyle style;
  for (const std::string& word : words) EXPECT_TRUE(setStyle(style, word).has_value()) << word;
  return style;
}

/// One context and one renderer for all pictures of a cell.
class Studio {
 public:
  explicit Studio(TestCell& cell, int samples = 1) : scene_(cell.scene()) {
    auto context = makeOffscreenContext(Profile::reproducible);
    EXPECT_TRUE(context.has_value());
    context_ = std::move(*context);
    auto renderer = Renderer::create(*context_, cell.cell(), Profile::reproducible);
    EXPECT_TRUE(renderer.has_value()) << renderer.error().text();
    renderer_.emplace(std::move(*renderer));
    auto target = FrameBuffer::create(renderer_->gl(), 160, 160, samples);
    EXPECT_TRUE(target.has_value());
    target_.emplace(std::move(*target));
  }

  Picture drawn(const std::vector<std::string>& words, const CameraView& view = frontView(),
                const std::vector<std::string>& hide = {"layer/gnomon"},
                const FrameExtras& extras = {}) {
    const RenderStyle style = styled(words);
    const auto choice = ViewChoice::make(hide, {});
    EXPECT_TRUE(choice.has_value());
    SceneFrame frame{&scene_, view, &*choice, &style, &extras};
    const auto counts = renderer_->draw(frame, *target_);
    EXPECT_TRUE(counts.has_value()) << (counts ? "" : counts.error().text());
    target_->resolve();
    return target_->read();
  }

  /// Whose each pixel of such a frame is ("name", empty: nobody's), and whether depth agrees.
  std::vector<std::string> owners(const std::vector<std::string>& words) {
    const RenderStyle style = styled(words);
    const ViewChoice choice;
    const SceneFrame frame{&scene_, frontView(), &choice, &style};
    const auto ids = renderer_->identity(frame, *target_);
    const auto depth = renderer_->depth(frame, *target_);
    EXPECT_TRUE(ids.has_value() && depth.has_value());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < ids->ids.size(); ++i) {
      EXPECT_EQ(std::isfinite(depth->metres[i]), ids->ids[i] != 0) << i;
      names.push_back(ids->ids[i] == 0 ? "" : ids->names[ids->ids[i] - 1].device);
    }
    return names;
  }

  /// What a click on such a frame of 160x160 pixels meets.
  std::optional<PickedLink> picked(double x, double y, const std::vector<std::string>& words = {},
                                   const CameraView& view = frontView(),
                                   const std::vector<std::string>& hide = {},
                                   const std::vector<FrameInset>& insets = {}) {
    const RenderStyle style = styled(words);
    const auto choice = ViewChoice::make(hide, {});
    EXPECT_TRUE(choice.has_value());
    SceneFrame frame{&scene_, view, &*choice, &style};
    frame.insets = insets;
    auto met = renderer_->pick(frame, 160, 160, x, y);
    EXPECT_TRUE(met.has_value()) << (met ? "" : met.error().text());
    return met ? *met : std::nullopt;
  }

  PosedScene& scene() { return scene_; }

 private:
  PosedScene scene_;
  std::unique_ptr<RenderContext> context_;
  std::optional<Renderer> renderer_;
  std::optional<FrameBuffer> target_;
};

inline int differingPixels(const Picture& a, const Picture& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    count += std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]) ? 0 : 1;
  }
  return count;
}

}  // namespace rocinante::test
