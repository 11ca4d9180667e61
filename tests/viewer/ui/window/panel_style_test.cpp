#include "viewer/ui/window/panel_style.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "viewer/ui/window/interface_context.h"

namespace rocinante {
namespace {

ImU32 styled(ImGuiCol where) {
  return ImGui::ColorConvertFloat4ToU32(ImGui::GetStyleColorVec4(where));
}

TEST(PanelStyle, HasTheColoursOfItsTheme) {
  InterfaceContext interface(nullptr);
  for (const bool light : {true, false, true}) {
    interface.useTheme(light);
    EXPECT_EQ(panelColor(PanelColor::text), drawnColor(colorOf(PanelColor::text, light)));
    EXPECT_EQ(styled(ImGuiCol_Text), panelColor(PanelColor::text));
    EXPECT_EQ(styled(ImGuiCol_TextDisabled), panelColor(PanelColor::dim_text));
    EXPECT_EQ(styled(ImGuiCol_WindowBg), panelColor(PanelColor::panel));
    EXPECT_EQ(styled(ImGuiCol_HeaderHovered), panelColor(PanelColor::row_hovered));
    EXPECT_EQ(ImGui::GetStyle().DisabledAlpha, kDisabledOpacity);
  }
}

TEST(PanelStyle, ConvertsAsDearImGuiHasIt) {
  EXPECT_EQ(drawnColor(0x11223344), IM_COL32(0x11, 0x22, 0x33, 0x44));
  EXPECT_EQ(panelColor(PanelColor::text, 0.5F) >> IM_COL32_A_SHIFT, 128U);
  EXPECT_EQ(panelColor(PanelColor::text, 0) >> IM_COL32_A_SHIFT, 0U);
}

// A character without a glyph was a question mark: the sign of a cut, a name in Greek.
TEST(PanelStyle, HasGlyphsForWhatPanelsWrite) {
  InterfaceContext interface(nullptr);
  for (const float scale : {1.0F, 2.0F}) {
    interface.useScale(scale);
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Build();
    for (const unsigned character : {0x2026U, 0xB0U, 0xB2U, 0x416U, 0x3A9U, 0x17EU, 0x2192U}) {
      EXPECT_NE(atlas.Fonts[0]->FindGlyphNoFallback(static_cast<ImWchar>(character)), nullptr)
          << character;
    }
  }
}

}  // namespace
}  // namespace rocinante
