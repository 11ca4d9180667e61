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
  AskedText& mark = model.viewer.panels.mark;
  if (!mark.begun) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputTextWithHint("##text", "what is to be seen here", mark.text.data(),
                               mark.text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  const bool left = mark.begun && ImGui::IsItemDeactivated();
  mark.begun = mark.begun || ImGui::IsItemActive();
  ImGui::TextDisabled("Enter keeps it, Esc does not");
  if (entered) requests.mark = mark.text[0] == 0 ? "mark" : mark.text.data();
  if (entered || left) mark = AskedText();
  ImGui::End();
}

}  // namespace rocinante
