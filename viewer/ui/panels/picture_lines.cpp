#include "viewer/ui/panels/picture_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "viewer/ui/model/applied_layout.h"
#include "viewer/ui/model/pose_fields.h"
#include "viewer/ui/panels/hand_panel.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

constexpr std::size_t kMostLines = 4;
constexpr std::size_t kMostListed = 12;  // on hover
constexpr float kGap = 6;
constexpr ImGuiPopupFlags kAnyPopup = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;

std::string keyOf(const PictureNote& note) {
  return (note.is_error ? "error " : "note ") + note.text;
}

struct LineSize {
  float wrap = 0;
  NoticeSize size;
  std::string what, hint;  ///< as much of them as has room
  bool is_cut = false;
};

/// Computed here, because an auto-sized window is one frame late. No higher than there is room.
LineSize sizeOf(const PictureLine& line, const PanelRectangle& free) {
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const float most = std::max(px(120), std::min(px(560), free.width));
  const float wrap = most - 2 * padding.x;
  const auto sizeOfText = [wrap](std::string_view text) {
    return ImGui::CalcTextSize(linesOf(text, wrap).c_str(), nullptr, false, wrap);
  };
  LineSize result{wrap, {}, line.what, line.hint};
  ImVec2 size = sizeOfText(line.what);
  const ImVec2 hint = sizeOfText(line.hint);
  const float gap = ImGui::GetStyle().ItemSpacing.y;
  const float row = ImGui::GetTextLineHeight();
  const float room = std::max(row, free.height - 2 * padding.y);
  result.is_cut = size.y + (line.hint.empty() ? 0 : hint.y + gap) > room;
  if (result.is_cut) {
    result.hint.clear();
    result.what =
        cutInMiddle(line.what, room, [&](std::string_view text) { return sizeOfText(text).y; });
    size = sizeOfText(result.what);
  } else if (!line.hint.empty()) {
    size.x = std::max(size.x, hint.x);
    size.y += hint.y + gap;
  }
  result.size = {size.x + 2 * padding.x + 1, size.y + 2 * padding.y};
  return result;
}

/// The size of the line that says how many more there are; ImGui has none that is smaller.
NoticeSize moreSize(const std::string& text) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::CalcTextSize(text.c_str()).x + 2 * style.WindowPadding.x;
  return {std::max(width, style.WindowMinSize.x),
          std::max(ImGui::GetTextLineHeight() + style.WindowPadding.y, style.WindowMinSize.y)};
}

/// Devices that are not where the opened cell has them, and whether its file has them there.
std::string movedText(const DeviceMoves& moves) {
  const std::vector<std::string> unsaved = moves.unsaved();
  std::vector<std::string> names;
  for (const auto& [device, pose] : moves.poses()) names.push_back(device);
  if (unsaved.empty() && names.empty()) return {};
  const bool is_saved = unsaved.empty();
  if (!is_saved) names = unsaved;
  const std::string who = names.size() <= 3 ? fmt::format("{}", fmt::join(names, ", "))
                                            : countText(names.size(), "device");
  return is_saved ? fmt::format("moved by hand, and saved in the cell: {}", who)
                  : fmt::format("moved by hand, not as the cell has it: {}", who);
}

/// A window of the stack.
struct LineSlot {
  std::size_t number = 0;
  bool over_panels = false;  ///< else it is below all other windows
};

/// An opaque window there, one for each slot; true while the mouse is over it.
bool beginLine(const LineSlot& slot, const PanelRectangle& at, bool takes_mouse) {
  ImGui::SetNextWindowPos(ImVec2(at.x, at.y));
  ImGui::SetNextWindowSize(ImVec2(at.width, at.height));
  // What is below must not be read together with it.
  ImGui::SetNextWindowBgAlpha(1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, slot.over_panels ? px(1) : 0);
  const char* const name = slot.over_panels ? "##line over panels {}" : "##line {}";
  ImGui::Begin(fmt::format(fmt::runtime(name), slot.number).c_str(), nullptr,
               (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar |
                   (slot.over_panels ? 0 : ImGuiWindowFlags_NoBringToFrontOnFocus) |
                   (takes_mouse ? 0 : ImGuiWindowFlags_NoInputs));
  ImGui::PopStyleVar();
  // A click on the panel below must not bring that before it.
  if (slot.over_panels) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  return takes_mouse && ImGui::IsWindowHovered();
}

/// True when it is clicked.
bool drawLine(const LineSlot& slot, const PictureLine& line, const LineSize& size,
              const PanelRectangle& at) {
  const bool hovered = beginLine(slot, at, !line.stays || size.is_cut);
  ImGui::PushTextWrapPos(ImGui::GetStyle().WindowPadding.x + size.wrap);
  ImGui::TextColored(panelInk(line.color), "%s", linesOf(size.what, size.wrap).c_str());
  if (!size.hint.empty()) ImGui::TextDisabled("%s", linesOf(size.hint, size.wrap).c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
  if (!hovered) return false;
  std::string tip;
  if (size.is_cut) tip = line.what + (line.hint.empty() ? "" : "\n" + line.hint);
  if (!line.stays) tip += tip.empty() ? "a click dismisses it" : "\na click dismisses it";
  showTip(tip.c_str());
  return !line.stays && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

/// True when it is clicked.
bool drawMore(const LineSlot& slot, const std::string& text, const std::string& rest,
              const PanelRectangle& at) {
  const bool hovered = beginLine(slot, at, true);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::SetCursorPos(ImVec2((at.width - size.x) / 2, (at.height - size.y) / 2));
  ImGui::TextDisabled("%s", text.c_str());
  ImGui::End();
  if (!hovered) return false;
  showTip(rest.c_str());
  return ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

/// The panels are there, and the figures have no room among them.
bool figuresAreFolded(const ViewModel& model) {
  const PanelState& panels = model.viewer.panels;
  return panels.shown && !model.viewer.is_empty && !panels.places.drawn.contains("figures");
}

/// What is dismissed is not said any more, as far as that is in the panels' hands.
void dismiss(PanelState& panels, const PictureLine& line) {
  panels.notices.dismiss(line.key);
  std::erase_if(panels.notes, [&](const PictureNote& note) { return keyOf(note) == line.key; });
}

}  // namespace

std::vector<PictureLine> pictureLines(const ViewModel& model, const ViewerStatus& status,
                                      SteadyTime now) {
  std::vector<PictureLine> lines;
  std::set<std::string> known;
  const auto add = [&](std::string key, std::string what, std::string hint, PanelColor color) {
    if (!known.insert(key).second) return;
    lines.push_back({std::move(key), std::move(what), std::move(hint), color});
  };
  if (const auto reason = model.liveReason(now)) {
    // Its text tells for how long.
    add("reason " + reason->rule, reason->text, reason->hint, PanelColor::fault);
    // Keep the last picture visible; without any data, show the reason in the centre.
    lines.back().central = model.live() == nullptr || model.live()->datagrams == 0;
  }
  if (!model.damage().empty()) {
    add("damage", model.damage().what(), "what is shown may be older than its time says",
        PanelColor::fault);
  }
  if (figuresAreFolded(model)) {
    for (const Caveat& caveat : caveatsOf(model)) {
      add("caveat " + caveat.what, caveat.what, caveat.hint, caveat.color);
      lines.back().stays = caveat.stays;
    }
    const BesideSession* const beside = model.beside();
    if (beside != nullptr && model.beside_shown) {
      const std::filesystem::path file(beside->session().log().name());
      add("beside " + file.string(), "beside: " + plainText(file.filename().string()), "",
          PanelColor::hint);
    }
  }
  if (const HandBanner hand = handBanner(model); !hand.what.empty()) {
    add("hand", hand.what, hand.hint, hand.color);
    lines.back().stays = true;
  }
  if (const std::string moved = movedText(model.moves); !moved.empty()) {
    add("moved", moved,
        "findings, plots and figures are of the cell as it was opened; put-back, undo",
        PanelColor::hint);
    lines.back().stays = true;
  }
  if (const OthersBanner others = othersBanner(model); !others.what.empty()) {
    add("others", others.what, others.hint,
        others.is_fault ? PanelColor::fault : PanelColor::others);
    lines.back().stays = true;
  }
  if (model.viewer.fly.active()) {
    add("flying", fmt::format("flying at {:.2g} m/s", model.viewer.fly.speed()),
        "W A S D, Q and E; Shift: faster; the wheel changes the speed", PanelColor::hint);
    lines.back().stays = true;
  }
  if (model.viewer.picking.active()) {
    add("picking",
        model.viewer.picking.first() ? "click the second point"
                                     : "click two points: their distance",
        "Esc ends it", PanelColor::hint);
    lines.back().stays = true;
  }
  const auto addMessage = [&](const std::string& kind, const std::string& text, bool is_fault) {
    if (!text.empty())
      add(kind + " " + text, text, "", is_fault ? PanelColor::fault : PanelColor::done);
  };
  addMessage("kept", model.keepingTrouble(), true);
  addMessage("complaint", model.viewer.panels.complaint, true);
  if (!hasPoseFields(model)) addMessage("pose", model.viewer.panels.pose_fields.trouble, true);
  bool hinted = false;
  for (const bool errors : {true, false}) {
    for (const PictureNote& note : model.viewer.panels.notes) {
      if (note.is_error != errors) continue;
      const char* const hint = std::exchange(hinted, true) ? "" : "Esc dismisses it";
      add(keyOf(note), note.text, hint, errors ? PanelColor::fault : PanelColor::hint);
    }
  }
  for (const SeriesKey& key : unstatedSignals(model)) {
    add("unstated " + key.text(),
        fmt::format("no packet of the log states `{}`, so its plot is empty", key.text()), "",
        PanelColor::hint);
  }
  addMessage("notice", status.notice, status.notice_is_fault);
  return lines;
}

void drawPictureLines(ViewModel& model, const std::vector<PictureLine>& lines,
                      const NoticeRoom& room) {
  PanelState& panels = model.viewer.panels;
  const PanelRectangle& free = room.free;
  // What is opened over the window stays before them.
  const bool is_covered = panels.palette.shown || panels.open.shown || panels.help_shown ||
                          panels.mark.shown || ImGui::IsPopupOpen("", kAnyPopup);
  LineSlot slot{0, room.over_panels && !is_covered};
  std::vector<NoticeKey> keys;
  for (const PictureLine& line : lines) keys.push_back({line.key, line.stays});
  std::vector<std::size_t> shown = panels.notices.order(keys);
  panels.lines.clear();
  for (const std::size_t i : shown) {
    panels.lines.push_back(lines[i].what);
    if (!lines[i].hint.empty()) panels.lines.push_back(lines[i].hint);
  }
  const PictureLine* clicked = nullptr;
  std::erase_if(shown, [&](std::size_t i) {
    if (!lines[i].central) return false;
    const LineSize size = sizeOf(lines[i], free);
    const PanelRectangle middle{free.x, free.y + free.height * 0.3F, free.width, free.height};
    const std::array one{size.size};
    const PanelRectangle at = placeNotices(one, middle, {}, 0, 1).places.front();
    if (drawLine(slot, lines[i], size, at)) clicked = &lines[i];
    ++slot.number;
    return true;
  });
  std::vector<LineSize> sizes;
  std::vector<NoticeSize> only_sizes;
  for (const std::size_t i : shown) {
    sizes.push_back(sizeOf(lines[i], free));
    only_sizes.push_back(sizes.back().size);
  }
  const std::size_t most = panels.notices.shows_all ? shown.size() : kMostLines;
  const NoticePlaces placed = placeNotices(
      only_sizes, free, moreSize(fmt::format("{} more", shown.size())), px(kGap), most);
  for (std::size_t i = 0; i < placed.places.size(); ++i) {
    if (drawLine(slot, lines[shown[i]], sizes[i], placed.places[i])) clicked = &lines[shown[i]];
    ++slot.number;
  }
  if (placed.more > 0) {
    std::string rest;
    const std::size_t end = std::min(shown.size(), placed.places.size() + kMostListed);
    for (std::size_t i = placed.places.size(); i < end; ++i) {
      rest += (rest.empty() ? "" : "\n") + lines[shown[i]].what;
    }
    if (drawMore(slot, fmt::format("{} more", placed.more), rest, placed.more_place)) {
      panels.notices.shows_all = !panels.notices.shows_all;
    }
  } else if (shown.size() <= kMostLines) {
    panels.notices.shows_all = false;
  }
  if (clicked != nullptr) dismiss(panels, *clicked);
}

}  // namespace rocinante
