#include "viewer/ui/program/user_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

/// A press that moves less than this many pixels is a click, not a drag.
constexpr float kClickReach = 4;

std::optional<PictureClick> applyMouse(ViewModel& model, int width_px, int height_px) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse) return std::nullopt;
  // A press after a jump of the pointer is not a drag from its old place.
  ImVec2 moved = io.MouseDelta;
  for (const bool clicked : io.MouseClicked) {
    if (clicked) moved = ImVec2(0, 0);
  }
  const bool panning = ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                       ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                       (ImGui::IsMouseDown(ImGuiMouseButton_Left) && io.KeyShift);
  const auto dragged = [&](ImGuiMouseButton button) {
    return io.MouseDragMaxDistanceSqr[button] >= kClickReach * kClickReach;
  };
  if (moved.x != 0 || moved.y != 0) {
    if (panning) {
      model.holdCamera().pan(moved.x, moved.y, height_px);
    } else if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && dragged(ImGuiMouseButton_Left)) {
      model.holdCamera().orbit(moved.x, moved.y, height_px);
    }
  }
  if (io.MouseWheel != 0) {
    model.holdCamera().zoomAt(io.MouseWheel, io.MousePos.x - width_px / 2.0,
                              io.MousePos.y - height_px / 2.0, height_px);
  }
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    return PictureClick{io.MousePos.x, io.MousePos.y, true};
  }
  if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !dragged(ImGuiMouseButton_Left) &&
      !io.KeyShift && io.MouseClickedLastCount[ImGuiMouseButton_Left] == 1) {
    return PictureClick{io.MousePos.x, io.MousePos.y, false};
  }
  return std::nullopt;
}

void stepByPacket(ViewModel& model, TimelineCursor& cursor, bool after, SteadyTime now) {
  cursor.pause(now);
  const auto moment = model.packetBeside(after);
  if (!moment.ok()) {
    model.complaint = moment.error().text();
  } else if (*moment) {
    cursor.seek(**moment, now);
  }
}

void applyPlaybackKey(ViewModel& model, TimelineCursor& cursor, const KeyPress& press,
                      SteadyTime now) {
  const Nanoseconds step = press.shift ? Nanoseconds(100ms) : Nanoseconds(1s);
  const auto jump = [&](bool after) {
    if (const Event* event = model.eventBeside(cursor.position(now), after)) {
      cursor.seek(event->time, now);
    }
  };
  switch (press.key) {
    case GLFW_KEY_LEFT:
      return cursor.step(-step, now);
    case GLFW_KEY_RIGHT:
      return cursor.step(step, now);
    case GLFW_KEY_COMMA:
      return press.shift ? stepByPacket(model, cursor, false, now) : jump(false);
    case GLFW_KEY_PERIOD:
      return press.shift ? stepByPacket(model, cursor, true, now) : jump(true);
    case GLFW_KEY_SPACE:
      if (!press.repeated) cursor.toggle(now);
      return;
    case GLFW_KEY_HOME:
      return cursor.seek(cursor.start(), now);
    case GLFW_KEY_END:
      return cursor.seek(cursor.end(), now);
    default:
      return;
  }
}

/// Adds the path, or removes it if present.
template <class Entry, class PathOf>
void toggle(std::vector<Entry>& entries, Entry entry, const PathOf& path_of) {
  const auto found = std::ranges::find(entries, path_of(entry), path_of);
  if (found == entries.end()) {
    entries.push_back(std::move(entry));
  } else {
    entries.erase(found);
  }
}

void applyStyleKey(ViewModel& model, int key) {
  RenderStyle style = model.style();
  const std::string subject = model.selected.device.empty() ? "*" : model.selected.path();
  const auto itself = [](const std::string& path) -> const std::string& { return path; };
  if (key == GLFW_KEY_E)
    style.edges = static_cast<EdgeStyle>((static_cast<int>(style.edges) + 1) % 3);
  if (key == GLFW_KEY_D) style.shadows = !style.shadows;
  if (key == GLFW_KEY_L) style.limits = !style.limits;
  if (key == GLFW_KEY_W) toggle(style.wireframe, subject, itself);
  if (key == GLFW_KEY_C) toggle(style.collision, subject, itself);
  if (key == GLFW_KEY_T) {
    toggle(style.transparent, TransparentStyle{subject, 0.3},
           [](const TransparentStyle& one) -> const std::string& { return one.path; });
  }
  if (key == GLFW_KEY_R && !model.selected.device.empty()) {
    toggle(style.trails, TrailStyle{subject, 5s},
           [](const TrailStyle& one) -> const std::string& { return one.path; });
  }
  model.setStyle(style);
}

void toggleInsets(ViewModel& model) {
  const bool any = std::ranges::any_of(model.insets, &InsetChoice::shown);
  for (InsetChoice& inset : model.insets) inset.shown = !any;
}

void applyVisibilityKey(ViewModel& model, bool show_all) {
  if (show_all) {
    for (const std::string& path : model.hiddenPaths()) model.setVisible(path, std::nullopt);
  } else if (!model.selected.device.empty()) {
    model.setVisible(model.selected.path(), false);
  }
}

struct NamedKey {
  std::string_view name;
  int key;
};

constexpr std::array kNamedKeys{
    NamedKey{"space", GLFW_KEY_SPACE},   NamedKey{"left", GLFW_KEY_LEFT},
    NamedKey{"right", GLFW_KEY_RIGHT},   NamedKey{"home", GLFW_KEY_HOME},
    NamedKey{"end", GLFW_KEY_END},       NamedKey{"tab", GLFW_KEY_TAB},
    NamedKey{"escape", GLFW_KEY_ESCAPE}, NamedKey{"F1", GLFW_KEY_F1},
    NamedKey{",", GLFW_KEY_COMMA},       NamedKey{".", GLFW_KEY_PERIOD}};

}  // namespace

void applyKey(ViewModel& model, const KeyPress& press, SteadyTime now, ViewerRequests& requests) {
  if (TimelineCursor* cursor = model.cursor()) applyPlaybackKey(model, *cursor, press, now);
  if (press.repeated) return;
  switch (press.key) {
    case GLFW_KEY_F:
      (press.shift ? requests.fit_selected : requests.fit) = true;
      return;
    case GLFW_KEY_0:
      requests.reset = true;
      return;
    case GLFW_KEY_S:
      requests.evidence = true;
      return;
    case GLFW_KEY_M:
      if (model.cursor() != nullptr) requests.mark = "mark";
      return;
    case GLFW_KEY_Q:
      requests.close = true;
      return;
    case GLFW_KEY_TAB:
      model.panels_shown = !model.panels_shown;
      return;
    case GLFW_KEY_F1:
      model.help_shown = !model.help_shown;
      return;
    case GLFW_KEY_ESCAPE:
      if (!model.help_shown) model.selected = {};
      model.help_shown = false;
      return;
    case GLFW_KEY_H:
      return applyVisibilityKey(model, press.shift);
    case GLFW_KEY_I:
      return toggleInsets(model);
    default:
      break;
  }
  const std::vector<std::string> cameras = model.cameraNames();
  const int number = press.key - GLFW_KEY_1;
  if (number >= 0 && number < 9 && static_cast<std::size_t>(number) < cameras.size()) {
    model.useCamera(cameras[static_cast<std::size_t>(number)]);
  }
  applyStyleKey(model, press.key);
}

std::optional<KeyPress> parseKey(std::string_view text) {
  KeyPress press;
  if (text.starts_with("shift+")) {
    press.shift = true;
    text.remove_prefix(6);
  }
  const auto* named = std::ranges::find(kNamedKeys, text, &NamedKey::name);
  if (named != kNamedKeys.end()) {
    press.key = named->key;
    return press;
  }
  // GLFW's key codes of letters and digits are ASCII.
  const bool known = text.size() == 1 &&
                     ((text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= '0' && text[0] <= '9'));
  if (!known) return std::nullopt;
  press.key = text[0];
  return press;
}

std::optional<PictureClick> applyUserInput(ViewModel& model, SteadyTime now, int width_px,
                                           int height_px, ViewerRequests& requests,
                                           Window& window) {
  const auto click = applyMouse(model, width_px, height_px);
  const std::vector<KeyPress> presses = window.input().thisFrame().keys;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return click;
  bool list_open =
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  for (const KeyPress& press : presses) {
    if (list_open && press.key == GLFW_KEY_ESCAPE) {
      // It only closes the list.
      ImGui::ClosePopupToLevel(0, true);
      list_open = false;
      continue;
    }
    applyKey(model, press, now, requests);
  }
  // By its character, since its key depends on the layout.
  for (const ImWchar character : io.InputQueueCharacters) {
    if (character == '?') model.help_shown = !model.help_shown;
  }
  return click;
}

}  // namespace rocinante
