#include "viewer/ui/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>

#include "core/duration_text.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

constexpr float kMargin = 10;
constexpr float kPanelWidth = 270;
constexpr ImGuiWindowFlags kPanelFlags =
    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

void drawCameras(ViewModel& model, bool& fit_requested) {
  const std::string& current = model.cameraName();
  ImGui::SetNextItemWidth(-60);
  if (ImGui::BeginCombo("##camera", current.empty() ? "free" : current.c_str())) {
    for (const std::string& name : model.cameraNames()) {
      if (ImGui::Selectable(name.c_str(), name == current)) model.useCamera(name);
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  if (ImGui::Button("Fit", ImVec2(-1, 0))) fit_requested = true;
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show everything (F)");
}

void drawLayers(ViewModel& model) {
  if (model.cell().layers.empty() ||
      !ImGui::CollapsingHeader("Layers", ImGuiTreeNodeFlags_DefaultOpen)) {
    return;
  }
  for (const CellLayer& layer : model.cell().layers) {
    const std::string path = "layer/" + encodeName(layer.name);
    bool visible = layer.visible;
    if (const auto chosen = model.chosenVisibility(path)) visible = *chosen;
    if (ImGui::Checkbox(layer.name.c_str(), &visible)) model.setVisible(path, visible);
  }
}

void drawDevices(ViewModel& model) {
  if (!ImGui::CollapsingHeader("Devices", ImGuiTreeNodeFlags_DefaultOpen)) return;
  ImGui::BeginChild("devices", ImVec2(0, 150));
  for (const PosedDevice& device : model.scene().devices) {
    ImGui::PushID(device.name.c_str());
    const std::string path = encodeName(device.name);
    bool visible = device.visible;
    if (const auto chosen = model.chosenVisibility(path)) visible = *chosen;
    if (ImGui::Checkbox("##visible", &visible)) model.setVisible(path, visible);
    ImGui::SameLine();
    if (ImGui::Selectable(device.name.c_str(), device.name == model.selected_device)) {
      model.selected_device = device.name == model.selected_device ? "" : device.name;
    }
    ImGui::PopID();
  }
  ImGui::EndChild();
}

/// What was said about the selected device, in the session's own words and numbers.
void drawSelected(const ViewModel& model) {
  const auto found = model.state().devices().find(model.selected_device);
  if (model.selected_device.empty()) return;
  ImGui::Separator();
  ImGui::TextUnformatted(model.selected_device.c_str());
  if (found == model.state().devices().end()) {
    ImGui::TextDisabled("nothing said yet");
    return;
  }
  const DeviceState& device = found->second;
  const PosedDevice* posed = model.scene().findDevice(model.selected_device);
  if (device.joints) {
    const auto& values = device.joints->value;
    std::vector<std::size_t> movable;
    if (posed != nullptr && posed->model != nullptr) movable = posed->model->movableJoints();
    const bool named = movable.size() == values.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string name =
          named ? posed->model->joints[movable[i]].name : fmt::format("[{}]", i);
      ImGui::Text("%-14s %9.4f", name.c_str(), values[i]);
    }
  }
  for (const auto& [name, value] : device.named_joints) {
    ImGui::Text("%-14s %9.4f", name.c_str(), value.value);
  }
  if (device.pose) {
    const Vec3& at = device.pose->value.pose.position;
    ImGui::Text("pose %.3f %.3f %.3f m", at.x, at.y, at.z);
    if (!device.pose->value.carrier.first.empty()) {
      ImGui::Text("in %s/%s", device.pose->value.carrier.first.c_str(),
                  device.pose->value.carrier.second.c_str());
    }
  }
}

void drawLive(const ViewModel& model) {
  for (const Endpoint& endpoint : model.feed().endpoints()) {
    ImGui::TextUnformatted(endpoint.text().c_str());
  }
  const LiveSnapshot* live = model.live();
  if (live == nullptr || live->datagrams == 0) {
    ImGui::TextDisabled("listening; nothing has come yet");
    return;
  }
  ImGui::Text("%.0f packets/s", live->rate_hz);
  ImGui::Text("%llu datagrams", static_cast<unsigned long long>(live->datagrams));
  const std::uint64_t lost = live->dropped + live->gaps;
  const ImVec4 color = lost == 0 ? ImVec4(0.55F, 0.85F, 0.62F, 1) : ImVec4(1, 0.55F, 0.45F, 1);
  ImGui::TextColored(color, "lost: %llu by this machine, %llu before",
                     static_cast<unsigned long long>(live->dropped),
                     static_cast<unsigned long long>(live->gaps));
  if (live->undecoded > 0) {
    ImGui::Text("%llu are no packets", static_cast<unsigned long long>(live->undecoded));
  }
}

void drawFigures(const ViewModel& model, const FrameFigures& figures) {
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos(ImVec2(io.DisplaySize.x - kMargin, kMargin), ImGuiCond_Always,
                          ImVec2(1, 0));
  ImGui::Begin("figures", nullptr, kPanelFlags | ImGuiWindowFlags_NoTitleBar);
  if (model.isLive()) {
    drawLive(model);
  } else if (const Timeline* session = model.session()) {
    ImGui::TextUnformatted(
        std::filesystem::path(session->log().name()).filename().string().c_str());
    ImGui::Text("%llu datagrams",
                static_cast<unsigned long long>(session->log().summary().messages));
  } else {
    ImGui::TextDisabled("the cell at rest");
  }
  if (figures.frame_ms > 0) ImGui::Text("%.1f ms a frame", figures.frame_ms);
  ImGui::Text("%llu triangles", static_cast<unsigned long long>(figures.triangles));
  ImGui::TextDisabled("%s", figures.renderer.c_str());
  ImGui::End();
}

}  // namespace

void stylePanels() {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 6;
  style.FrameRounding = 4;
  style.GrabRounding = 4;
  style.ChildRounding = 4;
  style.WindowBorderSize = 0;
  style.WindowPadding = ImVec2(12, 10);
  style.ItemSpacing = ImVec2(8, 6);
  style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09F, 0.11F, 0.13F, 0.86F);
  style.Colors[ImGuiCol_TitleBgActive] = style.Colors[ImGuiCol_TitleBg] =
      ImVec4(0.13F, 0.16F, 0.19F, 0.95F);
  style.Colors[ImGuiCol_Header] = ImVec4(0.22F, 0.30F, 0.38F, 0.8F);
  style.Colors[ImGuiCol_Button] = ImVec4(0.22F, 0.30F, 0.38F, 1.0F);
  style.Colors[ImGuiCol_FrameBg] = ImVec4(0.25F, 0.31F, 0.37F, 1.0F);
  style.Colors[ImGuiCol_CheckMark] = ImVec4(1.0F, 0.66F, 0.25F, 1.0F);
}

void drawPanels(ViewModel& model, const FrameFigures& figures, SteadyTime now,
                bool& fit_requested) {
  if (!model.panels_shown) return;
  ImGui::SetNextWindowPos(ImVec2(kMargin, kMargin));
  ImGui::SetNextWindowSizeConstraints(ImVec2(kPanelWidth, 0), ImVec2(kPanelWidth, 1e6F));
  ImGui::Begin("Scene", nullptr, kPanelFlags);
  drawCameras(model, fit_requested);
  drawLayers(model);
  drawDevices(model);
  drawSelected(model);
  if (!model.complaint.empty()) {
    ImGui::Separator();
    ImGui::PushTextWrapPos(kPanelWidth - 20);
    ImGui::TextColored(ImVec4(1, 0.6F, 0.4F, 1), "%s", model.complaint.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
  drawFigures(model, figures);
  if (Transport* transport = model.transport()) drawTimeBar(model, *transport, now);
}

}  // namespace rocinante
