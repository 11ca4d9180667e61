#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/plain_text.h"
#include "core/foreign/recordings/opened_recording.h"
#include "viewer/ui/commands/command.h"
#include "viewer/ui/commands/palette_entries.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr float kOpenWidth = 620;
constexpr int kOpenLines = 16;

/// A line of the list: endpoints, something shown before, or a file or folder.
struct OpenLine {
  EndpointLine endpoints;  ///< empty: none
  std::optional<RecentContent> recent;
  FileEntry entry;
};

std::string recentText(const RecentContent& recent) {
  std::string text = recent.cell.filename().string();
  if (!recent.log.empty() && recent.log != recent.cell)
    text += (text.empty() ? "" : " + ") + recent.log.filename().string();
  return plainText(text);
}

/// Best first when something is typed.
std::vector<OpenLine> openLines(const ViewModel& model, std::string_view typed) {
  const OpenState& open = model.viewer.panels.open;
  std::vector<std::pair<int, OpenLine>> scored;
  for (RecentContent& recent : open.offered()) {
    if (const auto score = fuzzyScore(typed, recentText(recent))) {
      scored.push_back({*score, {{}, std::move(recent), {}}});
    }
  }
  // Behind every file that matches: nearly any letters are somewhere in an endpoint.
  for (EndpointLine& line : endpointLines(model)) {
    if (open.beside) break;
    if (!containsWord(line.endpoints + " " + line.note, typed)) continue;
    scored.push_back({0, {std::move(line), {}, {}}});
  }
  if (typed.empty() && open.folder.has_relative_path())
    scored.push_back({0, {{}, {}, {"../", true}}});
  for (const FileEntry& entry : open.entries) {
    if (open.beside && !entry.is_folder && !canBeBeside(entry.name)) continue;
    if (const auto score = fuzzyScore(typed, entry.name))
      scored.push_back({*score, {{}, {}, entry}});
  }
  if (!typed.empty()) {
    std::ranges::stable_sort(scored, std::greater<>(), &std::pair<int, OpenLine>::first);
  }
  std::vector<OpenLine> lines;
  for (auto& [score, line] : scored) lines.push_back(std::move(line));
  return lines;
}

/// What was typed as a path: from the root, the home folder, or with a slash in it.
std::optional<fs::path> typedPath(const OpenState& open) {
  const std::string typed = open.text.data();
  if (typed.find('/') == std::string::npos) return std::nullopt;
  const char* const home = std::getenv("HOME");
  if (typed.starts_with("~/") && home != nullptr) return fs::path(home) / typed.substr(2);
  return open.folder / typed;
}

/// What was chosen, in place of what is shown or beside it.
void ask(const fs::path& file, OpenState& open, ViewerRequests& requests) {
  open.shown = false;
  if (open.beside) {
    requests.beside = BesideWish{file, {}};
  } else {
    requests.open = {file};
  }
}

void take(const OpenLine& line, OpenState& open, ViewerRequests& requests) {
  if (!line.endpoints.endpoints.empty()) {
    open.shown = false;
    requests.connect = splitWords(line.endpoints.endpoints);
    return;
  }
  if (line.recent && open.beside) return ask(line.recent->log, open, requests);
  if (line.recent) {
    open.shown = false;
    return openRecent(*line.recent, requests);
  }
  const fs::path path = open.folder / line.entry.name;
  if (line.entry.is_folder) {
    open.enter(path);
    open.just_opened = true;
  } else {
    ask(path, open, requests);
  }
}

void takePath(const fs::path& path, OpenState& open, ViewerRequests& requests) {
  std::error_code unknown;
  if (fs::is_directory(path, unknown) && !isForeignRecording(path)) {
    open.enter(path);
    open.just_opened = true;
  } else {
    ask(path, open, requests);
  }
}

/// Whether what is chosen comes beside the log that is shown.
void drawBesideBox(OpenState& open) {
  if (open.log.empty()) return;
  const std::string text = "beside " + plainText(open.log.filename().string());
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeightWithSpacing();
  const std::string shown = cutInMiddle(text, room, drawnWidth);
  if (ImGui::Checkbox((shown + "###beside").c_str(), &open.beside)) {
    open.chosen = 0;
    open.just_opened = true;  // what is typed comes next
  }
  explain("a log that is chosen is shown as ghosts and curves with this one");
}

bool drawLine(const OpenLine& line, bool chosen) {
  if (!line.endpoints.endpoints.empty()) return drawEndpoint(line.endpoints, chosen);
  if (line.recent) return drawRecent(*line.recent, chosen);
  const ImVec4 color =
      ImGui::GetStyleColorVec4(line.entry.is_folder ? ImGuiCol_TextDisabled : ImGuiCol_Text);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  const std::string name = plainText(line.entry.name);
  const std::string shown = cutInMiddle(name, ImGui::GetContentRegionAvail().x, drawnWidth);
  const bool clicked = ImGui::Selectable((shown + "###file").c_str(), chosen);
  ImGui::PopStyleColor();
  explainCut(shown, name);
  return clicked;
}

}  // namespace

std::vector<EndpointLine> endpointLines(const ViewModel& model) {
  std::vector<EndpointLine> lines;
  for (const std::string& left : model.viewer.panels.open.left) {
    lines.push_back({left, "goes on behind this"});
  }
  if (model.survey() == nullptr) return lines;
  std::vector<HeardEndpoint> all = model.survey()->heard();
  if (all.empty()) {
    // Lines that come a moment later would move the others under the mouse.
    for (const SurveyedEndpoint& usual : usualEndpoints()) {
      all.emplace_back().endpoint = usual.endpoint.text();
    }
  }
  for (const HeardEndpoint& heard : all) {
    const bool is_left =
        std::ranges::find(lines, heard.endpoint, &EndpointLine::endpoints) != lines.end();
    if (!is_left) lines.push_back({heard.endpoint, heard.text()});
  }
  return lines;
}

bool drawEndpoint(const EndpointLine& line, bool chosen) {
  const float left = ImGui::GetCursorPosX();
  ImGui::PushID(line.endpoints.c_str());
  const bool clicked = ImGui::Selectable("##endpoint", chosen);
  ImGui::PopID();
  const std::string where = plainText(line.endpoints);
  explain(("listen at " + where + "\n" + line.note).c_str());
  ImGui::SameLine(left);
  // The tooltip has the whole.
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string note = cutInMiddle(line.note, room, drawnWidth);
  ImGui::TextUnformatted(note.c_str());
  const float where_at = drawnWidth(note) + px(14);
  if (where_at + px(40) > room) return clicked;
  ImGui::SameLine(left + where_at);
  ImGui::TextDisabled("%s", cutInMiddle(where, room - where_at, drawnWidth).c_str());
  return clicked;
}

bool drawRecent(const RecentContent& recent, bool chosen) {
  const float left = ImGui::GetCursorPosX();
  const bool clicked = ImGui::Selectable("##recent", chosen);
  const fs::path& named = recent.cell.empty() ? recent.log : recent.cell;
  explain((plainText(named.string()) +
           (recent.log.empty() || recent.cell.empty() ? "" : "\n" + plainText(recent.log.string())))
              .c_str());
  const std::string text = recentText(recent);
  ImGui::SameLine(left);
  ImGui::TextUnformatted(text.c_str());
  const float folder_at = left + ImGui::CalcTextSize(text.c_str()).x + px(14);
  ImGui::SameLine(folder_at);
  drawCut(plainText(named.parent_path().string()), PanelColor::dim_text);
  return clicked;
}

void openRecent(const RecentContent& recent, ViewerRequests& requests) {
  requests.open.clear();
  if (!recent.cell.empty()) requests.open.push_back(recent.cell);
  if (!recent.log.empty() && recent.log != recent.cell) requests.open.push_back(recent.log);
}

void drawOpenList(ViewModel& model, ViewerRequests& requests) {
  OpenState& open = model.viewer.panels.open;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float width = std::min(px(kOpenWidth), size.x - px(2 * kPanelMargin));
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, px(4 * kPanelMargin)), ImGuiCond_Always,
                          ImVec2(0.5F, 0));
  ImGui::SetNextWindowSize(ImVec2(width, 0));
  if (open.just_opened) ImGui::SetNextWindowFocus();
  ImGui::Begin("open", nullptr,
               (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoResize);
  const bool focused = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  const bool opened = std::exchange(open.just_opened, false);
  drawCut(plainText(open.folder.string()), PanelColor::dim_text);
  const std::string before = open.text.data();
  if (opened && open.listens && !open.beside) model.listenAround();
  const bool entered = drawTypedLine("##file", "a part of a name, a path, or an endpoint",
                                     open.text, opened, open.start);
  if (before != open.text.data()) open.chosen = 0;
  drawBesideBox(open);
  const bool is_endpoint = !open.beside && looksLikeEndpoint(open.text.data());
  const auto path = is_endpoint ? std::nullopt : typedPath(open);
  const std::vector<OpenLine> lines =
      path || is_endpoint ? std::vector<OpenLine>() : openLines(model, open.text.data());
  const std::size_t chosen_before = open.chosen;
  if (keyPressed(ImGuiKey_DownArrow)) ++open.chosen;
  if (keyPressed(ImGuiKey_UpArrow) && open.chosen > 0) --open.chosen;
  open.chosen = std::min(open.chosen, lines.empty() ? 0 : lines.size() - 1);

  std::optional<OpenLine> picked;
  if (is_endpoint) {
    ImGui::TextDisabled("Enter listens at this endpoint");
  } else if (!open.fault.empty()) {
    ImGui::TextWrapped("%s", linesOf(plainText(open.fault)).c_str());
  } else if (path) {
    ImGui::TextDisabled("Enter opens this file or folder");
  } else if (lines.empty()) {
    ImGui::TextDisabled("nothing here that can be shown");
  }
  const float pitch = ImGui::GetTextLineHeightWithSpacing();
  const auto rows = static_cast<float>(std::min<std::size_t>(lines.size(), kOpenLines));
  ImGui::BeginChild("files", ImVec2(0, rows * pitch));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (drawLine(lines[i], i == open.chosen)) picked = lines[i];
    if (i == open.chosen && chosen_before != open.chosen) ImGui::SetScrollHereY();
    ImGui::PopID();
  }
  ImGui::EndChild();
  ImGui::End();
  if (entered && is_endpoint) {
    open.shown = false;
    requests.connect = splitWords(open.text.data());
    return;
  }
  if (entered && path) return takePath(*path, open, requests);
  if (entered && !lines.empty()) picked = lines[open.chosen];
  if (entered && lines.empty()) open.just_opened = true;  // to be corrected
  if (picked) {
    take(*picked, open, requests);
  } else if (keyPressed(ImGuiKey_Escape) ||
             (!focused && !opened && ImGui::IsMouseClicked(ImGuiMouseButton_Left))) {
    open.shown = false;
  }
}

}  // namespace rocinante
