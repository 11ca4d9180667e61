#include "viewer/ui/panels/time_bar.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/duration_text.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/time_ruler.h"

namespace rocinante {
namespace {

constexpr float kTrackHeight = 30;
constexpr float kRulerText = 11;
constexpr std::array kSpeeds{"0.1", "0.25", "0.5", "1", "2", "4", "10"};

/// In a narrow window the least important buttons are left out, so that the time line keeps a
/// length.
void drawButtons(const ViewModel& model, TimelineCursor& cursor, SteadyTime now, float room) {
  if (ImGui::Button(cursor.playing() ? "Pause" : "Play", ImVec2(px(64), 0))) cursor.toggle(now);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Space");
  if (room < px(360)) return;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(px(72));
  if (ImGui::BeginCombo("##speed", fmt::format("{}x", cursor.speedText()).c_str())) {
    for (const char* speed : kSpeeds) {
      if (ImGui::Selectable(fmt::format("{}x", speed).c_str(), cursor.speedText() == speed)) {
        cursor.setSpeed(speed, now);
      }
    }
    ImGui::EndCombo();
  }
  if (room < px(560)) return;
  ImGui::SameLine();
  const auto jump = [&](bool forward) {
    if (const Event* event = model.eventBeside(cursor.position(now), forward)) {
      cursor.seek(event->time, now);
    }
  };
  if (!model.events().empty()) {
    if (ImGui::Button("|<")) jump(false);
    explain("the event before (,)");
    ImGui::SameLine();
    if (ImGui::Button(">|")) jump(true);
    explain("the next event (.)");
    ImGui::SameLine();
  }
  bool looping = cursor.looping();
  if (ImGui::Checkbox("loop", &looping)) cursor.setLooping(looping);
}

/// Seconds from the session's origin, to the millisecond.
std::string shownSeconds(Nanoseconds since_origin) {
  return secondsText(std::chrono::floor<std::chrono::milliseconds>(since_origin), 3);
}

/// The event whose tick is within reach of the mouse.
const Event* eventNear(const ViewModel& model, float mouse_x, const auto& x_of) {
  const Event* nearest = nullptr;
  float best = px(5);
  for (const Event& event : model.events()) {
    const float distance = std::abs(x_of(event.time) - mouse_x);
    if (distance < best) {
      best = distance;
      nearest = &event;
    }
  }
  return nearest;
}

/// Maps moments of the session to the time line.
struct Track {
  ImVec2 corner;
  float width = 0;
  LogTime start;
  Nanoseconds span;

  float xOf(LogTime moment) const {
    const double part =
        static_cast<double>((moment - start).count()) / static_cast<double>(span.count());
    return corner.x + static_cast<float>(std::clamp(part, 0.0, 1.0)) * width;
  }
  LogTime momentAt(float x) const {
    const double part = std::clamp(static_cast<double>((x - corner.x) / width), 0.0, 1.0);
    return start + Nanoseconds(static_cast<std::int64_t>(part * static_cast<double>(span.count())));
  }
  float middle() const { return corner.y + px(8); }
};

void drawRuler(const Track& track, LogTime origin) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  constexpr float kLabelRoom = 64;
  const Nanoseconds step = rulerStep(track.span, track.width, px(kLabelRoom));
  // From the first multiple of the step since the origin on the line.
  Nanoseconds at = (track.start - origin) / step * step;
  if (at < track.start - origin) at += step;
  const float top = track.middle() + px(5);
  const ImU32 ink = IM_COL32(150, 160, 170, 255);
  const float text_px = px(kRulerText);
  for (; origin + at <= track.start + track.span; at += step) {
    const float x = track.xOf(origin + at);
    list->AddLine(ImVec2(x, top), ImVec2(x, top + px(4)), ink);
    const std::string label = rulerLabel(at, step);
    const float width = ImGui::GetFont()->CalcTextSizeA(text_px, 1e6F, 0, label.c_str()).x;
    const float left =
        std::clamp(x - width / 2, track.corner.x, track.corner.x + track.width - width);
    list->AddText(ImGui::GetFont(), text_px, ImVec2(left, top + px(4)), ink, label.c_str());
  }
}

/// Draws no more of the ticks than there is room for.
void drawTicks(const Track& track, const std::vector<Event>& events) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float middle = track.middle();
  // A user's mark has no source.
  for (const bool marks : {false, true}) {
    const ImU32 color = marks ? IM_COL32(150, 230, 140, 255) : IM_COL32(120, 200, 255, 255);
    float free_from = -1e6F;
    for (const Event& event : events) {
      if (event.source.empty() != marks) continue;
      const float x = track.xOf(event.time);
      if (x < free_from) continue;
      free_from = x + px(2);
      list->AddRectFilled(ImVec2(x - px(1), middle - px(7)), ImVec2(x + px(1), middle + px(7)),
                          color);
    }
  }
}

void drawTrack(ViewModel& model, TimelineCursor& cursor, SteadyTime now) {
  Track track;
  track.corner = ImGui::GetCursorScreenPos();
  track.width = std::max(px(40), ImGui::GetContentRegionAvail().x);
  track.start = cursor.start();
  track.span = std::max(Nanoseconds(1), cursor.end() - cursor.start());
  ImGui::InvisibleButton("track", ImVec2(track.width, px(kTrackHeight)));
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) cursor.seek(track.momentAt(io.MousePos.x), now);

  drawRuler(track, model.origin());
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float middle = track.middle();
  const float half = px(3);
  const float at = track.xOf(cursor.position(now));
  list->AddRectFilled(ImVec2(track.corner.x, middle - half),
                      ImVec2(track.corner.x + track.width, middle + half),
                      IM_COL32(70, 82, 94, 255), half);
  list->AddRectFilled(ImVec2(track.corner.x, middle - half), ImVec2(at, middle + half),
                      IM_COL32(255, 168, 64, 255), half);
  drawTicks(track, model.events());
  list->AddCircleFilled(ImVec2(at, middle), px(7), IM_COL32(255, 255, 255, 255), 20);
  if (!ImGui::IsItemHovered()) return;
  const auto x_of = [&](LogTime moment) { return track.xOf(moment); };
  if (const Event* event = eventNear(model, io.MousePos.x, x_of)) {
    ImGui::SetTooltip("%s%s%s", event->source.c_str(), event->source.empty() ? "" : ": ",
                      event->text.c_str());
  } else {
    ImGui::SetTooltip("%s s", shownSeconds(track.momentAt(io.MousePos.x) - model.origin()).c_str());
  }
}

}  // namespace

void drawTimeBar(ViewModel& model, TimelineCursor& cursor, SteadyTime now) {
  const ImGuiIO& io = ImGui::GetIO();
  const float margin = px(kPanelMargin);
  const float room = io.DisplaySize.x - 2 * margin;
  ImGui::SetNextWindowPos(ImVec2(margin, io.DisplaySize.y - margin), ImGuiCond_Always,
                          ImVec2(0, 1));
  ImGui::SetNextWindowSize(ImVec2(room, px(kTimeBarHeight) - 2 * margin));
  ImGui::Begin("time", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoScrollbar);
  drawButtons(model, cursor, now, room);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const std::string at = shownSeconds(cursor.position(now) - model.origin());
  if (room >= px(460)) {
    const std::string end = shownSeconds(cursor.end() - model.origin());
    // With its largest width, so that the line beside it does not move.
    const float left = ImGui::GetCursorPosX();
    ImGui::Text("%s / %s s", at.c_str(), end.c_str());
    ImGui::SameLine();
    const float widest =
        ImGui::CalcTextSize((end + " / " + end + " s").c_str()).x + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), left + widest));
  } else if (room >= px(220)) {
    ImGui::Text("%s", at.c_str());
    ImGui::SameLine();
  }
  drawTrack(model, cursor, now);
  ImGui::End();
}

}  // namespace rocinante
