#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/packet/packet_text.h"
#include "viewer/ui/model/shown_layers.h"
#include "viewer/ui/model/wall_clock.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/time_axis.h"

namespace rocinante {
namespace {

/// A check box for what the picture shows: of a part, it is half checked. Marks a user's choice
/// that differs from packets and cell, and can reset it.
void drawVisibility(ViewModel& model, const std::string& path, ShownPart shown, bool by_default,
                    const char* label, const std::string& cut_name = {}) {
  const auto chosen = model.chosenVisibility(path);
  const bool is_mixed = shown == ShownPart::some;
  bool visible =
      shown == ShownPart::nothing ? chosen.value_or(by_default) : shown != ShownPart::hidden;
  ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, is_mixed);
  const bool is_device = path.find('/') == std::string::npos;
  if (ImGui::Checkbox(label, &visible)) {
    if (is_device && ImGui::GetIO().KeyCtrl) {
      model.showOnly(path);
    } else {
      model.setVisible(path, visible || is_mixed);  // a click on a part shows all
    }
  }
  ImGui::PopItemFlag();
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s%snow: %s\ncell and packets: %s\nyour choice: %s%s", cut_name.c_str(),
                      cut_name.empty() ? "" : "\n", nameOf(shown), by_default ? "shown" : "hidden",
                      !chosen   ? "none"
                      : *chosen ? "shown"
                                : "hidden",
                      is_device ? "\nCtrl and click: this alone; Shift H: all again" : "");
  }
  if (!chosen) return;
  ImGui::SameLine();
  if (ImGui::SmallButton("auto")) model.setVisible(path, std::nullopt);
  explain("give your choice back to cell and packets");
}

constexpr std::array kBuiltInCameras{std::pair{"fit", "what can move, from the front and above"},
                                     std::pair{"map", "everything, from straight above"}};

/// What the coming closed list shows of a name.
std::string shownInList(const std::string& name) {
  const float room =
      ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
  return cutInMiddle(name, room, drawnWidth);
}

void drawCameraRow(ViewModel& model, ViewerRequests& requests) {
  const std::string current = model.cameraName();
  ImGui::SetNextItemWidth(px(-52));
  const std::string shown = shownInList(current.empty() ? "free" : current);
  if (ImGui::BeginCombo("##camera", shown.c_str())) {
    for (const std::string& name : model.cameraNames()) {
      if (ImGui::Selectable(name.c_str(), name == current)) model.useCamera(name);
    }
    for (const auto& [name, words] : kBuiltInCameras) {
      if (model.scene().findCamera(name) != nullptr) continue;
      if (ImGui::Selectable(name, name == current)) requests.built_in_camera = name;
      explain(words);
    }
    if (ImGui::Selectable("keep this view ...")) {
      model.viewer.panels.palette.open("save-camera ");
    }
    explain("type a name: the cell's file gets a camera that looks so");
    ImGui::EndCombo();
  }
  const bool is_cut = !current.empty() && shown != current;
  explain(((is_cut ? current + "\n" : "") + "the camera: 1 to 9, or drag the picture").c_str());
  ImGui::SameLine();
  if (ImGui::Button("Fit", ImVec2(-1, 0))) requests.fit = true;
  explain("what can move, else everything (F); what is selected: Shift and F");
}

void drawInsets(ViewModel& model) {
  if (!ImGui::CollapsingHeader("Insets")) return;
  for (std::size_t i = 0; i < model.viewer.insets.size(); ++i) {
    InsetChoice& choice = model.viewer.insets[i];
    ImGui::PushID(static_cast<int>(i));
    ImGui::Checkbox("##shown", &choice.shown);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(px(-34));
    const std::string whole = choice.inset.camera, shown = shownInList(whole);
    if (ImGui::BeginCombo("##camera", shown.c_str())) {
      std::vector<std::string> names = model.cameraNames();
      names.insert(names.end(), {"fit", "map"});
      for (const std::string& name : names) {
        if (ImGui::Selectable(name.c_str(), name == choice.inset.camera)) {
          choice.inset.camera = name;
          choice.inset.title.reset();
        }
      }
      ImGui::EndCombo();
    }
    explainCut(shown, whole);
    ImGui::SameLine();
    const bool gone = ImGui::SmallButton("x");
    explain("take this window away");
    ImGui::PopID();
    if (gone) {
      model.viewer.insets.erase(model.viewer.insets.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
  if (ImGui::SmallButton("add a window")) {
    CellInset inset;
    inset.camera = "map";
    model.viewer.insets.push_back({inset, true});
  }
}

void drawLayers(ViewModel& model) {
  if (model.cell().layers.empty() ||
      !ImGui::CollapsingHeader("Layers", ImGuiTreeNodeFlags_DefaultOpen)) {
    return;
  }
  const auto shown = shownLayers(model.cell(), model.scene(), model.choice());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const CellLayer& layer = model.cell().layers[i];
    ImGui::PushID(layer.name.c_str());
    // What its box alone does not say.
    const bool has_word = shown[i] == ShownPart::some || shown[i] == ShownPart::nothing;
    const float word = has_word ? drawnWidth(nameOf(shown[i])) : 0;
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - word;
    const float room = ImGui::GetContentRegionAvail().x - word - ImGui::GetFrameHeight() - px(16);
    const std::string name = cutInMiddle(layer.name, room, drawnWidth);
    drawVisibility(model, "layer/" + encodeName(layer.name), shown[i],
                   model.layerVisibleByDefault(layer), (name + "###visible").c_str(),
                   name == layer.name ? std::string() : layer.name);
    if (has_word) {
      ImGui::SameLine();
      ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), right));
      ImGui::TextDisabled("%s", nameOf(shown[i]));
    }
    ImGui::PopID();
  }
}

/// A row of the list: a device, or a link of an open device.
struct DeviceRow {
  const PosedDevice* device = nullptr;
  std::optional<std::size_t> link;
  const std::string* name = nullptr;  ///< as there is room for it
};

bool isJointed(const PosedDevice& device) {
  return device.model != nullptr && device.model->links.size() > 1;
}

std::vector<DeviceRow> deviceRows(const ViewModel& model) {
  std::vector<DeviceRow> rows;
  for (const PosedDevice& device : model.scene().devices) {
    if (!containsWord(device.name, model.viewer.panels.device_filter.data())) continue;
    rows.push_back({&device, {}, &device.name});
    if (!isJointed(device) || !model.viewer.panels.open_devices.contains(device.name)) continue;
    for (std::size_t i = 0; i < device.model->links.size(); ++i) {
      if (!device.model->links[i].visuals.empty()) {
        rows.push_back({&device, i, &device.model->links[i].name});
      }
    }
  }
  return rows;
}

/// The names of links stand right of those of devices, by as much as a box is wider than an arrow.
float linkIndent() { return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.x; }

/// Gives the rows the names that a panel of that width has room for: those of devices together,
/// those of each device's links together.
void nameRows(ViewModel& model, std::vector<DeviceRow>& rows, float width) {
  const auto cut = [&](const std::string& list, std::vector<DeviceRow*>& some, float room) {
    std::vector<std::string> names;
    for (const DeviceRow* row : some) names.push_back(*row->name);
    const std::vector<std::string>& shown =
        model.viewer.panels.short_names.of(list, std::move(names), room, drawnWidth);
    for (std::size_t i = 0; i < some.size(); ++i) some[i]->name = &shown[i];
    some.clear();
  };
  const float beside_box = width - linkIndent();
  std::vector<DeviceRow*> devices, links;
  for (DeviceRow& row : rows) {
    if (!links.empty() && (!row.link || links.front()->device != row.device)) {
      cut("links of " + links.front()->device->name, links, beside_box - linkIndent());
    }
    (row.link ? links : devices).push_back(&row);
  }
  if (!links.empty()) {
    cut("links of " + links.front()->device->name, links, beside_box - linkIndent());
  }
  cut("devices", devices, beside_box - ImGui::GetTreeNodeToLabelSpacing());
}

void drawLinkRow(ViewModel& model, const PosedDevice& device, std::size_t number,
                 const std::string& name) {
  const Link& link = device.model->links[number];
  const Selection here{device.name, link.name};
  ImGui::Indent(linkIndent());
  drawVisibility(model, here.path(), shownLink(device, number, model.choice()),
                 device.link_visible[number], "##visible");
  ImGui::SameLine();
  const bool selected = model.selected == here;
  // A choice of the user's has its own button in front of the name.
  const std::string shown = cutInMiddle(name, ImGui::GetContentRegionAvail().x, drawnWidth);
  if (ImGui::Selectable((shown + "###link").c_str(), selected)) {
    model.selected = selected ? Selection{device.name, ""} : here;
  }
  explainCut(shown, link.name);
  ImGui::Unindent(linkIndent());
}

void drawDeviceRow(ViewModel& model, const PosedDevice& device, const std::string& name) {
  const Selection here{device.name, ""};
  drawVisibility(model, here.path(), shownDevice(device, model.choice()), device.visible,
                 "##visible");
  ImGui::SameLine();
  ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth |
                             ImGuiTreeNodeFlags_NoTreePushOnOpen;
  if (model.selected == here) flags |= ImGuiTreeNodeFlags_Selected;
  if (!isJointed(device)) flags |= ImGuiTreeNodeFlags_Leaf;
  ImGui::SetNextItemOpen(model.viewer.panels.open_devices.contains(device.name));
  const float room = ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing();
  const std::string shown = cutInMiddle(name, room, drawnWidth);
  const bool open = ImGui::TreeNodeEx("device", flags, "%s", shown.c_str());
  if (ImGui::IsItemToggledOpen()) {
    if (open) {
      model.viewer.panels.open_devices.insert(device.name);
    } else {
      model.viewer.panels.open_devices.erase(device.name);
    }
  } else if (ImGui::IsItemClicked()) {
    model.selected = model.selected == here ? Selection{} : here;
  }
  explainCut(shown, device.name);
}

/// The row of the selected device or link; a link without a row has that of its device.
std::optional<std::size_t> rowOf(const std::vector<DeviceRow>& rows, const Selection& selected) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const DeviceRow& row = rows[i];
    if (row.device->name != selected.device) continue;
    if (!row.link) {
      found = i;
    } else if (row.device->model->links[*row.link].name == selected.link) {
      return i;
    }
  }
  return found;
}

/// What was selected elsewhere, such as in the picture, is in the list: its device is open, and no
/// filter leaves it out. True when it was selected since the list was drawn.
bool showSelected(ViewModel& model) {
  PanelState& panels = model.viewer.panels;
  if (model.selected == panels.listed_selection) return false;
  panels.listed_selection = model.selected;
  if (model.selected.device.empty()) return false;
  if (!containsWord(model.selected.device, panels.device_filter.data())) {
    panels.device_filter[0] = 0;
  }
  if (!model.selected.link.empty()) panels.open_devices.insert(model.selected.device);
  return true;
}

void drawDevices(ViewModel& model, float bottom) {
  if (!ImGui::CollapsingHeader("Devices", ImGuiTreeNodeFlags_DefaultOpen)) return;
  if (model.scene().devices.size() > 12) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##find", "find a device", model.viewer.panels.device_filter.data(),
                             model.viewer.panels.device_filter.size());
  }
  const bool moves = showSelected(model);
  std::vector<DeviceRow> rows = deviceRows(model);
  const float pitch = ImGui::GetFrameHeightWithSpacing();
  const float room = bottom - ImGui::GetCursorScreenPos().y - ImGui::GetStyle().WindowPadding.y;
  const float height = listHeight(rows.size(), pitch, room);
  ImGui::BeginChild("devices", ImVec2(0, height));
  nameRows(model, rows, ImGui::GetContentRegionAvail().x);
  if (const auto row = rowOf(rows, model.selected); moves && row) {
    ImGui::SetScrollY(
        scrollToShow(ImGui::GetScrollY(), static_cast<float>(*row) * pitch, pitch, height));
  }
  // Only visible rows of thousands are made.
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), pitch);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const DeviceRow& row = rows[static_cast<std::size_t>(i)];
      ImGui::PushID(row.device->name.c_str());
      if (row.link) {
        ImGui::PushID(static_cast<int>(*row.link));
        drawLinkRow(model, *row.device, *row.link, *row.name);
        ImGui::PopID();
      } else {
        drawDeviceRow(model, *row.device, *row.name);
      }
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
}

/// The events whose text or source contains the filter; all with an empty filter.
std::vector<std::size_t> listedEvents(const ViewModel& model) {
  std::vector<std::size_t> listed;
  const std::string_view wanted = model.viewer.panels.event_filter.data();
  for (std::size_t i = 0; !wanted.empty() && i < model.events().size(); ++i) {
    const Event& event = model.events()[i];
    if (containsWord(event.text, wanted) || containsWord(event.source, wanted)) listed.push_back(i);
  }
  return listed;
}

void drawEventRow(const ViewModel& model, const Event& event, TimelineCursor& cursor,
                  SteadyTime now) {
  const std::string seconds = fmt::format("{:9.3f}", secondsOf(event.time - model.origin()));
  const std::string words = event.source + (event.source.empty() ? "" : ": ") + event.text;
  const bool by_day = showsClock(model);
  const std::string line = (by_day ? clockText(event.time) : seconds) + "  " + words;
  const bool here = event.time == cursor.position(now);
  if (ImGui::Selectable(line.c_str(), here)) cursor.seek(event.time, now);
  if (by_day) {
    explain((seconds + " s, " + calendarText(event.time) + "\n" + words).c_str());
  } else {
    explain(line.c_str());
  }
}

}  // namespace

void drawSceneTab(ViewModel& model, float bottom, ViewerRequests& requests) {
  drawCameraRow(model, requests);
  drawInsets(model);
  drawOthers(model);
  drawLayers(model);
  const Signals& of_none = model.received().signals();
  if (!of_none.empty() && ImGui::CollapsingHeader("Signals", ImGuiTreeNodeFlags_DefaultOpen)) {
    drawSignals(model, {}, {}, of_none);
  }
  drawDevices(model, bottom);
}

void drawEventsTab(ViewModel& model, SteadyTime now, ViewerRequests& requests) {
  TimelineCursor& cursor = *model.cursor();
  const std::vector<Event>& events = model.events();
  if (events.empty()) ImGui::TextDisabled("no event in this session");
  constexpr std::size_t kMaxEventRows = 14;
  if (events.size() > kMaxEventRows) {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##find event", "find an event",
                             model.viewer.panels.event_filter.data(),
                             model.viewer.panels.event_filter.size());
  }
  const bool all = model.viewer.panels.event_filter[0] == 0;
  const std::vector<std::size_t> listed = listedEvents(model);
  const float pitch = ImGui::GetTextLineHeightWithSpacing();
  const auto rows = static_cast<float>(std::clamp<std::size_t>(events.size(), 1, kMaxEventRows));
  ImGui::BeginChild("events", ImVec2(0, rows * pitch + 4));
  const bool follows =
      model.isGrowing() && followsNewest(ImGui::GetScrollY(), ImGui::GetScrollMaxY());
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(all ? events.size() : listed.size()), pitch);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto place = static_cast<std::size_t>(i);
      ImGui::PushID(i);
      drawEventRow(model, events[all ? place : listed[place]], cursor, now);
      ImGui::PopID();
    }
  }
  if (follows) ImGui::SetScrollHereY(1);
  ImGui::EndChild();
  auto& text = model.viewer.panels.mark.text;
  ImGui::SetNextItemWidth(px(-60));
  const bool entered = ImGui::InputTextWithHint("##mark", "a mark at this moment", text.data(),
                                                text.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  if ((ImGui::Button("Mark", ImVec2(-1, 0)) || entered) && text[0] != 0) {
    requests.mark = text.data();
    text[0] = 0;
  }
  explain("kept beside the log, in LOG.marks");
}

}  // namespace rocinante
