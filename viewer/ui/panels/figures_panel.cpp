#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "viewer/ui/panels/frame_state.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/placed_panel.h"

namespace rocinante {
namespace {

constexpr float kGraphHeight = 72;
/// Wide enough for growing figures without moving the panel's edge.
constexpr float kFiguresWidth = 244;

struct Stage {
  const char* name;
  double FrameTimes::*time;
  PanelColor color;
};
constexpr std::array kStages{
    Stage{"app", &FrameTimes::app, PanelColor::stage_app},
    Stage{"cull", &FrameTimes::cull, PanelColor::stage_cull},
    Stage{"draw", &FrameTimes::draw, PanelColor::stage_draw},
    Stage{"ui", &FrameTimes::ui, PanelColor::stage_ui},
};

/// Longer names would make the panel wider.
float nameRoom() { return px(kFiguresWidth) - 2 * ImGui::GetStyle().WindowPadding.x; }

/// Its name without the folders, which are told on hover.
void drawFile(const std::string& path, const std::string& before,
              PanelColor color = PanelColor::text) {
  drawCut(before + std::filesystem::path(path).filename().string(), color, nameRoom());
  explain(path.c_str());
}

/// Draws the number of active sources; a tab of the left panel lists them.
void drawSourceCount(const ViewModel& model, SteadyTime now) {
  const std::vector<SourceRow> rows = model.sourceRows(now);
  if (rows.empty()) return;
  ImGui::TextUnformatted(countText(rows.size(), "source").c_str());
  const auto silent = std::ranges::count_if(rows, &SourceRow::is_silent);
  if (silent == 0) return;
  ImGui::SameLine(0, 0);
  ImGui::TextColored(panelInk(PanelColor::fault), ", %td silent", silent);
}

void drawLive(const ViewModel& model, SteadyTime now) {
  for (const Endpoint& endpoint : model.feed().endpoints()) {
    drawCut(endpoint.text(), PanelColor::text, nameRoom());
  }
  const LiveSnapshot* live = model.live();
  if (live != nullptr && live->untrusted.total() > 0) {
    ImGui::TextColored(panelInk(PanelColor::fault), "%s",
                       ("not trusted: " + cli::grouped(live->untrusted.total())).c_str());
    explain(live->untrusted.text().c_str());
  }
  if (live == nullptr || live->datagrams == 0) {
    ImGui::TextDisabled("listening; nothing has come yet");
    return;
  }
  ImGui::Text("%.0f packets/s", live->rate_hz);
  ImGui::TextUnformatted(cli::counted(live->datagrams, "datagram").c_str());
  const std::uint64_t lost = live->dropped + live->gaps;
  ImGui::TextColored(panelInk(lost == 0 ? PanelColor::done : PanelColor::fault),
                     "lost: %llu here, %llu on the way here",
                     static_cast<unsigned long long>(live->dropped),
                     static_cast<unsigned long long>(live->gaps));
  explain("here: dropped by this machine; on the way: gaps in the numbers of sources");
  drawSourceCount(model, now);
  if (live->undecoded > 0) {
    ImGui::TextColored(panelInk(PanelColor::fault), "%s",
                       ("not packets: " + cli::grouped(live->undecoded)).c_str());
    explain(("the first begins " + live->undecoded_sample).c_str());
  }
}

/// Draws what is kept of a live session, and whether it is now.
void drawKept(const ViewModel& model) {
  const LiveKeeper* const keeper = model.feed().keeper();
  if (!model.keepingTrouble().empty()) {
    ImGui::TextColored(panelInk(PanelColor::fault), "not kept");
    explain(model.keepingTrouble().c_str());
  } else if (keeper != nullptr) {
    ImGui::TextUnformatted(("kept: " + sizeText(keeper->progress().bytes)).c_str());
    explain("earlier moments can be shown; Shift S saves them as a log");
  }
}

void drawSession(const ViewModel& model, SteadyTime now) {
  if (model.isLive()) {
    drawLive(model, now);
    drawKept(model);
  } else if (const Timeline* session = model.session()) {
    drawFile(session->log().name(), "");
    ImGui::TextUnformatted(cli::counted(session->log().summary().messages, "datagram").c_str());
  } else {
    ImGui::TextDisabled("at rest; Ctrl+O opens a log");
  }
}

/// "arm, lamp, gripper and 2 more".
std::string fewOf(const std::vector<std::string>& names) {
  constexpr std::size_t kMaxNamed = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNamed); ++i) {
    text += (i > 0 ? ", " : "") + plainText(names[i]);
  }
  if (names.size() > kMaxNamed) text += fmt::format(" and {} more", names.size() - kMaxNamed);
  return text;
}

void drawCaveats(const ViewModel& model) {
  for (const Caveat& caveat : caveatsOf(model)) {
    ImGui::TextColored(panelInk(caveat.color), "%s", caveat.what.c_str());
    explain(caveat.hint.c_str());
  }
}

/// A text that names a file, by the file's name alone.
std::string withoutFolder(std::string text, const std::filesystem::path& file) {
  const std::size_t at = text.find(file.string());
  if (at != text.npos) text.replace(at, file.string().size(), file.filename().string());
  return text;
}

/// Draws what the session beside is, and what is apart from it at the shown moment.
void drawBeside(ViewModel& model, SteadyTime now) {
  const BesideSession* const beside = model.beside();
  if (beside == nullptr) return;
  const std::string& name = beside->session().log().name();
  if (!model.beside_shown) return drawFile(name, "beside, hidden: ", PanelColor::dim_text);
  drawFile(name, "beside: ");
  if (!beside->covers(model.shownTime())) {
    ImGui::TextDisabled("which does not reach this moment");
    return;
  }
  const PartingStudy* const partings = model.partings();
  if (partings == nullptr || !partings->isFinished()) {
    ImGui::TextDisabled("looking for where the two part");
  } else if (const std::string fault = partings->fault(); !fault.empty()) {
    const std::string& shown = model.session()->log().name();
    const std::string brief = withoutFolder(withoutFolder(fault, name), shown);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + nameRoom());
    ImGui::TextColored(panelInk(PanelColor::dim_text), "%s",
                       linesOf("not compared: " + brief, nameRoom()).c_str());
    ImGui::PopTextWrapPos();
    explain(fault.c_str());
  } else if (const auto apart = partings->apartAt(model.shownTime()); apart.empty()) {
    ImGui::TextUnformatted("the two are not apart here");
  } else {
    const std::string text = "apart: " + fewOf(apart);
    drawCut(text, PanelColor::fault, nameRoom());
    explain((text + "\nK and Shift K go to where the two part").c_str());
  }
  if (const auto largest = partings == nullptr ? std::nullopt : partings->largest()) {
    const std::string text = fmt::format("most: {}{}{}", plainText(largest->item),
                                         largest->size.empty() ? "" : " ", largest->size);
    if (ImGui::Selectable(text.c_str(), false, 0, ImGui::CalcTextSize(text.c_str()))) {
      model.cursor()->seek(largest->at, now);
      model.viewer.time_view.follow(largest->at);
    }
    explain((plainText(largest->what) + "\na click, or Ctrl K, goes there").c_str());
  }
}

/// Draws received data that does not fit the cell.
void drawMisfits(const ViewModel& model) {
  constexpr std::size_t kMaxNamed = 8;
  const std::vector<Misfit>& misfits = model.mismatchedDevices();
  if (misfits.empty() || !model.cell().bare_model.empty()) return;
  ImGui::TextColored(panelInk(PanelColor::fault), "%s",
                     (countText(misfits.size(), "device") +
                      (misfits.size() == 1 ? " does not fit the cell" : " do not fit the cell"))
                         .c_str());
  if (!ImGui::IsItemHovered()) return;
  std::string text;
  for (std::size_t i = 0; i < std::min(misfits.size(), kMaxNamed); ++i) {
    text += (i > 0 ? "\n" : "") + plainText(misfits[i].device) + " " + plainText(misfits[i].what);
  }
  if (misfits.size() > kMaxNamed) {
    text += fmt::format("\n... and {} more", misfits.size() - kMaxNamed);
  }
  ImGui::SetTooltip("%s\nrocinante check tells all of it", text.c_str());
}

/// One column per frame with stacked stages, and a line at the target.
void drawGraph(const ViewerStatus& status) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 graph(ImGui::GetContentRegionAvail().x, px(kGraphHeight));
  ImGui::Dummy(graph);
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddRectFilled(corner, ImVec2(corner.x + graph.x, corner.y + graph.y),
                      panelColor(PanelColor::graph_ground), 3);
  const double target_ms = 1000 / status.target_fps;
  double highest = target_ms * 1.5;
  for (std::size_t i = 0; i < status.times.count(); ++i) {
    highest = std::max(highest, std::min(status.times[i].total(), target_ms * 6));
  }
  const float bottom = corner.y + graph.y;
  const float column = graph.x / static_cast<float>(FrameHistory::kFrames);
  const auto height = [&](double ms) {
    return static_cast<float>(std::min(ms / highest, 1.0)) * graph.y;
  };
  for (std::size_t i = 0; i < status.times.count(); ++i) {
    const float x =
        corner.x + column * static_cast<float>(FrameHistory::kFrames - status.times.count() + i);
    double below = 0;
    for (const Stage& stage : kStages) {
      const double above = below + status.times[i].*stage.time;
      list->AddRectFilled(ImVec2(x, bottom - height(above)),
                          ImVec2(x + column, bottom - height(below)), panelColor(stage.color));
      below = above;
    }
  }
  const float line = bottom - height(target_ms);
  list->AddLine(ImVec2(corner.x, line), ImVec2(corner.x + graph.x, line),
                panelColor(PanelColor::graph_target));
}

/// "detail 3", or "auto: 3" if chosen by the governor; at rest "auto: full".
std::string rungText(const ViewerStatus& status) {
  if (status.refined) return "auto: full";
  return status.rung_fixed || !status.may_govern ? fmt::format("detail {}", status.rung)
                                                 : fmt::format("auto: {}", status.rung);
}

/// Empty while nothing was measured, and under a script.
std::string stateText(const ViewerStatus& status) {
  if (!status.tells_times || status.times.count() == 0) return {};
  const FrameState state = status.refining                  ? FrameState::refining
                           : status.refined || status.still ? FrameState::at_rest
                                                            : FrameState::drawing;
  return frameStateText(state, status.times.mean().total(), status.target_fps);
}

void drawTimes(const ViewerStatus& status) {
  const FrameTimes& mean = status.times.mean();
  ImGui::TextUnformatted(frameCostText(mean.total()).c_str());
  drawGraph(status);
  for (const Stage& stage : kStages) {
    ImGui::TextColored(panelInk(stage.color), "%s %.1f", stage.name, mean.*stage.time);
    if (&stage != &kStages.back()) ImGui::SameLine();
  }
}

void drawRung(const ViewerStatus& status, ViewerRequests& requests) {
  const DetailRung& rung = kDetailRungs[static_cast<std::size_t>(status.rung)];
  std::string what =
      status.rung == 0 ? "everything" : fmt::format("{:.0f} %", rung.resolution * 100);
  if (status.rung > 0 && !rung.multisampled) what += ", 1 sample";
  if (status.drops_looks) what += ", no shadows";
  if (rung.level.geometry_error_px > 0) {
    what += fmt::format(", {:g} px off", rung.level.geometry_error_px);
  }
  ImGui::SetNextItemWidth(px(92));
  if (ImGui::BeginCombo("##rung", rungText(status).c_str())) {
    if (status.may_govern && ImGui::Selectable("auto", !status.rung_fixed)) requests.rung = -1;
    for (int i = 0; i <= kCoarsestRung; ++i) {
      if (ImGui::Selectable(fmt::format("{}", i).c_str(), status.rung_fixed && status.rung == i)) {
        requests.rung = i;
      }
    }
    ImGui::EndCombo();
  }
  explain("how much is drawn: 0 is everything; auto holds the frame rate");
  if (status.may_govern && !status.rung_fixed) {
    ImGui::SameLine();
    auto fps = static_cast<int>(status.target_fps + 0.5);
    ImGui::SetNextItemWidth(px(108));
    if (ImGui::DragInt("##fps", &fps, 0.5F, 5, 120, "for %d /s", ImGuiSliderFlags_AlwaysClamp)) {
      requests.target_fps = fps;
    }
    explain("frames a second to hold: drag, or double click and type");
  }
  ImGui::TextDisabled(
      "%s%s", what.c_str(),
      rung.level.geometry_error_px > 0 && !status.coarse_ready ? "; making coarser meshes" : "");
}

}  // namespace

std::vector<Caveat> caveatsOf(const ViewModel& model) {
  std::vector<Caveat> caveats;
  const Timeline* const session = model.session();
  if (model.isLive()) {
    if (!model.showsNow()) {
      caveats.push_back({"an earlier moment, not now", "N goes to now", PanelColor::fault, true});
    }
  } else if (session != nullptr) {
    if (const std::size_t places = session->log().damage().size(); places > 0) {
      caveats.push_back({"damaged in " + countText(places, "place"),
                         "rocinante log doctor says where, and what it cost", PanelColor::fault});
    }
    if (model.recordedLosses() > 0) {
      caveats.push_back({fmt::format("{} lost while recording", model.recordedLosses()),
                         "counted by the recorder; rocinante log info says when",
                         PanelColor::fault});
    }
  }
  if (const std::vector<std::string>& left = model.viewer.panels.open.left; !left.empty()) {
    caveats.push_back({"live behind this: " + fewOf(left),
                       "it is heard and kept; `live` in the palette (Ctrl P) goes back to it",
                       PanelColor::dim_text, true});
  }
  return caveats;
}

void drawFrameTab(const ViewerStatus& status, ViewerRequests& requests) {
  drawRung(status, requests);
  ImGui::TextUnformatted(cli::counted(status.triangles, "triangle").c_str());
  ImGui::TextUnformatted(cli::counted(status.draws, "draw call").c_str());
  if (status.tells_times && status.times.count() > 0) drawTimes(status);
  ImGui::TextDisabled("%s", status.renderer.c_str());
}

float drawFigures(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                  const PanelRectangle& room) {
  PlacedPanel placed(model.viewer.panels.places, "figures", {DockEdge::right, room, false},
                     px(kFiguresWidth));
  if (!placed.begin()) return room.y;
  if (placed.collapsed()) {
    drawCollapsed("Figures");
  } else {
    drawSession(model, now);
    drawCaveats(model);
    drawBeside(model, now);
    drawMisfits(model);
    std::string frame = rungText(status);
    if (const std::string state = stateText(status); !state.empty()) frame += ", " + state;
    ImGui::TextDisabled("%s", frame.c_str());
    explain("more in the tab Frame");
  }
  const float end = ImGui::GetWindowPos().y + ImGui::GetWindowSize().y;
  placed.end();
  return placed.floating() ? room.y : end;
}

}  // namespace rocinante
