#include "viewer/ui/window/panel_texts.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "viewer/ui/window/interface_context.h"
#include "viewer/ui/window/panel_style.h"

namespace rocinante {
namespace {

constexpr ImGuiWindowFlags kPlain =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings;

class PanelTexts : public testing::Test {
 protected:
  void SetUp() override { ImGui::GetIO().Fonts->Build(); }
  /// Of the third frame: a panel appears over two.
  std::vector<PanelText> drawn(const std::function<void()>& draw) {
    for (int i = 0; i < 3; ++i) {
      interface_.beginFrame(400, 300);
      draw();
      ImGui::Render();
    }
    return panelTexts(*ImGui::GetDrawData());
  }
  /// A panel at (40, 20).
  static void panel(const char* name, ImVec2 size, const std::function<void()>& content,
                    ImGuiWindowFlags flags = kPlain) {
    ImGui::SetNextWindowPos(ImVec2(40, 20));
    ImGui::SetNextWindowSize(size);
    ImGui::SetNextWindowBgAlpha(1);
    ImGui::Begin(name, nullptr, flags);
    content();
    ImGui::End();
  }
  std::vector<PanelText> panelWith(const std::function<void()>& content) {
    return drawn([&] { panel("Scene", ImVec2(300, 100), content); });
  }

  InterfaceContext interface_{nullptr};
};

TEST_F(PanelTexts, AreReadFromTheTriangles) {
  const auto texts = panelWith([] { ImGui::TextUnformatted("two words, é"); });
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts[0].panel, "Scene");
  EXPECT_EQ(texts[0].text, "two words, é");
  EXPECT_FALSE(texts[0].isCut());
  EXPECT_FALSE(texts[0].isFaint());
  const ImVec2 size = ImGui::CalcTextSize("two words, é");
  EXPECT_NEAR(texts[0].place.width, size.x, 4);
  EXPECT_GE(texts[0].place.x, 40);
  EXPECT_LE(texts[0].place.y + texts[0].place.height, 20 + 100);
}

TEST_F(PanelTexts, HaveTheContrastOfTheTable) {
  for (const bool light : {false, true}) {
    interface_.useTheme(light);
    const auto texts = panelWith([] { ImGui::TextDisabled("dim"); });
    ASSERT_EQ(texts.size(), 1U);
    EXPECT_NEAR(texts[0].contrast,
                contrastOf(colorOf(PanelColor::dim_text, light), colorOf(PanelColor::panel, light)),
                0.01);
  }
}

TEST_F(PanelTexts, ThatAreFaintAreFound) {
  const auto texts = panelWith([] {
    ImGui::TextColored(ImVec4(0.35F, 0.35F, 0.35F, 1), "grey");
    ImGui::TextColored(ImVec4(1, 1, 1, 0.3F), "clear");
    ImGui::TextUnformatted("well");
  });
  ASSERT_EQ(texts.size(), 3U);
  EXPECT_TRUE(texts[0].isFaint());
  EXPECT_TRUE(texts[1].isFaint());
  EXPECT_FALSE(texts[2].isFaint());
}

TEST_F(PanelTexts, StandOnWhatTheirWorstPixelHas) {
  const auto texts = panelWith([] {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float half = ImGui::CalcTextSize("half ").x;
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(at.x + half, at.y), ImVec2(at.x + 200, at.y + 30), IM_COL32(230, 230, 230, 255));
    ImGui::TextUnformatted("half and half");
  });
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NEAR(texts[0].contrast, contrastOf(0xFFFFFFFF, 0xE6E6E6FF), 0.05);
}

// Which picture a panel without a ground lies on is nobody's choice.
TEST_F(PanelTexts, OverThePictureAreOverTheWorstOne) {
  const auto texts = drawn([] {
    panel(
        "bare", ImVec2(300, 100), [] { ImGui::TextUnformatted("white"); },
        kPlain | ImGuiWindowFlags_NoBackground);
  });
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_NEAR(texts[0].contrast, 1, 0.01);
}

TEST_F(PanelTexts, AreSeenThroughWhatIsClearAlone) {
  const auto with = [&](ImU32 above) {
    return drawn([above] {
      panel("Scene", ImVec2(300, 100), [] { ImGui::TextUnformatted("below"); });
      ImGui::GetForegroundDrawList()->AddRectFilled(ImVec2(0, 0), ImVec2(400, 300), above);
    });
  };
  EXPECT_TRUE(with(IM_COL32(200, 200, 200, 255)).empty());
  const auto texts = with(IM_COL32(200, 200, 200, 220));
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_TRUE(texts[0].isFaint());
  ASSERT_EQ(with(IM_COL32(0, 0, 0, 10)).size(), 1U);
  EXPECT_FALSE(with(IM_COL32(0, 0, 0, 10))[0].isFaint());
}

TEST_F(PanelTexts, ThatTheirPanelCutsAreFound) {
  const auto cut = [&](float room) {
    const auto texts = drawn([room] {
      panel("Scene", ImVec2(room, 100), [] { ImGui::TextUnformatted("MMMMMMMMMMMMMMMM"); });
    });
    return !texts.empty() && texts[0].isCut();
  };
  EXPECT_FALSE(cut(300));
  int found = 0;
  for (int room = 60; room < 80; ++room) found += cut(static_cast<float>(room)) ? 1 : 0;
  EXPECT_GE(found, 14);  // not where the cut is between two letters
}

// Dear ImGui cuts what a control says by itself.
TEST_F(PanelTexts, ThatTheirControlCutsAreFound) {
  int found = 0;
  for (int wide = 30; wide < 50; ++wide) {
    const auto texts = panelWith([wide] {
      ImGui::Selectable("MMMMMMMM##row", false, 0, ImVec2(static_cast<float>(wide), 0));
    });
    ASSERT_EQ(texts.size(), 1U);
    found += texts[0].isCut() ? 1 : 0;
  }
  EXPECT_GE(found, 14);
}

TEST_F(PanelTexts, ThatScrollMayBeCutAboveAndBelow) {
  const auto rows = [&](bool scrolls) {
    return drawn([scrolls] {
      const float line = ImGui::GetTextLineHeightWithSpacing();
      panel("Scene", ImVec2(200, 200), [&] {
        ImGui::BeginChild("rows", ImVec2(0, line * 2.5F), false,
                          scrolls ? 0 : ImGuiWindowFlags_NoScrollbar);
        ImGui::TextUnformatted("Mg");
        ImGui::TextUnformatted("Mg");
        if (scrolls) {
          for (int i = 0; i < 20; ++i) ImGui::TextUnformatted("Mg");
        } else {
          ImGui::GetWindowDrawList()->AddText(ImGui::GetCursorScreenPos(), IM_COL32_WHITE, "Mg");
        }
        ImGui::EndChild();
      });
    });
  };
  EXPECT_TRUE(std::ranges::none_of(rows(true), &PanelText::isCut));
  EXPECT_TRUE(std::ranges::any_of(rows(false), &PanelText::isCut));
}

}  // namespace
}  // namespace rocinante
