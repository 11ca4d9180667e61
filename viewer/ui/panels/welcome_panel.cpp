#include <fmt/format.h>

#include <algorithm>

#include "viewer/ui/commands/command.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

constexpr float kWelcomeWidth = 430;
constexpr std::size_t kMaxRecent = 6;

/// What was heard, and a line to type any other endpoint in.
void drawConnect(ViewModel& model, ViewerRequests& requests) {
  OpenState& open = model.viewer.panels.open;
  if (open.listens && model.survey() == nullptr) model.listenAround();
  ImGui::TextDisabled("Live");
  for (const EndpointLine& line : endpointLines(model)) {
    if (drawEndpoint(line, false)) requests.connect = splitWords(line.endpoints);
  }
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##endpoint", "an endpoint, as :19960 or udp://239.1.2.3:5000",
                               open.endpoint.data(), open.endpoint.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue)) {
    requests.connect = splitWords(open.endpoint.data());
  }
  explain("Enter listens there; Ctrl+O listens again at the usual endpoints");
}

std::string megabytes(std::uint64_t bytes) {
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

}  // namespace

void drawWelcome(ViewModel& model, bool loading, ViewerRequests& requests) {
  if (loading || model.viewer.panels.open.shown) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(std::min(px(kWelcomeWidth), size.x), 0));
  ImGui::Begin("welcome", nullptr,
               (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoResize);
  ImGui::TextUnformatted("Drop a cell, a model or a log on this window.");
  ImGui::TextDisabled("*.cell.toml, URDF, SDF, OBJ, STL, COLLADA, glTF, *.mcap, bags");
  ImGui::TextDisabled("A log without a cell shows its poses as axes, and its signals.");
  ImGui::TextDisabled("Two logs together: one beside the other, as ghosts.");
  ImGui::Spacing();
  if (ImGui::Button("Open a file ...", ImVec2(-1, 0))) {
    std::error_code ignored;
    model.viewer.panels.open.open(std::filesystem::current_path(ignored));
  }
  const std::size_t shown = std::min(model.viewer.panels.open.recent.size(), kMaxRecent);
  if (shown > 0) {
    ImGui::Spacing();
    ImGui::TextDisabled("Shown before");
  }
  for (std::size_t i = 0; i < shown; ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (drawRecent(model.viewer.panels.open.recent[i], false))
      openRecent(model.viewer.panels.open.recent[i], requests);
    ImGui::PopID();
  }
  ImGui::Spacing();
  drawConnect(model, requests);
  ImGui::Spacing();
  ImGui::TextDisabled("Ctrl+O opens, Ctrl+P finds a command, F1 shows the keys");
  ImGui::End();
}

void drawLoading(const LoadingStatus& loading, bool is_empty) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, is_empty ? size.y / 2 : px(kPanelMargin)),
                          ImGuiCond_Always, ImVec2(0.5F, is_empty ? 0.5F : 0));
  ImGui::SetNextWindowSize(ImVec2(std::min(px(kWelcomeWidth), size.x), 0));
  ImGui::Begin("loading", nullptr,
               (kPanelFlags & ~ImGuiWindowFlags_AlwaysAutoResize) | ImGuiWindowFlags_NoTitleBar |
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoInputs);
  ImGui::Text("Loading %s", loading.name.c_str());
  const LoadProgress& now = loading.progress;
  const auto total = static_cast<float>(now.bytes_total);
  const float part = total > 0 ? static_cast<float>(now.bytes_done) / total : 0;
  ImGui::ProgressBar(part, ImVec2(-1, px(6)), "");
  if (!loading.waits_for.empty()) {
    ImGui::TextDisabled("%s", loading.waits_for.c_str());
  } else if (now.files_total == 0) {
    ImGui::TextDisabled("reading");
  } else {
    ImGui::TextDisabled("%s",
                        fmt::format("{} of {} files, {} of {}", now.files_done, now.files_total,
                                    megabytes(now.bytes_done), megabytes(now.bytes_total))
                            .c_str());
  }
  ImGui::End();
}

}  // namespace rocinante
