#include "core/packet/restatement.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/packet/item_text.h"
#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

/// The order of statements across the sources of one device: `remove` removes all items of the
/// device, positional joints clear the named ones, and every write updates the last write.
enum Stage : std::size_t { removals, positions, items, last_writes, stage_count };

/// The items of one source, as statements by stage.
class OwnedText {
 public:
  const std::vector<std::string>& of(std::size_t stage) const { return lines_[stage]; }

  void add(Stage stage, std::string line) { lines_[stage].push_back(std::move(line)); }
  void addOf(const std::string& device, Stage stage, std::string line) {
    if (devices_.empty() || *devices_.back() != device) devices_.push_back(&device);
    add(stage, std::move(line));
  }

  void addSeen(const SessionState& state) {
    const auto is_before = [](const auto* a, const auto* b) { return *a < *b; };
    const auto is_same = [](const auto* a, const auto* b) { return *a == *b; };
    std::sort(devices_.begin(), devices_.end(), is_before);
    devices_.erase(std::unique(devices_.begin(), devices_.end(), is_same), devices_.end());
    for (const std::string* name : devices_) {
      add(Stage::last_writes, seenText(*name, state.devices().find(*name)->second.last_write));
    }
  }

 private:
  std::array<std::vector<std::string>, stage_count> lines_;
  std::vector<const std::string*> devices_;  ///< with items of the source; names in the state
};

/// The items of each source, found in one walk over the state: of one source, or of all.
class OwnedTexts {
 public:
  OwnedTexts(const SessionState& state, const RestatementOptions& options,
             std::optional<std::string_view> only)
      : options_(options), only_(only) {
    for (const auto& [name, device] : state.devices()) addDevice(name, device);
    for (const auto& [path, item] : state.visibility()) {
      if (wants(item.owner)) addOfPath(item.owner, path, visibilityText(path, item.value));
    }
    for (const auto& [path, item] : state.colors()) {
      if (wants(item.owner)) addOfPath(item.owner, path, colorText(path, item.value));
    }
    for (const auto& [key, drawing] : state.drawings()) {
      if (wants(key.first)) addDrawing(key.first, key.second, drawing);
    }
    for (const auto& [name, item] : state.views()) {
      if (wants(item.owner)) owned_[item.owner].add(Stage::items, viewText(name, item.value));
    }
    if (!options.with_seen) return;
    for (auto& owned : owned_) owned.second.addSeen(state);
  }

  const OwnedText& of(std::string_view source) const {
    static const OwnedText nothing;
    const auto found = owned_.find(source);
    return found == owned_.end() ? nothing : found->second;
  }

 private:
  bool wants(std::string_view owner) const { return !only_ || *only_ == owner; }
  template <class T>
  bool wants(const std::optional<Item<T>>& item) const {
    return item && wants(item->owner);
  }

  void addOfPath(const std::string& owner, const Path& path, std::string line) {
    if (path.is_layer) return owned_[owner].add(Stage::items, std::move(line));
    owned_[owner].addOf(path.first, Stage::items, std::move(line));
  }

  void addDevice(const std::string& name, const DeviceState& device) {
    if (wants(device.presence)) {
      const PresenceValue& presence = device.presence->value;
      const bool is_removed = presence.presence == Presence::removed;
      owned_[device.presence->owner].addOf(name, is_removed ? Stage::removals : Stage::items,
                                           presenceText(name, presence));
    }
    if (wants(device.joints)) {
      OwnedText& owned = owned_[device.joints->owner];
      // An order known to the receiver would turn these into named joints.
      owned.addOf(name, Stage::positions, orderText(name, {}));
      owned.addOf(name, Stage::positions, jointsText(name, device.joints->value));
    }
    for (const auto& [source, names] : device.orders) {
      if (wants(source)) owned_[source].addOf(name, Stage::items, orderText(name, names));
    }
    if (wants(device.pose)) {
      owned_[device.pose->owner].addOf(name, Stage::items, poseText(name, device.pose->value));
    }
    if (!device.named_joints.empty()) addNamedJoints(name, device);
  }

  /// Several joints per line, as long as the line leaves room for a header in a datagram.
  void addNamedJoints(const std::string& name, const DeviceState& device) {
    struct Line {
      std::string text;
      std::size_t count = 0;
    };
    std::map<std::string_view, Line> lines;  // by owner, the one that is not full
    const std::size_t most_bytes = options_.mtu_bytes / 2;
    for (const auto& [joint, item] : device.named_joints) {
      if (!wants(item.owner)) continue;
      Line& line = lines[item.owner];
      std::string alone = jointText(name, joint, item.value);
      const std::string pair = alone.substr(alone.rfind(' '));
      const bool is_full =
          line.text.size() + pair.size() > most_bytes || line.count == limits::kJointValues;
      if (line.count == 0 || is_full) {
        if (line.count > 0) owned_[item.owner].addOf(name, Stage::items, std::move(line.text));
        line = {std::move(alone), 1};
      } else {
        line.text += pair;
        ++line.count;
      }
    }
    for (auto& [owner, line] : lines) {
      owned_[std::string(owner)].addOf(name, Stage::items, std::move(line.text));
    }
  }

  void addDrawing(const std::string& owner, const std::string& id, const Drawing& drawing) {
    OwnedText& owned = owned_[owner];
    for (std::size_t part = 0; part < drawing.parts.size(); ++part) {
      if (drawing.parts[part]) owned.add(Stage::items, drawingText(id, drawing, part));
    }
  }

  const RestatementOptions& options_;
  const std::optional<std::string_view> only_;
  std::map<std::string, OwnedText, std::less<>> owned_;  ///< by SOURCE
};

/// One datagram of a restatement, before its header.
struct Body {
  std::size_t stage = 0;
  std::string text;
};

/// Fills datagrams of at most `most_bytes`; a stage begins a new one if `by_stage`.
std::vector<Body> bodiesOf(const OwnedText& owned, std::size_t most_bytes, bool by_stage) {
  std::vector<Body> bodies;
  for (std::size_t stage = 0; stage < stage_count; ++stage) {
    for (const std::string& line : owned.of(stage)) {
      const bool is_new = bodies.empty() || (by_stage && bodies.back().stage != stage) ||
                          bodies.back().text.size() + line.size() + 1 > most_bytes;
      if (is_new) bodies.push_back({stage, {}});
      bodies.back().text += line;
      bodies.back().text += '\n';
    }
  }
  if (bodies.empty()) bodies.emplace_back();
  return bodies;
}

PacketHeader headerOf(const SessionState& state, std::string_view source,
                      const RestatementOptions& options) {
  PacketHeader header;
  header.source = source;
  const auto known = state.sources().find(source);
  if (known != state.sources().end()) {
    header.run = known->second.run;
    header.sequence = known->second.highest_sequence;
    header.time_ns = known->second.time_ns;
  }
  if (options.first_sequence) header.sequence = options.first_sequence;
  if (options.time_ns) header.time_ns = options.time_ns;
  header.restated = true;
  header.reset = options.reset;
  header.by = options.by;
  return header;
}

/// The parts of one source's restatement, each with its stage.
std::vector<Body> partsOf(const SessionState& state, std::string_view source,
                          const OwnedText& owned, const RestatementOptions& options,
                          bool by_stage) {
  PacketHeader header = headerOf(state, source, options);
  // The longest possible header.
  header.part = {options.part_id, limits::kRestatementParts, limits::kRestatementParts};
  const std::size_t header_bytes = headerText(header).size() + 1;
  std::size_t most_bytes = options.mtu_bytes > header_bytes ? options.mtu_bytes - header_bytes : 1;

  std::vector<Body> parts = bodiesOf(owned, most_bytes, by_stage);
  while (parts.size() > limits::kRestatementParts) {
    most_bytes *= 2;
    parts = bodiesOf(owned, most_bytes, by_stage);
  }
  header.part->count = static_cast<std::uint32_t>(parts.size());
  std::uint32_t index = 0;
  for (Body& part : parts) {
    header.part->index = ++index;
    part.text.insert(0, headerText(header) + '\n');
    if (options.first_sequence) ++*header.sequence;
  }
  return parts;
}

/// Calls `meet` with the owner of each item of the device.
template <class Meet>
void forEachOwner(const SessionState& state, const std::string& name, const DeviceState& device,
                  Meet meet) {
  const auto meetPaths = [&](const auto& paths) {
    auto item = paths.lower_bound(Path{false, name, {}});
    for (; item != paths.end() && !item->first.is_layer && item->first.first == name; ++item) {
      meet(item->second.owner);
    }
  };
  if (device.presence) meet(device.presence->owner);
  if (device.pose) meet(device.pose->owner);
  if (device.joints) meet(device.joints->owner);
  for (const auto& joint : device.named_joints) meet(joint.second.owner);
  for (const auto& order : device.orders) meet(order.first);
  meetPaths(state.visibility());
  meetPaths(state.colors());
}

/// True when the device's items belong to more than one source.
bool isShared(const SessionState& state, const std::string& name, const DeviceState& device) {
  const std::string* owner = nullptr;
  bool is_shared = false;
  forEachOwner(state, name, device, [&](const std::string& other) {
    is_shared = is_shared || (owner != nullptr && *owner != other);
    owner = &other;
  });
  return is_shared;
}

bool hasSharedDevice(const SessionState& state) {
  return std::any_of(state.devices().begin(), state.devices().end(), [&](const auto& device) {
    return isShared(state, device.first, device.second);
  });
}

}  // namespace

std::vector<std::string> restate(const SessionState& state, std::string_view source,
                                 const RestatementOptions& options) {
  std::vector<std::string> datagrams;
  const OwnedTexts owned(state, options, source);
  for (Body& part : partsOf(state, source, owned.of(source), options, false)) {
    datagrams.push_back(std::move(part.text));
  }
  return datagrams;
}

std::vector<std::string> restateAll(const SessionState& state, const RestatementOptions& options) {
  const bool by_stage = hasSharedDevice(state);
  const OwnedTexts owned(state, options, std::nullopt);
  std::vector<Body> parts;
  for (const auto& source : state.sources()) {
    for (Body& part : partsOf(state, source.first, owned.of(source.first), options, by_stage)) {
      parts.push_back(std::move(part));
    }
  }
  if (by_stage) {
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Body& a, const Body& b) { return a.stage < b.stage; });
  }
  std::vector<std::string> datagrams;
  for (Body& part : parts) datagrams.push_back(std::move(part.text));
  return datagrams;
}

std::set<std::string, std::less<>> sourcesSharingDevices(const SessionState& state,
                                                         std::string_view source) {
  std::set<std::string, std::less<>> sharing{std::string(source)};
  for (std::size_t before = 0; before != sharing.size();) {
    before = sharing.size();
    for (const auto& [name, device] : state.devices()) {
      bool is_ours = false;
      forEachOwner(state, name, device,
                   [&](const std::string& owner) { is_ours = is_ours || sharing.contains(owner); });
      if (!is_ours) continue;
      forEachOwner(state, name, device, [&](const std::string& owner) { sharing.insert(owner); });
    }
  }
  return sharing;
}

}  // namespace rocinante
