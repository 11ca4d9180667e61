#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "viewer/shown/value_text.h"
#include "viewer/ui/panels/panel_parts.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/panels/plot_parts.h"

namespace rocinante {
namespace {

/// Messages of the log looked at for each frame of the window.
constexpr std::size_t kMessagesAFrame = 5000;

std::string spaceName(const Selection& selection) {
  if (selection.device.empty()) return "the world";
  return selection.link.empty() ? selection.device : selection.device + "/" + selection.link;
}

/// Rows of eight bytes with their place and what is printable of them.
std::string bytesText(std::string_view bytes) {
  constexpr std::size_t kRow = 8;
  std::string text;
  for (std::size_t row = 0; row < bytes.size(); row += kRow) {
    text += fmt::format("{:4d} ", row);
    const std::string_view part = bytes.substr(row, kRow);
    for (std::size_t i = 0; i < kRow; ++i) {
      text += i < part.size() ? fmt::format(" {:02x}", static_cast<unsigned char>(part[i])) : "   ";
    }
    text += "  ";
    for (const char byte : part) text += byte >= ' ' && byte <= '~' ? byte : '.';
    text += '\n';
  }
  return text;
}

void drawFound(const ViewModel& model, const PacketBehind& packet, bool& shows_bytes,
               float bottom) {
  std::string head = plainText(packet.source);
  if (packet.sequence) head += fmt::format(" {}", *packet.sequence);
  head += fmt::format(" at {} s", secondsText(packet.time - model.origin(), 6));
  ImGui::TextWrapped("%s", linesOf(head).c_str());
  std::string tip = packet.topic;
  if (packet.source_time) {
    const LogTime sent_at{Nanoseconds(*packet.source_time)};
    tip += fmt::format("\nTIME is {} s before it came", secondsText(packet.time - sent_at, 6));
  }
  explain(plainText(tip).c_str());
  const Nanoseconds age = model.shownTime() - packet.time;
  ImGui::TextDisabled("%s s before what is shown%s%s", secondsText(age, 6).c_str(),
                      packet.restated ? ", restated" : "",
                      packet.by.empty() ? "" : (" by " + plainText(packet.by)).c_str());
  ImGui::TextDisabled("%s", (countText(packet.text.size(), "byte") +
                             (packet.sender.empty() ? "" : " from " + plainText(packet.sender)))
                                .c_str());
  const std::string shown = shows_bytes ? bytesText(packet.text) : packet.text;
  const float line = ImGui::GetTextLineHeight();
  const auto lines =
      static_cast<float>(std::clamp<std::ptrdiff_t>(std::ranges::count(shown, '\n') + 1, 2, 8));
  const float room = bottom - ImGui::GetCursorScreenPos().y - 6 * line;
  ImGui::BeginChild(
      "packet", ImVec2(0, std::clamp(lines * line + px(14), 2 * line, std::max(room, 2 * line))),
      true, ImGuiWindowFlags_HorizontalScrollbar);
  // A stranger's bytes: line by line, each printable.
  std::string_view text = shown;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    ImGui::TextUnformatted(plainText(text.substr(0, end)).c_str());
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  ImGui::EndChild();
  if (ImGui::SmallButton("copy packet")) ImGui::SetClipboardText(packet.text.c_str());
  ImGui::SameLine();
  if (ImGui::SmallButton(shows_bytes ? "text" : "bytes")) shows_bytes = !shows_bytes;
}

void drawPosition(ViewModel& model, const Selection& shown, const Vec3& at) {
  const LengthUnit unit = model.hand.units.length;
  const std::string text = positionText(at, unit);
  if (!poseKeyOf(model, shown, "x")) {
    ImGui::TextUnformatted(text.c_str());
    return;
  }
  // The number that was pressed is dragged.
  const std::size_t x_ends = text.find(' ', 3), y_ends = text.find(' ', x_ends + 1);
  const float pressed = ImGui::GetIO().MouseClickedPos[0].x - ImGui::GetCursorScreenPos().x;
  const float gap = ImGui::CalcTextSize(" ").x / 2;
  const char* part = "z";
  if (pressed < ImGui::CalcTextSize(text.c_str(), text.c_str() + x_ends).x + gap) {
    part = "x";
  } else if (pressed < ImGui::CalcTextSize(text.c_str(), text.c_str() + y_ends).x + gap) {
    part = "y";
  }
  drawDraggable(model, "position", text, ImGuiCol_Text, {*poseKeyOf(model, shown, part)});
}

}  // namespace

void drawPose(ViewModel& model, const Selection& shown) {
  const Units& units = model.hand.units;
  const auto pose = poseIn(model.scene(), shown, model.viewer.reference);
  if (pose) {
    const Vec3& at = pose->position;
    drawPosition(model, shown, at);
    const Quat& q = pose->orientation;
    explain(fmt::format("where its space begins, in {}\nquaternion x y z w {:.6f} {:.6f} {:.6f} "
                        "{:.6f}",
                        spaceName(model.viewer.reference), q.x, q.y, q.z, q.w)
                .c_str());
    const Vec3 turn = rpyOf(pose->orientation);
    ImGui::Text("turned %s %s %s", angleNumber(turn.x, units.angle).c_str(),
                angleNumber(turn.y, units.angle).c_str(), angleText(turn.z, units.angle).c_str());
    explain("roll, pitch, yaw about fixed axes, as URDF has them");
  }
  const bool is_set = !model.viewer.reference.device.empty();
  const bool can_be = model.viewer.reference != shown && (pose || !is_set);
  drawCut("in " + spaceName(model.viewer.reference), PanelColor::dim_text);
  if (!is_set) ImGui::SameLine();  // the world's name leaves room
  if (can_be) {
    if (ImGui::SmallButton("set as reference")) model.viewer.reference = shown;
    explain("show the poses of others, and distances, from this one");
    if (is_set) ImGui::SameLine();
  }
  if (!is_set) return;
  if (ImGui::SmallButton("the world")) model.viewer.reference = {};
  explain("show poses in the world again");
}

void drawNearest(ViewModel& model, const Selection& shown) {
  if (model.selected.device != shown.device) return;
  if (ImGui::SmallButton(model.viewer.nearest_wanted ? "hide distance" : "nearest")) {
    model.viewer.nearest_wanted = !model.viewer.nearest_wanted;
  }
  explain(
      "how near this device or link is to the reference, or to the nearest other device\n"
      "X, then a click on each of two links: the distance of the two points");
  if (!model.viewer.nearest_wanted) return;
  ImGui::SameLine();
  const NearestFound* const found = model.nearest();
  if (found == nullptr) {
    ImGui::TextDisabled("measuring ...");
  } else if (found->other.empty()) {
    ImGui::TextDisabled("nothing to measure");
  } else {
    ImGui::TextWrapped("%s", linesOf(nearestText(*found)).c_str());
  }
}

void drawPacketBehind(ViewModel& model, const PosedDevice& device, const Selection& shown,
                      float bottom) {
  if (model.session() == nullptr) return;
  PacketLookup& packet = model.viewer.packet;
  if (!packet.wanted) {
    packet.value_name.clear();
    return;
  }
  const TimelineCursor* const cursor = model.cursor();
  if (cursor != nullptr && cursor->playing()) {
    ImGui::TextDisabled("pause to see it");
    return;
  }
  // That of another device, or of a link with a joint of its own.
  if (!packet.value_name.empty() && !device.model->findJointValue(packet.value_name)) {
    packet.value_name.clear();
  }
  if (!packet.value_name.empty()) {
    drawCut("behind " + packet.value_name, PanelColor::dim_text,
            ImGui::GetContentRegionAvail().x - px(30));
    ImGui::SameLine();
    if (ImGui::SmallButton("x##value")) packet.value_name.clear();
  }
  packet.look(model.session()->log().name(), {shown.device, packet.value_name}, model.shownTime(),
              kMessagesAFrame);
  if (!packet.trouble.empty()) {
    ImGui::TextWrapped("%s", linesOf(packet.trouble).c_str());
  } else if (packet.searching()) {
    ImGui::TextDisabled("looking for it ...");
  } else if (!packet.search->found()) {
    ImGui::TextDisabled("no packet up to here states it");
  } else {
    drawFound(model, *packet.search->found(), packet.shows_bytes, bottom);
  }
}

}  // namespace rocinante
