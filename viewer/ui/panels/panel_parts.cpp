#include "viewer/ui/panels/panel_parts.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

namespace rocinante {
namespace {

/// Puts what was typed before in front of what was typed since, for the line to take.
void giveLetters(LineStart& start) {
  ImVector<ImWchar>& queue = ImGui::GetIO().InputQueueCharacters;
  ImVector<ImWchar> all;
  all.resize(static_cast<int>(start.letters.size()) + 1);
  all.resize(ImTextStrFromUtf8(all.Data, all.Size, start.letters.c_str(), nullptr));
  for (const ImWchar letter : queue) all.push_back(letter);
  queue.swap(all);
  start.letters.clear();
}

/// A begun text is continued, not typed over.
int takeStart(ImGuiInputTextCallbackData* data) {
  auto& start = *static_cast<LineStart*>(data->UserData);
  if (start.to_end == 0) return 0;
  --start.to_end;
  data->ClearSelection();
  data->CursorPos = data->BufTextLen;
  return 0;
}

}  // namespace

bool drawTypedLine(const char* id, const char* hint, std::span<char> text, bool takes_keyboard,
                   LineStart& start) {
  if (takes_keyboard) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (!start.collects && !start.letters.empty()) giveLetters(start);
  const ImVector<ImWchar> typed = ImGui::GetIO().InputQueueCharacters;
  const std::string before = text.data();
  const bool entered = ImGui::InputTextWithHint(
      id, hint, text.data(), text.size(),
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, takeStart, &start);
  if (start.collects && ImGui::IsItemActive()) {
    // Dear ImGui drops what is typed in the frame in which the line gets the keyboard.
    if (before == text.data()) {
      for (const ImWchar letter : typed) start.type(letter);
    }
    start.collects = false;
  }
  const bool complete = !start.collects && start.letters.empty();
  return (complete && std::exchange(start.enter, false)) || entered;
}

bool containsWord(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  return word.empty() ||
         std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

float scrollToShow(float scroll, float top, float height, float room) {
  if (top >= scroll && top + height <= scroll + room) return scroll;
  return std::max(0.0F, top + height / 2 - room / 2);
}

std::string linesOf(std::string_view text, float room) {
  return inLines(text, room > 0 ? room : ImGui::GetContentRegionAvail().x, drawnWidth);
}

void showTip(const char* text) {
  ImGui::BeginTooltip();
  const float most = ImGui::GetIO().DisplaySize.x - 4 * ImGui::GetStyle().WindowPadding.x;
  const float room = std::min(px(560), most);
  ImGui::PushTextWrapPos(room);
  ImGui::TextUnformatted(linesOf(text, room - ImGui::GetCursorPosX()).c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void drawCut(const std::string& text, PanelColor color, float room) {
  const float there = room > 0 ? room : ImGui::GetContentRegionAvail().x;
  const std::string shown = cutInMiddle(text, there, drawnWidth);
  ImGui::PushStyleColor(ImGuiCol_Text, panelInk(color));
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopStyleColor();
  explainCut(shown, text);
}

}  // namespace rocinante
