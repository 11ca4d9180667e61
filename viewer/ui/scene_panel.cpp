#include <fmt/format.h>

#include <algorithm>

#include "core/packet/packet_text.h"
#include "viewer/ui/panel_parts.h"

namespace rocinante {
namespace {

/// A check box for what is seen now. Who chose otherwise than packets and cell sees that, and can
/// give it back.
void drawVisibility(ViewModel& model, const std::string& path, bool by_default, const char* label) {
  const auto chosen = model.chosenVisibility(path);
  bool visible = chosen.value_or(by_default);
  if (ImGui::Checkbox(label, &visible)) model.setVisible(path, visible);
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("cell and packets: %s\nyour choice: %s", by_default ? "shown" : "hidden",
                      !chosen   ? "none"
                      : *chosen ? "shown"
                                : "hidden");
  }
  if (!chosen) return;
  ImGui::SameLine();
  if (ImGui::SmallButton("auto")) model.setVisible(path, std::nullopt);
  explain("give your choice back to cell and packets");
}

void drawCameraRow(ViewModel& model, ViewerWishes& wishes) {
  const std::string& current = model.cameraName();
  ImGui::SetNextItemWidth(-52);
  if (ImGui::BeginCombo("##camera", current.empty() ? "free" : current.c_str())) {
    for (const std::string& name : model.cameraNames()) {
      if (ImGui::Selectable(name.c_str(), name == current)) model.useCamera(name);
    }
    ImGui::EndCombo();
  }
  explain("the camera: 1 to 9, or drag the picture");
  ImGui::SameLine();
  if (ImGui::Button("Fit", ImVec2(-1, 0))) wishes.fit = true;
  explain("show everything (F)");
}

void drawInsets(ViewModel& model) {
  if (!ImGui::CollapsingHeader("Insets")) return;
  for (std::size_t i = 0; i < model.insets.size(); ++i) {
    InsetChoice& choice = model.insets[i];
    ImGui::PushID(static_cast<int>(i));
    ImGui::Checkbox("##shown", &choice.shown);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-34);
    if (ImGui::BeginCombo("##camera", choice.inset.camera.c_str())) {
      std::vector<std::string> names = model.cameraNames();
      names.insert(names.end(), {"map", "fit"});
      for (const std::string& name : names) {
        if (ImGui::Selectable(name.c_str(), name == choice.inset.camera)) {
          choice.inset.camera = name;
          choice.inset.title.reset();
        }
      }
      ImGui::EndCombo();
    }
    ImGui::SameLine();
    const bool gone = ImGui::SmallButton("x");
    explain("take this window away");
    ImGui::PopID();
    if (gone) {
      model.insets.erase(model.insets.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
  if (ImGui::SmallButton("add a window")) {
    CellInset inset;
    inset.camera = "map";
    model.insets.push_back({inset, true});
  }
}

void drawLayers(ViewModel& model) {
  if (model.cell().layers.empty() ||
      !ImGui::CollapsingHeader("Layers", ImGuiTreeNodeFlags_DefaultOpen)) {
    return;
  }
  for (const CellLayer& layer : model.cell().layers) {
    ImGui::PushID(layer.name.c_str());
    drawVisibility(model, "layer/" + encodeName(layer.name), model.layerVisibleByDefault(layer),
                   layer.name.c_str());
    ImGui::PopID();
  }
}

void drawLinks(ViewModel& model, const PosedDevice& device) {
  for (std::size_t i = 0; i < device.model->links.size(); ++i) {
    const Link& link = device.model->links[i];
    if (link.visuals.empty()) continue;
    ImGui::PushID(static_cast<int>(i));
    const Selection here{device.name, link.name};
    drawVisibility(model, here.path(), device.link_visible[i], "##visible");
    ImGui::SameLine();
    const bool selected = model.selected == here;
    if (ImGui::Selectable(link.name.c_str(), selected)) {
      model.selected = selected ? Selection{device.name, ""} : here;
    }
    ImGui::PopID();
  }
}

void drawDevices(ViewModel& model) {
  if (!ImGui::CollapsingHeader("Devices", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const float rows = static_cast<float>(std::min<std::size_t>(model.scene().devices.size(), 9));
  const float height = std::max(3.0F, rows) * ImGui::GetFrameHeightWithSpacing();
  ImGui::BeginChild("devices", ImVec2(0, height));
  for (const PosedDevice& device : model.scene().devices) {
    ImGui::PushID(device.name.c_str());
    const Selection here{device.name, ""};
    drawVisibility(model, here.path(), device.visible, "##visible");
    ImGui::SameLine();
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth;
    if (model.selected == here) flags |= ImGuiTreeNodeFlags_Selected;
    const bool jointed = device.model != nullptr && device.model->links.size() > 1;
    if (!jointed) flags |= ImGuiTreeNodeFlags_Leaf;
    const bool open = ImGui::TreeNodeEx("device", flags, "%s", device.name.c_str());
    if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) {
      model.selected = model.selected == here ? Selection{} : here;
    }
    if (open) {
      if (jointed) drawLinks(model, device);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
  ImGui::EndChild();
}

}  // namespace

void drawSceneTab(ViewModel& model, ViewerWishes& wishes) {
  drawCameraRow(model, wishes);
  drawInsets(model);
  drawLayers(model);
  drawDevices(model);
}

void drawEventsTab(ViewModel& model, SteadyTime now, ViewerWishes& wishes) {
  Transport& transport = *model.transport();
  const std::vector<Event>& events = model.events();
  if (events.empty()) ImGui::TextDisabled("no event in this session");
  const float rows = static_cast<float>(std::clamp<std::size_t>(events.size(), 1, 14));
  ImGui::BeginChild("events", ImVec2(0, rows * ImGui::GetTextLineHeightWithSpacing() + 4));
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Event& event = events[i];
    ImGui::PushID(static_cast<int>(i));
    const std::string line = fmt::format(
        "{:9.3f}  {}{}{}", std::chrono::duration<double>(event.time - model.origin()).count(),
        event.source, event.source.empty() ? "" : ": ", event.text);
    const bool here = event.time == transport.position(now);
    if (ImGui::Selectable(line.c_str(), here)) transport.seek(event.time, now);
    explain(line.c_str());
    ImGui::PopID();
  }
  ImGui::EndChild();
  auto& text = model.mark_text;
  ImGui::SetNextItemWidth(-60);
  const bool entered = ImGui::InputTextWithHint("##mark", "a mark at this moment", text.data(),
                                                text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if ((ImGui::Button("Mark", ImVec2(-1, 0)) || entered) && text[0] != 0) {
    wishes.mark = text.data();
    text[0] = 0;
  }
  explain("kept beside the log, in LOG.marks");
}

}  // namespace rocinante
