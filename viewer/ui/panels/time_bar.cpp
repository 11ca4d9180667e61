#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/base/duration_text.h"
#include "core/cli/text_table.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/plot_parts.h"

namespace rocinante {
namespace {

constexpr std::array kSpeeds{"0.01", "0.03", "0.1", "0.25", "0.5", "1",
                             "2",    "4",    "10",  "30",   "100"};
constexpr std::array<const char*, 3> kRepeats{"once", "loop", "to and fro"};

void drawRepeat(TimelineCursor& cursor, SteadyTime now) {
  ImGui::SetNextItemWidth(px(96));
  const auto chosen = static_cast<std::size_t>(cursor.repeat());
  if (ImGui::BeginCombo("##repeat", kRepeats.at(chosen))) {
    for (std::size_t i = 0; i < kRepeats.size(); ++i) {
      if (ImGui::Selectable(kRepeats[i], i == chosen)) {
        cursor.setRepeat(static_cast<Repeat>(i), now);
      }
    }
    ImGui::EndCombo();
  }
  explain("what happens at the end of the log, or of the part from A to B");
}

/// The part that is repeated.
void drawPartButtons(TimelineCursor& cursor, SteadyTime now) {
  if (ImGui::Button("A")) cursor.setPart(cursor.position(now), cursor.partEnd(), now);
  explain("repeat from here (A); or drag with Ctrl over the time line");
  ImGui::SameLine(0, px(2));
  if (ImGui::Button("B")) cursor.setPart(cursor.partStart(), cursor.position(now), now);
  explain("repeat up to here (B)");
  if (!cursor.hasPart()) return;
  ImGui::SameLine(0, px(2));
  if (ImGui::Button("x")) cursor.clearPart(now);
  explain("no longer only a part");
}

/// In a narrow window the least important buttons are left out.
void drawButtons(const ViewModel& model, TimelineCursor& cursor, SteadyTime now, float room) {
  if (ImGui::Button(cursor.playing() ? "Pause" : "Play", ImVec2(px(64), 0))) cursor.toggle(now);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Space");
  if (room < px(360)) return;
  ImGui::SameLine();
  if (ImGui::Button(cursor.reversed() ? "<##way" : ">##way", ImVec2(px(24), 0))) {
    cursor.setReversed(!cursor.reversed(), now);
  }
  explain(cursor.reversed() ? "plays backwards (J)" : "plays forwards (J)");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(px(76));
  if (ImGui::BeginCombo("##speed", fmt::format("{}x", cursor.speedText()).c_str())) {
    for (const char* speed : kSpeeds) {
      if (ImGui::Selectable(fmt::format("{}x", speed).c_str(), cursor.speedText() == speed)) {
        cursor.setSpeed(speed, now);
      }
    }
    ImGui::EndCombo();
  }
  if (room < px(760)) return;
  ImGui::SameLine();
  const auto jump = [&](bool forward) {
    if (const Event* event = model.eventBeside(cursor.position(now), forward)) {
      cursor.seek(event->time, now);
    }
  };
  if (!model.events().empty()) {
    if (ImGui::Button("|<")) jump(false);
    explain("the event before (,)");
    ImGui::SameLine(0, px(2));
    if (ImGui::Button(">|")) jump(true);
    explain("the next event (.)");
    ImGui::SameLine();
  }
  drawRepeat(cursor, now);
  ImGui::SameLine();
  drawPartButtons(cursor, now);
}

/// The shown moment, and where to type another.
void drawTime(ViewModel& model, TimelineCursor& cursor, SteadyTime now, float room) {
  if (model.viewer.panels.asks_time) {
    ImGui::SetNextItemWidth(px(130));
    if (ImGui::IsWindowAppearing() || !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputTextWithHint(
        "##time", "12.5 or 1m02.5s", model.viewer.panels.time_text.data(),
        model.viewer.panels.time_text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    const bool left = ImGui::IsItemDeactivated();
    if (entered) {
      const auto moment = model.momentNamed(model.viewer.panels.time_text.data());
      if (moment.ok()) {
        cursor.seek(*moment, now);
        model.viewer.time_view.follow(cursor.position(now));
      }
    }
    if (entered || left) model.viewer.panels.asks_time = false;
    explain("Enter goes there; -1s is a second before the end, picked is the event of that name");
    return;
  }
  const std::string at = shownSeconds(cursor.position(now) - model.origin());
  const std::string end = shownSeconds(cursor.end() - model.origin());
  const float left = ImGui::GetCursorPosX();
  if (room >= px(460)) {
    ImGui::Text("%s / %s s", at.c_str(), end.c_str());
  } else {
    ImGui::Text("%s", at.c_str());
  }
  if (ImGui::IsItemClicked()) {
    model.viewer.panels.time_text[0] = 0;
    model.viewer.panels.asks_time = true;
  }
  explain("click or G: type a time");
  // With its largest width, so that what is beside it does not move.
  ImGui::SameLine();
  const float widest =
      ImGui::CalcTextSize((end + " / " + end + " s").c_str()).x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), left + widest));
}

/// What `check` found, at the right end.
void drawVerdict(ViewModel& model) {
  const FindingsStudy* const judged = model.findings();
  if (judged == nullptr) return;
  std::string text;
  ImU32 color = fadedInk(0.6F);
  if (const CheckReport* const report = judged->report()) {
    const std::size_t errors = report->countOf(Severity::error);
    const std::size_t warnings = report->countOf(Severity::warning);
    if (errors > 0) text = cli::counted(errors, "error");
    if (warnings > 0) text += (text.empty() ? "" : ", ") + cli::counted(warnings, "warning");
    if (errors > 0 || warnings > 0)
      color = severityColor(errors > 0 ? Severity::error : Severity::warning);
    if (text.empty()) text = "checked: no findings";
  } else if (judged->isFinished()) {
    text = "not checked";
  } else {
    text = fmt::format("checking {:.0f} %", judged->progress() * 100);
  }
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  const float room = ImGui::GetContentRegionAvail().x;
  if (room < width) return;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(color), "%s", text.c_str());
  if (!judged->fault().empty())
    explain(judged->fault().c_str());
  else
    explain("as `rocinante check` judges it: the tab Check lists it");
}

void drawZoom(ViewModel& model) {
  if (model.viewer.time_view.showsAll()) return;
  if (ImGui::Button("all")) model.viewer.time_view.showAll();
  explain(
      "shows the whole log again (double right click); the wheel zooms the time line, and the "
      "right button moves it");
  ImGui::SameLine();
}

}  // namespace

void drawTimeBar(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis,
                 const PanelRectangle& place, SteadyTime now) {
  const float room = place.width;
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::SetNextWindowBgAlpha(1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin("time", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  drawButtons(model, cursor, now, room);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  if (room >= px(220)) {
    drawTime(model, cursor, now, room);
    ImGui::SameLine();
  }
  if (room >= px(560)) {
    drawZoom(model);
    ImGui::AlignTextToFramePadding();
    drawVerdict(model);
  }
  const float top =
      place.y + place.height - ImGui::GetStyle().WindowPadding.y * 0.6F - px(kTrackHeight);
  drawTrack(model, cursor, axis, top, now);
  ImGui::End();
}

}  // namespace rocinante
