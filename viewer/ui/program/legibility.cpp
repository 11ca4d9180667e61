#include "viewer/ui/program/legibility.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "core/base/atomic_file.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text)
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return result + '"';
}

std::string row(std::string_view fault, std::string_view panel, std::string_view what,
                const PixelRectangle& at) {
  return fmt::format("{},{},{},{},{},{},{}", fault, quoted(panel), quoted(what), at.x, at.y,
                     at.width, at.height);
}

std::string_view faultOf(const PanelText& text) {
  if (text.isCut()) return "cut";
  return text.isFaint() ? "faint" : "-";
}

PixelRectangle windowPlace(const ImGuiWindow& window) {
  const ImRect at = window.Rect();
  const int x = static_cast<int>(at.Min.x), y = static_cast<int>(at.Min.y);
  return {x, y, static_cast<int>(at.Max.x) - x, static_cast<int>(at.Max.y) - y};
}

/// What stays on the window: neither what points at something nor a list that was opened.
std::vector<NamedPlace> drawnPanels() {
  std::vector<NamedPlace> panels;
  constexpr ImGuiWindowFlags kPassing =
      ImGuiWindowFlags_ChildWindow | ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_Popup;
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    const bool seen = window->Active && !window->Hidden && (window->Flags & kPassing) == 0;
    if (seen) panels.push_back({window->Name, windowPlace(*window)});
  }
  return panels;
}

}  // namespace

std::string legibilityTable(std::span<const PanelText> texts, std::span<const NamedPlace> panels,
                            std::span<const NamedPlace> insets) {
  std::string table = "fault,panel,text,x,y,width,height,contrast,cut_px\n";
  for (const PanelText& text : texts) {
    table +=
        fmt::format("{},{:.2f},{:.1f}\n", row(faultOf(text), text.panel, text.text, text.place),
                    text.contrast, text.cut_px);
  }
  for (const NamedPlace& inset : insets) {
    for (const NamedPlace& panel : panels) {
      const PixelRectangle both = overlapOf(inset.place, panel.place);
      if (both.width > 0) table += row("over inset", panel.name, inset.name, both) + ",,\n";
    }
  }
  return table;
}

Status writeLegibility(const std::filesystem::path& file, const ViewModel& model) {
  const ImDrawData* const drawn = ImGui::GetDrawData();
  if (drawn == nullptr) return Error{ErrorKind::bad_argument, "no frame is drawn yet", {}};
  std::vector<NamedPlace> insets;
  const PixelRectangle& picture = model.viewer.picture_part;
  for (const InsetPlace& inset : model.viewer.inset_places) {
    PixelRectangle place = inset.part;
    place.x += picture.x;
    place.y += picture.y;
    insets.push_back({insetTitle(model.viewer.insets[inset.number].inset), place});
  }
  const auto texts = panelTexts(*drawn);
  return writeFileWhole(file, bytesOf(legibilityTable(texts, drawnPanels(), insets)), true);
}

}  // namespace rocinante
