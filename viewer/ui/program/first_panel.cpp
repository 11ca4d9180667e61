#include "viewer/ui/program/first_panel.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/cell/cell.h"
#include "viewer/gl/gl_table.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

/// That of an empty cell, which follows.
void drawBackground() {
  const CellScene look;
  const auto color = [](const glm::vec3& c) {
    return ImGui::ColorConvertFloat4ToU32(ImVec4(c.x, c.y, c.z, 1));
  };
  const ImU32 top = color(look.background_top), bottom = color(look.background_bottom);
  ImGui::GetBackgroundDrawList()->AddRectFilledMultiColor(ImVec2(0, 0), ImGui::GetIO().DisplaySize,
                                                          top, top, bottom, bottom);
}

void writeDown(FrameJournal& journal) {
  ShownFrame frame;
  frame.shown_at = std::chrono::steady_clock::now();
  frame.shown_wall = std::chrono::system_clock::now();
  journal.add(frame);
}

}  // namespace

FirstPanel::FirstPanel(Window& window, const FirstPanelLook& look, FrameJournal& journal)
    : window_(window), journal_(journal), interface_(&window) {
  interface_.useScale(look.scale ? static_cast<float>(*look.scale) : window.contentScale());
  interface_.useTheme(look.light);
}

Status FirstPanel::show(const LoadingStatus& loading) {
  // A panel that fits what it says knows its height in its second frame.
  int frames = 1;
  if (!painter_) {
    const auto gl = fillGlTable([&](const char* name) { return window_.procAddress(name); });
    if (!gl) return gl.error();
    auto painter = ImguiPainter::create(*gl);
    if (!painter) return painter.error();
    painter_ = std::move(*painter);
    ++frames;
  }
  const int width = std::max(1, window_.framebufferWidth());
  const int height = std::max(1, window_.framebufferHeight());
  for (int i = 0; i < frames; ++i) {
    interface_.beginFrame(width, height);
    drawBackground();
    drawLoading(loading, true);
    ImGui::Render();
  }
  painter_->draw(*ImGui::GetDrawData(), width, height);
  window_.swap();
  writeDown(journal_);
  return {};
}

}  // namespace rocinante
