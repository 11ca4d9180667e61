#include "viewer/ui/panels/picture_lines.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "viewer/ui/panels/hand_panel.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

const ImVec4 kFault(1, 0.6F, 0.4F, 1);
const ImVec4 kHint(1.0F, 0.85F, 0.3F, 1);
const ImVec4 kDone(0.7F, 0.9F, 0.75F, 1);
const ImVec4 kOthers(0.6F, 0.85F, 1, 1);

/// Where lines are drawn, from the top down.
struct LineRoom {
  float left = 0, right = 0, top = 0;
  bool over_panels = false;
};

struct LineSize {
  float wrap = 0;
  ImVec2 size;
};

/// Computed here, because an auto-sized window is one frame late.
LineSize sizeOf(const PictureLine& line, const LineRoom& room) {
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const float most =
      std::max(px(160), std::min(px(560), room.right - room.left - px(2 * kPanelMargin)));
  LineSize result{most - 2 * padding.x, {}};
  const ImVec2 said = ImGui::CalcTextSize(line.what.c_str(), nullptr, false, result.wrap);
  result.size = said;
  if (!line.hint.empty()) {
    const ImVec2 more = ImGui::CalcTextSize(line.hint.c_str(), nullptr, false, result.wrap);
    result.size.x = std::max(result.size.x, more.x);
    result.size.y += more.y + ImGui::GetStyle().ItemSpacing.y;
  }
  result.size.x += 2 * padding.x + 1;
  result.size.y += 2 * padding.y;
  return result;
}

/// The first notes of a kind, one a line, and how many more there are; empty: none.
std::string notesText(const std::vector<PictureNote>& notes, bool errors) {
  constexpr std::size_t kMost = 4;
  std::string text;
  std::size_t count = 0;
  for (const PictureNote& note : notes) {
    if (note.is_error != errors || ++count > kMost) continue;
    text += (text.empty() ? "" : "\n") + note.text;
  }
  if (count > kMost) text += fmt::format("\nand {} more in the terminal", count - kMost);
  return text;
}

/// Returns what is below the line.
float drawLine(const PictureLine& line, const LineRoom& room, float top) {
  const LineSize computed = sizeOf(line, room);
  ImGui::SetNextWindowPos(ImVec2((room.left + room.right) / 2, top), ImGuiCond_Always,
                          ImVec2(0.5F, 0));
  ImGui::SetNextWindowSize(computed.size);
  // What is below must not be read together with it.
  if (room.over_panels) ImGui::SetNextWindowBgAlpha(1);
  ImGui::Begin(line.name, nullptr,
               (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
  const bool list_open =
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (room.over_panels && !list_open) {
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  }
  ImGui::PushTextWrapPos(ImGui::GetStyle().WindowPadding.x + computed.wrap);
  ImGui::TextColored(ink(line.color), "%s", line.what.c_str());
  if (!line.hint.empty()) ImGui::TextDisabled("%s", line.hint.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  return top + computed.size.y + px(6);
}

/// Over the picture; where that is narrow, over all of the window's width.
LineRoom roomOf(const std::vector<PictureLine>& lines, const PanelRectangle& picture) {
  constexpr float kLeastRoom = 240;
  const float bottom = picture.y + picture.height;
  LineRoom room{picture.x, picture.x + picture.width, picture.y + px(kPanelMargin)};
  if (picture.width >= px(kLeastRoom)) return room;
  room = {0, ImGui::GetIO().DisplaySize.x, px(kPanelMargin), true};
  float height = px(kPanelMargin);
  for (const PictureLine& line : lines) height += sizeOf(line, room).size.y + px(6);
  room.top = std::max(room.top, bottom - height);
  return room;
}

}  // namespace

std::vector<PictureLine> pictureLines(const ViewModel& model, const ViewerStatus& status,
                                      SteadyTime now) {
  std::vector<PictureLine> lines;
  const auto add = [&](const char* name, std::string what, std::string hint, const ImVec4& color) {
    lines.push_back({name, std::move(what), std::move(hint), color});
  };
  if (const auto reason = model.liveReason(now)) {
    add("reason", reason->text, reason->hint, kFault);
    // Keep the last picture visible; without any data, show the reason in the centre.
    lines.back().central = model.live() == nullptr || model.live()->datagrams == 0;
  }
  if (!model.damage().empty()) {
    add("damage", model.damage().what(), "what is shown may be older than its time says", kFault);
  }
  if (const HandBanner hand = handBanner(model); !hand.what.empty()) {
    add("hand", hand.what, hand.hint, hand.color);
  }
  if (const OthersBanner others = othersBanner(model); !others.what.empty()) {
    add("others", others.what, others.hint, others.is_fault ? kFault : kOthers);
  }
  if (model.viewer.picking.active()) {
    add("picking",
        model.viewer.picking.first() ? "click the second point"
                                     : "click two points: their distance",
        "Esc ends it", kHint);
  }
  if (!model.keepingTrouble().empty()) add("kept", model.keepingTrouble(), "", kFault);
  if (!model.viewer.panels.complaint.empty())
    add("complaint", model.viewer.panels.complaint, "", kFault);
  for (const bool errors : {true, false}) {
    const std::string text = notesText(model.viewer.panels.notes, errors);
    if (!text.empty()) {
      add(errors ? "errors" : "notes", text, "Esc dismisses it", errors ? kFault : kHint);
    }
  }
  if (!status.notice.empty()) {
    add("notice", status.notice, "", status.notice_is_fault ? kFault : kDone);
  }
  return lines;
}

void drawPictureLines(const std::vector<PictureLine>& lines, const PanelRectangle& picture,
                      std::vector<std::string>& said) {
  said.clear();
  const LineRoom room = roomOf(lines, picture);
  float top = room.top;
  for (const PictureLine& line : lines) {
    const bool central = line.central && !room.over_panels;
    const float at = central ? std::max(top, picture.y + picture.height * 0.3F) : top;
    const float end = drawLine(line, room, at);
    if (!central) top = end;
    said.push_back(line.what);
    if (!line.hint.empty()) said.push_back(line.hint);
  }
}

}  // namespace rocinante
