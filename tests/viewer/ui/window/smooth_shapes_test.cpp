// Edges of the interface, to the last bit: an approximate root would be seen in each of these.
#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <utility>
#include <vector>

#include "viewer/ui/window/interface_context.h"

namespace rocinante {
namespace {

constexpr ImU32 kOrange = IM_COL32(255, 168, 64, 255);

using Corner = std::pair<float, float>;

class SmoothShapes : public testing::Test {
 protected:
  SmoothShapes() : interface_(nullptr) {
    ImGui::GetIO().Fonts->Build();
    interface_.beginFrame(320, 200);
    list_ = ImGui::GetForegroundDrawList();
  }
  ~SmoothShapes() override { ImGui::EndFrame(); }

  /// Of one shape drawn by `draw`.
  std::vector<Corner> corners() const {
    std::vector<Corner> all;
    for (const ImDrawVert& vertex : list_->VtxBuffer) all.emplace_back(vertex.pos.x, vertex.pos.y);
    return all;
  }
  /// Opacity of each vertex.
  std::vector<int> alphas() const {
    std::vector<int> all;
    for (const ImDrawVert& vertex : list_->VtxBuffer)
      all.push_back(static_cast<int>(vertex.col >> IM_COL32_A_SHIFT));
    return all;
  }
  /// Twice the area that is covered in full, and twice what is drawn at all.
  std::pair<double, double> areas() const {
    double full = 0;
    double all = 0;
    for (int i = 0; i + 2 < list_->IdxBuffer.Size; i += 3) {
      const ImDrawVert& a = list_->VtxBuffer[list_->IdxBuffer[i]];
      const ImDrawVert& b = list_->VtxBuffer[list_->IdxBuffer[i + 1]];
      const ImDrawVert& c = list_->VtxBuffer[list_->IdxBuffer[i + 2]];
      const double area = std::abs((b.pos.x - a.pos.x) * (c.pos.y - a.pos.y) -
                                   (c.pos.x - a.pos.x) * (b.pos.y - a.pos.y));
      all += area;
      if (((a.col & b.col & c.col) & IM_COL32_A_MASK) == IM_COL32_A_MASK) full += area;
    }
    return {full, all};
  }

  InterfaceContext interface_;
  ImDrawList* list_ = nullptr;
};

// 3, 4, 5: its side is 0.8, -0.6 to the last bit.
TEST_F(SmoothShapes, ALineFadesOverAPixelOnEachSide) {
  const ImVec2 points[] = {{10, 20}, {13, 24}};
  list_->AddPolyline(points, 2, kOrange, 0, 3);
  const float x = 4.0F / 5.0F;
  const float y = -3.0F / 5.0F;
  EXPECT_EQ(corners(), (std::vector<Corner>{{10 + x * 2, 20 + y * 2},
                                            {10 + x, 20 + y},
                                            {10 - x, 20 - y},
                                            {10 - x * 2, 20 - y * 2},
                                            {13 + x * 2, 24 + y * 2},
                                            {13 + x, 24 + y},
                                            {13 - x, 24 - y},
                                            {13 - x * 2, 24 - y * 2}}));
  EXPECT_EQ(alphas(), (std::vector<int>{0, 255, 255, 0, 0, 255, 255, 0}));
  EXPECT_EQ(list_->IdxBuffer.Size, 18);
  EXPECT_NEAR(areas().first, 2 * 5 * 2, 1e-4);
  EXPECT_NEAR(areas().second, 2 * 5 * 4, 1e-4);
}

// What Dear ImGui's own functions draw goes the same way.
TEST_F(SmoothShapes, ImGuisOwnLinesRectanglesAndCirclesAreExact) {
  list_->AddLine({10, 20}, {19, 20}, kOrange);
  EXPECT_EQ(corners(), (std::vector<Corner>{{10.5F, 19.5F},
                                            {10.5F, 20.5F},
                                            {10.5F, 20.5F},
                                            {10.5F, 21.5F},
                                            {19.5F, 19.5F},
                                            {19.5F, 20.5F},
                                            {19.5F, 20.5F},
                                            {19.5F, 21.5F}}));
  list_->VtxBuffer.resize(0);
  list_->AddQuadFilled({40, 40}, {47, 40}, {47, 50}, {40, 50}, kOrange);
  EXPECT_EQ(corners(), (std::vector<Corner>{{40.5F, 40.5F},
                                            {39.5F, 39.5F},
                                            {46.5F, 40.5F},
                                            {47.5F, 39.5F},
                                            {46.5F, 49.5F},
                                            {47.5F, 50.5F},
                                            {40.5F, 49.5F},
                                            {39.5F, 50.5F}}));
}

TEST_F(SmoothShapes, ACircleIsAsLargeAsItsRadius) {
  list_->AddCircleFilled({100, 100}, 30, kOrange);
  const auto [full, all] = areas();
  EXPECT_NEAR(full / 2, M_PI * 29.5 * 29.5, 40);
  EXPECT_NEAR(all / 2, M_PI * 30.5 * 30.5, 40);
}

TEST_F(SmoothShapes, AClosedLineMeetsItself) {
  const ImVec2 points[] = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  list_->AddPolyline(points, 4, kOrange, ImDrawFlags_Closed, 1);
  ASSERT_EQ(list_->VtxBuffer.Size, 16);
  ASSERT_EQ(list_->IdxBuffer.Size, 4 * 18);
  EXPECT_EQ(corners()[0], Corner(-1, -1));
  EXPECT_EQ(corners()[3], Corner(1, 1));
  EXPECT_NEAR(areas().second / 2, 10 * 10 - 6 * 6, 1e-4);
}

TEST_F(SmoothShapes, PointsThatFallTogetherAndColoursThatDoNotShowAreHarmless) {
  const ImVec2 points[] = {{5, 5}, {5, 5}, {5, 5}};
  list_->AddPolyline(points, 3, kOrange, 0, 1);
  list_->AddConvexPolyFilled(points, 3, kOrange);
  for (const auto& [x, y] : corners()) {
    EXPECT_EQ(x, 5);
    EXPECT_EQ(y, 5);
  }
  const int before = list_->VtxBuffer.Size;
  list_->AddPolyline(points, 3, kOrange & ~IM_COL32_A_MASK, 0, 1);
  list_->AddPolyline(points, 1, kOrange, 0, 1);
  list_->AddConvexPolyFilled(points, 2, kOrange);
  EXPECT_EQ(list_->VtxBuffer.Size, before);
}

}  // namespace
}  // namespace rocinante
