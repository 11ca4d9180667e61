#include <algorithm>
#include <cmath>

#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"

namespace rocinante {
namespace {

constexpr const char* kEverything = "*";

/// The object of wireframe and similar looks: the selection, else every device.
std::string subjectPath(const ViewModel& model) {
  return model.selected.device.empty() ? kEverything : model.selected.path();
}

bool has(const std::vector<std::string>& paths, const std::string& path) {
  return std::ranges::find(paths, path) != paths.end();
}

void drawPathToggle(const char* label, const std::string& path, std::vector<std::string>& paths) {
  bool on = has(paths, path);
  if (!ImGui::Checkbox(label, &on)) return;
  std::erase(paths, path);
  if (on) paths.push_back(path);
}

void drawTransparent(const std::string& path, RenderStyle& style) {
  const auto found = std::ranges::find(style.transparent, path, &TransparentStyle::path);
  bool on = found != style.transparent.end();
  if (ImGui::Checkbox("see-through", &on)) {
    if (on) {
      style.transparent.push_back({path, 0.3});
    } else {
      style.transparent.erase(found);
    }
    return;
  }
  if (!on) return;
  ImGui::SameLine();
  auto percent = static_cast<int>(found->opacity * 100 + 0.5);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##opacity", &percent, 0, 100, "%d %%")) found->opacity = percent / 100.0;
}

void drawTrail(const std::string& path, RenderStyle& style) {
  const auto found = std::ranges::find(style.trails, path, &TrailStyle::path);
  bool on = found != style.trails.end();
  if (ImGui::Checkbox("trail", &on)) {
    if (on) {
      style.trails.push_back({path, std::chrono::seconds(5)});
    } else {
      style.trails.erase(found);
    }
    return;
  }
  explain("its way over the last seconds");
  if (!on) return;
  ImGui::SameLine();
  auto seconds = static_cast<int>(found->window / std::chrono::seconds(1));
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##window", &seconds, 1, 60, "%d s")) {
    found->window = std::chrono::seconds(std::clamp(seconds, 1, 3600));
  }
}

void drawSelectedLooks(const ViewModel& model, RenderStyle& style) {
  const std::string path = subjectPath(model);
  drawCut(path == kEverything ? "every device" : path, PanelColor::dim_text);
  drawPathToggle("wireframe", path, style.wireframe);
  drawTransparent(path, style);
  drawPathToggle("collision geometry instead", path, style.collision);
  drawPathToggle("collision geometry too", path, style.collision_over);
  drawPathToggle("axes of links", path, style.frames);
  if (path != kEverything && model.session() != nullptr) drawTrail(path, style);
}

void drawBackdrop(BackdropChoice& backdrop) {
  ImGui::Checkbox("backdrop", &backdrop.shown);
  explain("pictures of the real camera, in its views (Shift and B)");
  if (!backdrop.shown) return;
  ImGui::SameLine(px(140));
  auto percent = static_cast<int>(backdrop.opacity * 100 + 0.5);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##backdrop", &percent, 0, 100, "%d %% over")) {
    backdrop.opacity = percent / 100.0;
  }
  explain("how much of it covers the model");
  auto offset = static_cast<float>(static_cast<double>(backdrop.offset.count()) / 1e9);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::DragFloat("##offset", &offset, 0.01F, -86400.0F, 86400.0F, "begins at %.3f s")) {
    backdrop.offset = Nanoseconds(std::llround(static_cast<double>(offset) * 1e3) * 1'000'000);
  }
  explain("the session time of the backdrop's beginning: drag, or double click and type");
}

}  // namespace

void drawLookTab(ViewModel& model) {
  if (model.backdrop) drawBackdrop(*model.backdrop);
  RenderStyle style = model.style();
  constexpr const char* kEdges[] = {"off", "on", "only"};
  int edges = static_cast<int>(style.edges);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("edges");
  for (int i = 0; i < 3; ++i) {
    ImGui::SameLine();
    if (ImGui::RadioButton(kEdges[i], &edges, i)) style.edges = static_cast<EdgeStyle>(i);
  }
  ImGui::Checkbox("shadows", &style.shadows);
  ImGui::SameLine(px(140));
  ImGui::Checkbox("contact", &style.contact);
  explain("darker where surfaces are near each other");
  bool plain = style.shading == Shading::plain;
  if (ImGui::Checkbox("plain light", &plain)) {
    style.shading = plain ? Shading::plain : Shading::standard;
  }
  explain("one light, neither shadows nor contact");
  ImGui::SameLine(px(140));
  ImGui::Checkbox("joint limits", &style.limits);
  explain("links near a limit amber, beyond it red");
  ImGui::Checkbox("scale bar", &style.scale_bar);
  ImGui::Checkbox("camera's cone", &style.camera_cone);
  explain("what the picture shows, in insets without perspective, such as a map");
  ImGui::SameLine(px(140));
  bool clear = style.ghosts == GhostStyle::clear;
  if (ImGui::Checkbox("one-tone ghosts", &clear)) {
    style.ghosts = clear ? GhostStyle::clear : GhostStyle::plain;
  }
  explain("ghosts in one tone with bright rims, behind the actual device");
  bool apart = style.labels == LabelStyle::apart;
  if (ImGui::Checkbox("labels apart", &apart)) {
    style.labels = apart ? LabelStyle::apart : LabelStyle::beside;
  }
  ImGui::Checkbox("outline what is selected", &model.viewer.outline_selected);
  if (std::ranges::any_of(model.cell().layers,
                          [](const CellLayer& layer) { return layer.look != LayerLook(); })) {
    ImGui::Checkbox("looks of layers", &style.layer_looks);
    explain("lines, see-through and collision geometry as the cell has its layers");
  }
  for (const char* layer : {"grid", "labels", "lines", "points", "gnomon"}) {
    const std::string path = std::string("layer/") + layer;
    bool visible = model.choice().layerVisible(layer);
    if (ImGui::Checkbox(layer, &visible)) {
      model.setVisible(path, visible ? std::optional<bool>() : std::optional<bool>(false));
    }
    if (std::string_view(layer) != "gnomon") ImGui::SameLine();
    if (std::string_view(layer) == "lines") ImGui::NewLine();
  }
  ImGui::Separator();
  drawSelectedLooks(model, style);
  model.setStyle(style);
  ImGui::Separator();
  if (ImGui::Button("plain picture", ImVec2(-1, 0))) model.setStyle(RenderStyle());
  explain("all looks off");
}

}  // namespace rocinante
