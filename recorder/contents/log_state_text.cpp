#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/packet/item_text.h"
#include "core/packet/packet_text.h"
#include "recorder/contents/log_state.h"

namespace rocinante {
namespace {

/// The listing, line by line. Each item is shown as the statement that would restate it.
class StateLines {
 public:
  explicit StateLines(const ShownState& shown) : shown_(shown) {}

  std::string text() {
    const SessionState& state = *shown_.state;
    heading("sources", state.sources().size());
    for (const auto& [name, source] : state.sources()) addSource(name, source);
    heading("devices", state.devices().size());
    for (const auto& [name, device] : state.devices()) addDevice(name, device);
    heading("visibility", state.visibility().size());
    for (const auto& [path, item] : state.visibility()) {
      addItem(item.owner, visibilityText(path, item.value));
    }
    heading("colors", state.colors().size());
    for (const auto& [path, item] : state.colors()) {
      addItem(item.owner, colorText(path, item.value));
    }
    heading("drawings", state.drawings().size());
    for (const auto& [key, drawing] : state.drawings()) {
      for (std::size_t part = 0; part < drawing.parts.size(); ++part) {
        if (drawing.parts[part]) addItem(key.first, drawingText(key.second, drawing, part));
      }
    }
    heading("views", state.views().size());
    for (const auto& [name, item] : state.views()) addItem(item.owner, viewText(name, item.value));
    return std::move(text_);
  }

 private:
  void heading(const char* name, std::size_t count) {
    if (count > 0) text_ += fmt::format("{} ({})\n", name, count);
  }

  void addSource(const std::string& name, const SourceState& source) {
    PacketHeader header;
    header.source = name;
    header.run = source.run;
    header.sequence = source.highest_sequence;
    header.time_ns = source.time_ns;
    // The header's text after its "RK1": SOURCE[@RUN] SEQUENCE TIME.
    text_ += fmt::format(" {}\n", headerText(header).substr(3));
  }

  void addDevice(const std::string& name, const DeviceState& device) {
    const Nanoseconds written = device.last_write - shown_.origin;
    text_ += fmt::format("  {}, last written at {} s\n", encodeName(name), secondsText(written, 3));
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

  void addItem(const std::string& owner, const std::string& statement) {
    text_ += fmt::format("    {}  ({})\n", plainText(statement), encodeName(owner));
  }

  const ShownState& shown_;
  std::string text_;
};

}  // namespace

std::string stateText(const ShownState& shown) {
  return fmt::format("{} at {} s\n", plainText(shown.log),
                     secondsText(shown.moment - shown.origin, 3)) +
         StateLines(shown).text();
}

}  // namespace rocinante
