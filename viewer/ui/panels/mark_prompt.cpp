#include "core/base/duration_text.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {

void drawMarkPrompt(ViewModel& model, ViewerRequests& requests) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(display.x / 2, display.y * 0.55F), ImGuiCond_Always,
                          ImVec2(0.5F, 0.5F));
  ImGui::Begin("mark here", nullptr, kPanelFlags | ImGuiWindowFlags_NoTitleBar);
  const Nanoseconds at = model.shownTime() - model.origin();
  ImGui::Text("a mark at %s s",
              secondsText(std::chrono::floor<std::chrono::milliseconds>(at), 3).c_str());
  ImGui::SetNextItemWidth(px(320));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputTextWithHint(
      "##text", "what is to be seen here", model.viewer.panels.mark_text.data(),
      model.viewer.panels.mark_text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  const bool left = ImGui::IsItemDeactivated();
  ImGui::TextDisabled("Enter keeps it, Esc does not");
  if (entered)
    requests.mark =
        model.viewer.panels.mark_text[0] == 0 ? "mark" : model.viewer.panels.mark_text.data();
  if (entered || left) {
    model.viewer.panels.asks_mark = false;
    model.viewer.panels.mark_text[0] = 0;
  }
  ImGui::End();
}

}  // namespace rocinante
