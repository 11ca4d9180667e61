#include <fmt/format.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/report/account.h"
#include "viewer/ui/commands/study_actions.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxRows = 12;

std::string secondsAt(const ViewModel& model, LogTime moment) {
  return secondsText(std::chrono::floor<std::chrono::milliseconds>(moment - model.origin()), 3);
}

void drawRow(ViewModel& model, const Finding& finding, std::size_t number, SteadyTime now) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  const float mark = px(8);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(corner.x, corner.y + px(4)),
                                            ImVec2(corner.x + mark, corner.y + height - px(3)),
                                            severityColor(finding.severity), px(2));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + mark + px(6));
  const std::string when = finding.first ? secondsAt(model, *finding.first) + " s  " : "";
  const std::string text = sentenceOf(finding);
  if (ImGui::Selectable((when + text).c_str(), model.viewer.finding_shown == number)) {
    showFinding(model, *model.cursor(), number, now);
  }
  if (ImGui::IsItemHovered()) {
    showTip(text.c_str());
  }
}

void drawExplanation(const ViewModel& model, const Finding& finding) {
  ImGui::Separator();
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(severityColor(finding.severity)), "%s",
                     finding.rule.c_str());
  ImGui::TextUnformatted(linesOf(sentenceOf(finding)).c_str());
  if (!finding.hint.empty()) ImGui::TextDisabled("%s", linesOf(finding.hint).c_str());
  std::string when = finding.first ? "at " + secondsAt(model, *finding.first) + " s" : "";
  const bool is_counted = finding.count > 1 && finding.left_out.empty();  // else the text has it
  if (is_counted) when += fmt::format("{}{} times", when.empty() ? "" : ", ", finding.count);
  if (finding.count > 1 && finding.last)
    when += ", until " + secondsAt(model, *finding.last) + " s";
  if (!when.empty()) ImGui::TextDisabled("%s", linesOf(when).c_str());
  if (!finding.example.empty()) ImGui::TextDisabled("%s", linesOf(finding.example).c_str());
  if (!finding.file.empty()) ImGui::TextDisabled("%s", finding.place().c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace

void drawFindingsTab(ViewModel& model, SteadyTime now) {
  const FindingsStudy* const judged = model.findings();
  if (judged == nullptr) {
    const char* const why = !model.viewer.findings_wanted ? "not judged"
                            : model.isGrowing()           ? "judged when the session has ended:\n"
                                                            "save it for `rocinante check`"
                                                          : "reading the log first";
    ImGui::TextDisabled("%s", why);
    return;
  }
  if (!judged->fault().empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(linesOf(judged->fault()).c_str());
    ImGui::PopTextWrapPos();
    return;
  }
  const CheckReport* const report = judged->report();
  if (report == nullptr) {
    ImGui::ProgressBar(static_cast<float>(judged->progress()), ImVec2(-1, 0), "judging the log");
    return;
  }
  if (report->findings.empty()) {
    ImGui::TextDisabled("no findings: cell and session fit");
    return;
  }
  const float pitch = ImGui::GetTextLineHeightWithSpacing();
  const auto rows = static_cast<float>(std::min(report->findings.size(), kMaxRows));
  ImGui::BeginChild("findings", ImVec2(0, rows * pitch + px(4)));
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(report->findings.size()), pitch);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto place = static_cast<std::size_t>(i);
      ImGui::PushID(i);
      drawRow(model, report->findings[place], place + 1, now);
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
  const std::size_t shown = model.viewer.finding_shown;
  if (shown > 0 && shown <= report->findings.size()) {
    drawExplanation(model, report->findings[shown - 1]);
  }
}

}  // namespace rocinante
