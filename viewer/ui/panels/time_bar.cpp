#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/base/duration_text.h"
#include "core/cli/text_table.h"
#include "viewer/ui/commands/key_commands.h"
#include "viewer/ui/model/wall_clock.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/placed_panel.h"
#include "viewer/ui/panels/plot_parts.h"
#include "viewer/ui/panels/transport_signs.h"

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

bool drawCommandButton(TransportSign sign, const char* name, const char* words = "") {
  ImGui::PushID(words);
  const bool pressed = drawSignButton(name, sign, commandHint(name, words).c_str(), true);
  ImGui::PopID();
  return pressed;
}

void drawPlay(TimelineCursor& cursor, SteadyTime now) {
  const std::string keys = " (" + shownKeys(*findCommand("play-pause")) + ")";
  const TransportSign sign = cursor.playing()    ? TransportSign::pause
                             : cursor.reversed() ? TransportSign::play_back
                                                 : TransportSign::play;
  const char* const words = cursor.playing() ? "pause" : cursor.reversed() ? "play back" : "play";
  if (drawSignButton("play", sign, (words + keys).c_str())) cursor.toggle(now);
}

/// With Shift a tenth, as by the keys.
void drawStep(TimelineCursor& cursor, bool forward, SteadyTime now) {
  const std::string whole = forward ? "1" : "-1";
  const std::string tenth = forward ? "0.1" : "-0.1";
  const std::string words =
      commandHint("step", whole) + "; with Shift " + commandHint("step", tenth);
  const TransportSign sign = forward ? TransportSign::step_on : TransportSign::step_back;
  if (!drawSignButton(forward ? "on" : "back", sign, words.c_str(), true)) return;
  const Nanoseconds by(ImGui::GetIO().KeyShift ? 100'000'000 : 1'000'000'000);
  cursor.step(forward ? by : -by, now);
}

void drawTransport(TimelineCursor& cursor, SteadyTime now) {
  if (drawCommandButton(TransportSign::to_start, "start")) cursor.seek(cursor.start(), now);
  ImGui::SameLine(0, px(2));
  drawStep(cursor, false, now);
  ImGui::SameLine(0, px(2));
  drawPlay(cursor, now);
  ImGui::SameLine(0, px(2));
  drawStep(cursor, true, now);
  ImGui::SameLine(0, px(2));
  if (drawCommandButton(TransportSign::to_end, "end")) cursor.seek(cursor.end(), now);
}

void drawEventButtons(const ViewModel& model, TimelineCursor& cursor, SteadyTime now) {
  const auto jump = [&](bool forward) {
    if (const Event* event = model.eventBeside(cursor.position(now), forward)) {
      cursor.seek(event->time, now);
    }
  };
  if (drawCommandButton(TransportSign::event_before, "event", "previous")) jump(false);
  ImGui::SameLine(0, px(2));
  if (drawCommandButton(TransportSign::event_after, "event", "next")) jump(true);
}

/// In a narrow window the least important buttons are left out.
void drawButtons(const ViewModel& model, TimelineCursor& cursor, SteadyTime now, float room) {
  if (room < px(360)) return drawPlay(cursor, now);
  drawTransport(cursor, now);
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
  explain("the speed of playing");
  if (room >= px(560) && !model.events().empty()) {
    ImGui::SameLine();
    drawEventButtons(model, cursor, now);
  }
  if (room < px(760)) return;
  ImGui::SameLine();
  drawRepeat(cursor, now);
  ImGui::SameLine();
  drawPartButtons(cursor, now);
}

/// The shown moment, and where to type another.
void drawTime(ViewModel& model, TimelineCursor& cursor, SteadyTime now, float room) {
  AskedText& time = model.viewer.panels.time;
  if (time.shown) {
    ImGui::SetNextItemWidth(px(130));
    if (!time.begun) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputTextWithHint("##time", "12.5 or 1m02.5s", time.text.data(), time.text.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue);
    const bool left = time.begun && ImGui::IsItemDeactivated();
    time.begun = time.begun || ImGui::IsItemActive();
    if (entered) {
      const auto moment = model.momentNamed(time.text.data());
      if (moment.ok()) {
        cursor.seek(*moment, now);
        model.viewer.time_view.follow(cursor.position(now));
      }
    }
    if (entered || left) time.shown = false;
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
  if (ImGui::IsItemClicked()) time.ask();
  explain("click or G: type a time");
  // With its largest width, so that what is beside it does not move.
  ImGui::SameLine();
  const float widest =
      ImGui::CalcTextSize((end + " / " + end + " s").c_str()).x + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), left + widest));
}

/// The switch for the time of day, and that.
void drawClock(ViewModel& model, TimelineCursor& cursor, SteadyTime now, float room) {
  const bool fits = room >= px(880) || showsClock(model);
  if (!fits || !hasWallClock(model.origin())) return;
  bool& on = model.viewer.panels.wall_clock;
  ImGui::PushStyleColor(ImGuiCol_Button,
                        ImGui::GetStyleColorVec4(on ? ImGuiCol_TabActive : ImGuiCol_Button));
  if (ImGui::Button("UTC")) on = !on;
  ImGui::PopStyleColor();
  const LogTime moment = cursor.position(now);
  explain((calendarText(moment) + "\n" + commandHint("clock")).c_str());
  if (on) {
    ImGui::SameLine();
    ImGui::TextUnformatted(clockText(moment).c_str());
    explain(calendarText(moment).c_str());
  }
  ImGui::SameLine();
}

/// What `check` found, in the words for which there is room; empty: none.
std::string verdictText(const CheckReport& report, float room) {
  const std::size_t errors = report.countOf(Severity::error);
  const std::size_t warnings = report.countOf(Severity::warning);
  if (errors + warnings == 0) return "checked: no findings";
  std::string text = errors > 0 ? cli::counted(errors, "error") : "";
  if (warnings > 0) text += (text.empty() ? "" : ", ") + cli::counted(warnings, "warning");
  if (ImGui::CalcTextSize(text.c_str()).x <= room) return text;
  return cli::counted(errors + warnings, "finding");
}

/// The same at the right end: a click lists it.
void drawVerdict(ViewModel& model) {
  const FindingsStudy* const judged = model.findings();
  if (judged == nullptr) return;
  std::string text;
  ImU32 color = panelColor(PanelColor::dim_text);
  const float room = ImGui::GetContentRegionAvail().x - 2 * px(4);
  if (const CheckReport* const report = judged->report()) {
    const bool any_error = report->countOf(Severity::error) > 0;
    if (any_error || report->countOf(Severity::warning) > 0)
      color = severityColor(any_error ? Severity::error : Severity::warning);
    text = verdictText(*report, room);
  } else if (judged->isFinished()) {
    text = "not checked";
  } else {
    text = fmt::format("checking {:.0f} %", judged->progress() * 100);
  }
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  if (room < width) return;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushStyleColor(ImGuiCol_Button, panelColor(PanelColor::panel));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(4), ImGui::GetStyle().FramePadding.y));
  const bool clicked = ImGui::Button((text + "##verdict").c_str());
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  if (clicked) model.viewer.panels.openTab("Check");
  const std::string words = judged->fault().empty()
                                ? "as `rocinante check` judges it; a click lists it"
                                : judged->fault();
  explain(words.c_str());
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
  drawButtons(model, cursor, now, showsClock(model) ? room - px(130) : room);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  if (room >= px(220)) {
    drawTime(model, cursor, now, room);
    ImGui::SameLine();
  }
  if (room >= px(560)) {
    drawClock(model, cursor, now, room);
    drawZoom(model);
    drawVerdict(model);
  }
  const float top =
      place.y + place.height - ImGui::GetStyle().WindowPadding.y * 0.6F - px(kTrackHeight);
  drawTrack(model, cursor, axis, top, now);
  const bool on_background = ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered();
  PanelPlaces& places = model.viewer.panels.places;
  if (isDoubleClicked(places, "time", on_background)) closeEdge(places, DockEdge::bottom);
  ImGui::End();
}

}  // namespace rocinante
