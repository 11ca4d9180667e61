#include "viewer/ui/program/user_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "viewer/ui/commands/key_commands.h"
#include "viewer/ui/model/view_insets.h"
#include "viewer/ui/program/fly_input.h"
#include "viewer/ui/program/gizmo_input.h"
#include "viewer/ui/window/interface_context.h"

namespace rocinante {
namespace {

/// A press that moves less than this many pixels is a click, not a drag.
constexpr float kClickReach = 4;

/// Where the mouse is in the picture, perhaps beside it.
PicturePlace inPicture(const ViewModel& model) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  const PixelRectangle& part = model.viewer.picture_part;
  return {at.x - static_cast<float>(part.x), at.y - static_cast<float>(part.y)};
}

/// Beside the picture is bare ground, where no panel stands.
bool isOnPicture(const ViewModel& model, const ImVec2& at) {
  const PixelRectangle& part = model.viewer.picture_part;
  const ImVec2 from(static_cast<float>(part.x), static_cast<float>(part.y));
  return at.x >= from.x && at.y >= from.y && at.x < from.x + static_cast<float>(part.width) &&
         at.y < from.y + static_cast<float>(part.height);
}

/// What is held was pressed beside the picture; or nothing is held, and the mouse is beside it.
/// What began on the picture goes on.
bool isBeside(const ViewModel& model) {
  const GizmoState& gizmo = model.viewer.gizmo;
  if (model.viewer.fly.active() || (gizmo.shown && gizmo.drag)) return false;
  const ImGuiIO& io = ImGui::GetIO();
  bool any_held = false;
  for (int button = 0; button < ImGuiMouseButton_COUNT; ++button) {
    if (!io.MouseDown[button] && !io.MouseReleased[button]) continue;
    any_held = true;
    if (isOnPicture(model, io.MouseClickedPos[button])) return false;
  }
  return any_held || !isOnPicture(model, io.MousePos);
}

std::optional<PictureClick> applyMouse(ViewModel& model) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse) return std::nullopt;
  const auto [x, y] = inPicture(model);
  const int width_px = model.viewer.picture_part.width;
  const int height_px = model.viewer.picture_part.height;
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
  const double scale = ImGui::GetFontSize() / kFontPixels;
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.KeyShift) {
    model.viewer.inset_drag = grabInset(model, x, y, kInsetGripPx * scale);
  }
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) model.viewer.inset_drag.reset();
  if (model.viewer.inset_drag && dragged(ImGuiMouseButton_Left)) {
    dragInset(model, *model.viewer.inset_drag, x, y, width_px, height_px, scale);
    return std::nullopt;
  }
  if (moved.x != 0 || moved.y != 0) {
    if (panning) {
      model.holdCamera().pan(moved.x, moved.y, height_px);
    } else if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && dragged(ImGuiMouseButton_Left)) {
      model.holdCamera().orbit(moved.x, moved.y, height_px);
    }
  }
  if (io.MouseWheel != 0) {
    model.holdCamera().zoomAt(io.MouseWheel, x - width_px / 2.0, y - height_px / 2.0, height_px);
  }
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    if (const auto inset = grabInset(model, x, y, 0)) {
      // It was there a moment ago.
      static_cast<void>(swapInset(model, inset->number));
      return std::nullopt;
    }
    return PictureClick{x, y, true};
  }
  if (ImGui::IsMouseReleased(ImGuiMouseButton_Left) && !dragged(ImGuiMouseButton_Left) &&
      !io.KeyShift && io.MouseClickedLastCount[ImGuiMouseButton_Left] == 1) {
    return PictureClick{x, y, false};
  }
  return std::nullopt;
}

/// The line that has the keyboard, or gets it in a moment, by what is open; null: none.
const LineStart* shownLine(const PanelState& panels) {
  if (panels.palette.shown) return &panels.palette.start;
  return panels.open.shown ? &panels.open.start : nullptr;
}

/// What a script types before the palette or the list of files has the keyboard is not lost.
void collectTyped(ViewModel& model, std::span<const KeyPress> presses, bool without_first) {
  LineStart& start = model.viewer.panels.palette.shown ? model.viewer.panels.palette.start
                                                       : model.viewer.panels.open.start;
  for (const ImWchar letter : ImGui::GetIO().InputQueueCharacters) {
    if (!std::exchange(without_first, false)) start.type(letter);
  }
  for (const KeyPress& press : presses) {
    if (press.key == GLFW_KEY_ENTER || press.key == GLFW_KEY_KP_ENTER) start.enter = true;
  }
}

/// Whether the first letter of the frame is that of the key: both come with one press.
bool typesFirstLetter(const KeyPress& press) {
  const auto& letters = ImGui::GetIO().InputQueueCharacters;
  if (press.control || letters.empty() || letters.front() > 0x7F) return false;
  return std::toupper(static_cast<int>(letters.front())) == press.key;
}

/// A key that opens a line of its own, whatever line has the keyboard.
bool opensLine(const KeyPress& press) {
  return press.control && (press.key == GLFW_KEY_P || press.key == GLFW_KEY_O);
}

}  // namespace

KeyTaker keyTaker(const ViewModel& model) {
  const PanelState& panels = model.viewer.panels;
  const LineStart* const line = shownLine(panels);
  const auto& value = model.hand.edit;
  const bool awaits = (line != nullptr && line->collects) || panels.mark.awaitsKeyboard() ||
                      panels.time.awaitsKeyboard() || (value && !value->begun);
  if (awaits) return KeyTaker::nobody;
  // As the last frame left it: WantTextInput is that of the frame before, and a line that it closed
  // would take what comes now all at once.
  const bool has_line = line != nullptr || ImGui::GetCurrentContext()->WantTextInputNextFrame == 1;
  return has_line ? KeyTaker::line : KeyTaker::commands;
}

std::optional<PicturePlace> mouseOnPicture(const ViewModel& model) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse || !ImGui::IsMousePosValid()) return std::nullopt;
  if (ImGui::IsAnyMouseDown() || !isOnPicture(model, io.MousePos)) return std::nullopt;
  return inPicture(model);
}

std::optional<PictureClick> applyUserInput(ViewModel& model, SteadyTime now,
                                           std::span<const KeyPress> presses,
                                           ViewerRequests& requests) {
  const bool beside = isBeside(model);
  const bool flies = !beside && applyFlying(model, now, model.viewer.picture_part.height, requests);
  const bool is_taken = beside || flies || applyGizmo(model);
  const auto click = is_taken ? std::nullopt : applyMouse(model);
  const ImGuiIO& io = ImGui::GetIO();
  // Whatever has the keyboard, Esc ends driving.
  const bool ended =
      model.hand.driving() != nullptr && std::ranges::any_of(presses, [](const KeyPress& press) {
        return press.key == GLFW_KEY_ESCAPE;
      });
  if (ended) model.hand.stopDriving();
  const bool is_line_shown = shownLine(model.viewer.panels) != nullptr;
  if (io.WantTextInput && (is_line_shown || std::ranges::none_of(presses, opensLine))) return click;
  if (is_line_shown) {
    // It gets the keyboard in a moment, and closes itself.
    collectTyped(model, presses, false);
    return click;
  }
  const CommandStage stage{model, now, model.viewer.picture_part.height, requests};
  const auto tell = [&](const Status& done) {
    if (!done) requests.fault = done.error().text();
  };
  bool list_open =
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  for (std::size_t i = 0; i < presses.size(); ++i) {
    const KeyPress& press = presses[i];
    if (list_open && press.key == GLFW_KEY_ESCAPE) {
      // It only closes the list.
      ImGui::ClosePopupToLevel(0, true);
      list_open = false;
      continue;
    }
    if (ended && press.key == GLFW_KEY_ESCAPE) continue;
    if (flies && isFlyKey(press)) continue;
    if (io.WantTextInput && !opensLine(press)) continue;
    tell(runKey(press, stage));
    if (shownLine(model.viewer.panels) == nullptr) continue;
    // What follows is typed into it.
    collectTyped(model, presses.subspan(i + 1), typesFirstLetter(press));
    return click;
  }
  if (io.WantTextInput) return click;
  // By its character, since its key depends on the layout.
  for (const ImWchar character : io.InputQueueCharacters) {
    if (character == '?') tell(runCommand("help", {}, stage));
  }
  return click;
}

}  // namespace rocinante
