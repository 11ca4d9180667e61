#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/duration_text.h"
#include "viewer/ui/commands/study_actions.h"
#include "viewer/ui/model/wall_clock.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/plot_parts.h"
#include "viewer/ui/panels/time_axis.h"

namespace rocinante {
namespace {

constexpr float kStripHeight = 18;
constexpr float kBarMiddle = 26;  // from the top of the track
constexpr float kRulerText = 11;
constexpr std::size_t kMaxStrips = 6;
constexpr float kReach = 5;  // of the mouse

/// What the left button holds.
enum class Grab : int { none, moment, part_start, part_end, finding };

/// In session time, or in that of the day.
void drawRuler(const TimeAxis& axis, float top, LogTime origin, bool by_day) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  constexpr float kLabelRoom = 64;
  const Nanoseconds step =
      rulerStep(axis.until - axis.from, static_cast<double>(axis.width), px(kLabelRoom));
  // From the first multiple of the step since the origin, or a midnight, on the line.
  const LogTime zero = by_day ? LogTime{} : origin;
  Nanoseconds at = (axis.from - zero) / step * step;
  if (at < axis.from - zero) at += step;
  const ImU32 ink = panelColor(PanelColor::dim_text);
  const float text_px = px(kRulerText);
  for (; zero + at <= axis.until; at += step) {
    const float x = axis.xOf(zero + at);
    list->AddLine(ImVec2(x, top), ImVec2(x, top + px(4)), ink);
    const std::string label = by_day ? clockLabel(zero + at, step) : rulerLabel(at, step);
    const float width = ImGui::GetFont()->CalcTextSizeA(text_px, 1e6F, 0, label.c_str()).x;
    const float left = std::clamp(x - width / 2, axis.left, axis.left + axis.width - width);
    list->AddText(ImGui::GetFont(), text_px, ImVec2(left, top + px(4)), ink, label.c_str());
  }
}

/// Columns of equal height are one rectangle.
void drawColumns(const std::vector<float>& values, float most, float left, float wide, float bottom,
                 float height, ImU32 color) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const auto level = [&](std::size_t i) {
    if (!(values[i] > 0) || !(most > 0)) return 0.0F;
    return std::max(1.0F, std::round(std::min(values[i] / most, 1.0F) * height));
  };
  for (std::size_t i = 0; i < values.size();) {
    const float high = level(i);
    std::size_t end = i + 1;
    while (end < values.size() && level(end) == high) ++end;
    if (high > 0) {
      list->AddRectFilled(ImVec2(left + static_cast<float>(i) * wide, bottom - high),
                          ImVec2(left + static_cast<float>(end) * wide, bottom), color);
    }
    i = end;
  }
}

/// The strips that are drawn: of each source, or of all together when there is one or too many.
std::vector<const SourceStrip*> stripsOf(const StudyPicture& picture) {
  std::vector<const SourceStrip*> strips;
  if (picture.strips.empty()) return strips;
  const std::size_t sources = picture.strips.size() - 1;
  if (sources < 2 || sources > kMaxStrips) return {&picture.strips.front()};
  for (std::size_t i = 1; i <= sources; ++i) strips.push_back(&picture.strips[i]);
  return strips;
}

void drawStrips(const StudyPicture& picture, const TimeAxis& axis, float top) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const std::vector<const SourceStrip*> strips = stripsOf(picture);
  const float first = axis.xOf(picture.wish.from);
  const float last = axis.xOf(picture.wish.until);
  list->PushClipRect(ImVec2(axis.left, top), ImVec2(axis.left + axis.width, top + px(kTrackHeight)),
                     true);
  const float pitch =
      px(kStripHeight) / static_cast<float>(std::max<std::size_t>(strips.size(), 1));
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const SourceStrip& strip = *strips[i];
    if (strip.rates.empty()) continue;
    const float wide = (last - first) / static_cast<float>(strip.rates.size());
    const float bottom = top + pitch * static_cast<float>(i + 1);
    const float height = std::max(1.0F, pitch - 1);
    drawColumns(strip.rates, strip.most, first, wide, bottom, height,
                panelColor(PanelColor::packets));
    std::vector<float> lost = strip.lost;
    for (float& rate : lost) rate = rate > 0 ? 1.0F : 0.0F;
    drawColumns(lost, 1, first, std::max(wide, 1.0F), bottom, height, panelColor(PanelColor::loss));
  }
  for (const auto& [from, until] : picture.damaged) {
    if (until < axis.from || from > axis.until) continue;
    list->AddRectFilled(ImVec2(axis.xOf(std::max(from, axis.from)), top),
                        ImVec2(axis.xOf(std::min(until, axis.until)) + 1, top + px(kStripHeight)),
                        panelColor(PanelColor::damage, 0.43F));
  }
  list->PopClipRect();
}

/// Where the two sessions are apart.
void drawPartings(const PartingStudy& study, const TimeAxis& axis, float middle) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  for (const Parting& parting : study.found()) {
    if (parting.until < axis.from || parting.from > axis.until) continue;
    const float left = axis.xOf(std::max(parting.from, axis.from));
    const float right = std::max(axis.xOf(std::min(parting.until, axis.until)), left + px(1));
    list->AddRectFilled(ImVec2(left, middle - px(6)), ImVec2(right, middle - px(3)),
                        panelColor(PanelColor::beside));
  }
}

/// Draws no more of the ticks than there is room for.
void drawTicks(const TimeAxis& axis, float middle, const std::vector<Event>& events) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  // A user's mark has no source.
  for (const bool marks : {false, true}) {
    const ImU32 color = panelColor(marks ? PanelColor::mark_tick : PanelColor::event_tick);
    float free_from = -1e6F;
    const auto first = std::ranges::lower_bound(events, axis.from, {}, &Event::time);
    for (auto event = first; event != events.end() && event->time <= axis.until; ++event) {
      if (event->source.empty() != marks) continue;
      const float x = axis.xOf(event->time);
      if (x < free_from) continue;
      free_from = x + px(2);
      list->AddRectFilled(ImVec2(x - px(1), middle - px(7)), ImVec2(x + px(1), middle + px(7)),
                          color);
    }
  }
}

void drawFindings(const CheckReport& report, const TimeAxis& axis, float middle,
                  std::size_t shown) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  float free_from = -1e6F;
  std::vector<std::pair<float, std::size_t>> places;
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    const Finding& finding = report.findings[i];
    if (finding.first && axis.shows(*finding.first))
      places.emplace_back(axis.xOf(*finding.first), i);
  }
  std::ranges::sort(places);
  for (const auto& [x, i] : places) {
    const bool chosen = i + 1 == shown;
    if (x < free_from && !chosen) continue;
    free_from = x + px(3);
    const float half = px(chosen ? 6 : 4);
    const ImU32 color = severityColor(report.findings[i].severity);
    const float tip = middle - px(5);
    list->AddTriangleFilled(ImVec2(x - half, tip - 2 * half), ImVec2(x + half, tip - 2 * half),
                            ImVec2(x, tip), color);
    const Finding& finding = report.findings[i];
    if (chosen && finding.last && *finding.last > *finding.first) {
      list->AddRectFilled(ImVec2(x, tip - px(2)),
                          ImVec2(std::min(axis.xOf(*finding.last), axis.left + axis.width), tip),
                          color);
    }
  }
}

void drawPart(const TimelineCursor& cursor, const TimeAxis& axis, float top, float middle) {
  if (!cursor.hasPart()) return;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float right_end = axis.left + axis.width;
  const float from = axis.xOf(cursor.partStart()), until = axis.xOf(cursor.partEnd());
  const float left = std::clamp(from, axis.left, right_end);
  const float right = std::clamp(until, axis.left, right_end);
  const ImU32 color = panelColor(PanelColor::repeated_part);
  list->AddRectFilled(ImVec2(left, top), ImVec2(right, middle + px(6)),
                      panelColor(PanelColor::repeated_part, 0.13F));
  const auto handle = [&](float x, float towards, const char* name) {
    if (x < axis.left - 1 || x > right_end + 1) return;
    list->AddRectFilled(ImVec2(x - px(1), top), ImVec2(x + px(1), middle + px(8)), color);
    const float other = x + towards * px(9);
    list->AddRectFilled(ImVec2(std::min(x, other), top), ImVec2(std::max(x, other), top + px(11)),
                        color);
    list->AddText(ImGui::GetFont(), px(10), ImVec2(std::min(x, other) + px(1.5F), top + px(0.5F)),
                  panelColor(PanelColor::repeated_part_text), name);
  };
  handle(from, 1, "A");
  handle(until, -1, "B");
}

/// The event whose tick is within reach of the mouse.
const Event* eventNear(const ViewModel& model, const TimeAxis& axis, float mouse_x) {
  const Event* nearest = nullptr;
  float best = px(kReach);
  for (const Event& event : model.events()) {
    const float distance = std::abs(axis.xOf(event.time) - mouse_x);
    if (distance < best) {
      best = distance;
      nearest = &event;
    }
  }
  return nearest;
}

/// Number from 1 of the finding whose tick is within reach; 0: none.
std::size_t findingNear(const CheckReport* report, const TimeAxis& axis, float mouse_x) {
  std::size_t nearest = 0;
  float best = px(kReach);
  for (std::size_t i = 0; report != nullptr && i < report->findings.size(); ++i) {
    const Finding& finding = report->findings[i];
    if (!finding.first || !axis.shows(*finding.first)) continue;
    const float distance = std::abs(axis.xOf(*finding.first) - mouse_x);
    if (distance < best) {
      best = distance;
      nearest = i + 1;
    }
  }
  return nearest;
}

Grab grabbedAt(const TimelineCursor& cursor, const TimeAxis& axis, std::size_t finding,
               ImVec2 mouse, float top) {
  const bool above = mouse.y < top + px(kBarMiddle - 4);
  if (cursor.hasPart() && above) {
    const auto near = [&](LogTime moment, float towards) {
      const float along = (mouse.x - axis.xOf(moment)) * towards;
      return along > -px(kReach) && along < px(10);
    };
    if (near(cursor.partEnd(), -1)) return Grab::part_end;
    if (near(cursor.partStart(), 1)) return Grab::part_start;
  }
  if (finding > 0 && mouse.y > top + px(6) && above) return Grab::finding;
  return Grab::moment;
}

/// The time, what is there, and a picture of the moment when there is one.
void drawPlaceTip(const MomentHover& hover, const std::string& text) {
  // Above the panel: it would hide the time that comes.
  const ImGuiIO& io = ImGui::GetIO();
  const float half = px(120);
  const float x = std::clamp(io.MousePos.x, half, std::max(half, io.DisplaySize.x - half));
  ImGui::SetNextWindowPos(ImVec2(x, ImGui::GetWindowPos().y), ImGuiCond_Always, ImVec2(0.5F, 1));
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(text.c_str());
  if (hover.drawn && hover.drawn == hover.wanted) {
    ImGui::Image((ImTextureID)hover.texture,
                 ImVec2(static_cast<float>(hover.width), static_cast<float>(hover.height)));
  }
  ImGui::EndTooltip();
}

/// "7.880 s", with the time of day where that is wanted.
std::string momentText(const ViewModel& model, LogTime moment) {
  const std::string text = shownSeconds(moment - model.origin()) + " s";
  return showsClock(model) ? text + ", " + clockText(moment) + " UTC" : text;
}

void explainPlace(ViewModel& model, const TimeAxis& axis, const CheckReport* report,
                  std::size_t finding, ImVec2 mouse, float top) {
  // That of the tick, when there is one.
  LogTime moment = axis.momentAt(mouse.x);
  std::string text = momentText(model, moment);
  if (finding > 0) {
    const Finding& found = report->findings[finding - 1];
    text += fmt::format("\n{}: {}", nameOf(found.severity), found.text);
    text += "\nclick: show it";
    moment = *found.first;
  } else if (const Event* event = eventNear(model, axis, mouse.x)) {
    moment = event->time;
    text = fmt::format("{}\n{}{}{}", momentText(model, event->time), event->source,
                       event->source.empty() ? "" : ": ", event->text);
  } else if (model.viewer.picture != nullptr && mouse.y < top + px(kStripHeight)) {
    const std::vector<const SourceStrip*> strips = stripsOf(*model.viewer.picture);
    const float part = (mouse.y - top) / px(kStripHeight);
    const auto row =
        static_cast<std::size_t>(std::max(0.0F, part * static_cast<float>(strips.size())));
    if (row < strips.size() && !strips[row]->rates.empty()) {
      const auto& rates = strips[row]->rates;
      const float at = (mouse.x - axis.left) / axis.width * static_cast<float>(rates.size());
      const auto column = std::min(static_cast<std::size_t>(std::max(0.0F, at)), rates.size() - 1);
      const std::string& source = strips[row]->source;
      text += fmt::format("\n{}: {:.0f} packets/s", source.empty() ? "all sources" : source,
                          rates[column]);
      if (strips[row]->lost[column] > 0) text += ", packets lost here";
    }
  }
  model.viewer.hover.wanted = moment;
  drawPlaceTip(model.viewer.hover, text);
}

void applyTrackMouse(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis,
                     std::size_t finding, float top, SteadyTime now) {
  int* const held = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("held"), 0);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (ImGui::IsItemActivated()) {
    *held = static_cast<int>(ImGui::IsMouseDown(ImGuiMouseButton_Left)
                                 ? grabbedAt(cursor, axis, finding, mouse, top)
                                 : Grab::moment);
    if (*held == static_cast<int>(Grab::finding)) showFinding(model, cursor, finding, now);
  }
  const auto grab = static_cast<Grab>(*held);
  if (!ImGui::IsItemActive() || grab == Grab::moment) {
    applyTimeMouse(model, cursor, axis, now);
  } else if (grab == Grab::part_start && axis.momentAt(mouse.x) < cursor.partEnd()) {
    cursor.setPart(axis.momentAt(mouse.x), cursor.partEnd(), now);
  } else if (grab == Grab::part_end && axis.momentAt(mouse.x) > cursor.partStart()) {
    cursor.setPart(cursor.partStart(), axis.momentAt(mouse.x), now);
  }
}

}  // namespace

ImU32 severityColor(Severity severity) {
  switch (severity) {
    case Severity::error:
      return panelColor(PanelColor::error);
    case Severity::warning:
      return panelColor(PanelColor::warning);
    case Severity::note:
      break;
  }
  return panelColor(PanelColor::note);
}

void drawTrack(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis, float top,
               SteadyTime now) {
  const FindingsStudy* const judged = model.findings();
  const CheckReport* const report = judged == nullptr ? nullptr : judged->report();
  ImGui::SetCursorScreenPos(ImVec2(axis.left, top));
  ImGui::InvisibleButton("track", ImVec2(axis.width, px(kTrackHeight)),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const std::size_t finding =
      ImGui::IsItemHovered() ? findingNear(report, axis, mouse.x) : std::size_t{0};
  const bool hovered = ImGui::IsItemHovered();
  applyTrackMouse(model, cursor, axis, finding, top, now);

  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float middle = top + px(kBarMiddle);
  const float half = px(3);
  const float right = axis.left + axis.width;
  const LogTime shown = cursor.position(now);
  const float at = axis.xOf(shown);
  if (model.viewer.picture != nullptr) drawStrips(*model.viewer.picture, axis, top);
  list->AddRectFilled(ImVec2(axis.left, middle - half), ImVec2(right, middle + half),
                      fadedInk(0.22F), half);
  list->AddRectFilled(ImVec2(axis.left, middle - half),
                      ImVec2(std::clamp(at, axis.left, right), middle + half),
                      panelColor(PanelColor::played), half);
  drawPart(cursor, axis, top, middle);
  if (const PartingStudy* const partings = model.beside_shown ? model.partings() : nullptr) {
    drawPartings(*partings, axis, middle);
  }
  drawTicks(axis, middle, model.events());
  if (report != nullptr) drawFindings(*report, axis, middle, model.viewer.finding_shown);
  if (axis.shows(shown)) {
    list->AddCircleFilled(ImVec2(at, middle), px(7), panelColor(PanelColor::playhead), 20);
  }
  drawRuler(axis, middle + px(5), model.origin(), showsClock(model));
  if (hovered && !ImGui::IsItemActive()) {
    list->AddLine(ImVec2(mouse.x, top), ImVec2(mouse.x, middle + px(6)), fadedInk(0.4F));
    explainPlace(model, axis, report, finding, mouse, top);
  }
}

}  // namespace rocinante
