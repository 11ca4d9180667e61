#include "core/packet/session_state.h"

#include <algorithm>
#include <utility>

#include "core/packet/item_text.h"
#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

/// The identity's lines, not sorted yet.
class IdentityLines {
 public:
  void addSource(const std::string& name, const SourceState& source) {
    PacketHeader header;
    header.source = name;
    header.run = source.run;
    header.sequence = source.highest_sequence;
    header.time_ns = source.time_ns;
    // The header's text after its "RK1".
    lines_.push_back("source" + headerText(header).substr(3));
  }
  void addItem(std::string_view owner, const std::string& statement) {
    lines_.push_back("item " + encodeName(owner) + ' ' + statement);
  }
  void addDevice(const std::string& name, const DeviceState& device) {
    lines_.push_back("device" + seenText(name, device.last_write).substr(4));
    if (device.presence) {
      addItem(device.presence->owner, presenceText(name, device.presence->value));
    }
    if (device.pose) addItem(device.pose->owner, poseText(name, device.pose->value));
    if (device.joints) addItem(device.joints->owner, jointsText(name, device.joints->value));
    for (const auto& [joint, item] : device.named_joints) {
      addItem(item.owner, jointText(name, joint, item.value));
    }
    for (const auto& [source, joints] : device.orders) addItem(source, orderText(name, joints));
  }
  void addDrawing(const std::string& owner, const std::string& id, const Drawing& drawing) {
    for (std::size_t part = 0; part < drawing.parts.size(); ++part) {
      if (drawing.parts[part]) addItem(owner, drawingText(id, drawing, part));
    }
  }

  std::string text() {
    std::sort(lines_.begin(), lines_.end());
    std::string text;
    for (const std::string& line : lines_) text += line + '\n';
    return text;
  }

 private:
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<Event> SessionState::takeEvents() { return std::exchange(events_, {}); }

bool SessionState::restatementOpen(LogTime now) const {
  return std::any_of(open_.begin(), open_.end(), [&](const auto& open) {
    return now < open.second.began + limits::kRestatementSpan;
  });
}

bool SessionState::sameAs(const SessionState& other) const {
  return devices_ == other.devices_ && visibility_ == other.visibility_ &&
         colors_ == other.colors_ && drawings_ == other.drawings_ && views_ == other.views_ &&
         sources_ == other.sources_;
}

std::string SessionState::identityText() const {
  IdentityLines lines;
  for (const auto& [name, source] : sources_) lines.addSource(name, source);
  for (const auto& [name, device] : devices_) lines.addDevice(name, device);
  for (const auto& [path, item] : visibility_) {
    lines.addItem(item.owner, visibilityText(path, item.value));
  }
  for (const auto& [path, item] : colors_) {
    lines.addItem(item.owner, colorText(path, item.value));
  }
  for (const auto& [key, drawing] : drawings_) lines.addDrawing(key.first, key.second, drawing);
  for (const auto& [name, item] : views_) lines.addItem(item.owner, viewText(name, item.value));
  return lines.text();
}

}  // namespace rocinante
