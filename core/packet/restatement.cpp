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

  /// `device`: a name in the state; null for what is of no device.
  void add(Stage stage, const std::string* device, std::string line) {
    if (device != nullptr && (devices_.empty() || *devices_.back() != *device)) {
      devices_.push_back(device);
    }
    lines_[stage].push_back(std::move(line));
  }

  void addSeen(const SessionState& state) {
    const auto is_before = [](const auto* a, const auto* b) { return *a < *b; };
    const auto is_same = [](const auto* a, const auto* b) { return *a == *b; };
    std::sort(devices_.begin(), devices_.end(), is_before);
    devices_.erase(std::unique(devices_.begin(), devices_.end(), is_same), devices_.end());
    for (const std::string* name : devices_) {
      const LogTime last_write = state.devices().find(*name)->second.last_write;
      lines_[Stage::last_writes].push_back(seenText(*name, last_write));
    }
  }

 private:
  std::array<std::vector<std::string>, stage_count> lines_;
  std::vector<const std::string*> devices_;  ///< with items of the source; names in the state
};

/// The named joints of one device: several per line, as long as the line leaves room for a header
/// in a datagram.
class NamedJointLines {
 public:
  explicit NamedJointLines(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  void add(const JointItem& item) {
    Line& line = open_[item.owner()];
    std::string alone = statementText(item);
    const std::string pair = alone.substr(alone.rfind(' '));
    const bool is_full =
        line.text.size() + pair.size() > most_bytes_ || line.count == limits::kJointValues;
    if (line.count == 0 || is_full) {
      if (line.count > 0) full_.emplace_back(&item.owner(), std::move(line.text));
      line = {std::move(alone), 1};
    } else {
      line.text += pair;
      ++line.count;
    }
  }

  /// Gives the lines to `give`, those of one owner in the order of their joints; none are left.
  template <class Give>
  void take(Give give) {
    if (open_.empty()) return;
    for (auto& [owner, line] : full_) give(*owner, std::move(line));
    for (auto& [owner, line] : open_) give(std::string(owner), std::move(line.text));
    full_.clear();
    open_.clear();
  }

 private:
  struct Line {
    std::string text;
    std::size_t count = 0;
  };
  const std::size_t most_bytes_;
  std::vector<std::pair<const std::string*, std::string>> full_;  ///< with their owners
  std::map<std::string_view, Line> open_;                         ///< by owner
};

/// The items of each source, found in one walk over the state: of one source, or of all.
class OwnedTexts {
 public:
  OwnedTexts(const SessionState& state, const RestatementOptions& options,
             std::optional<std::string_view> only)
      : only_(only), joints_(options.mtu_bytes / 2) {
    eachMap(state, [&](std::string_view, const auto& map) {
      for (const auto& [key, value] : map) {
        eachItemOf(key, value, [&](const auto& item) {
          if (includes(item.owner())) add(item);
        });
        addNamedJoints(key);
      }
    });
    if (!options.with_seen) return;
    for (auto& owned : owned_) owned.second.addSeen(state);
  }

  const OwnedText& of(std::string_view source) const {
    static const OwnedText nothing;
    const auto found = owned_.find(source);
    return found == owned_.end() ? nothing : found->second;
  }

 private:
  bool includes(std::string_view owner) const { return !only_ || *only_ == owner; }

  template <class Stated>
  void addTo(Stage stage, const Stated& item) {
    owned_[item.owner()].add(stage, item.ofDevice(), statementText(item));
  }
  void add(const PresenceItem& item) {
    const bool is_removed = item.item.value.presence == Presence::removed;
    addTo(is_removed ? Stage::removals : Stage::items, item);
  }
  void add(const PositionsItem& item) {
    // An order known to the receiver would turn these into named joints.
    owned_[item.owner()].add(Stage::positions, &item.device, orderText(item.device, {}));
    addTo(Stage::positions, item);
  }
  void add(const OrderItem& item) { addTo(Stage::items, item); }
  void add(const JointItem& item) { joints_.add(item); }
  void add(const PoseItem& item) { addTo(Stage::items, item); }
  void add(const VisibilityItem& item) { addTo(Stage::items, item); }
  void add(const ColorItem& item) { addTo(Stage::items, item); }
  void add(const DrawingItem& item) { addTo(Stage::items, item); }
  void add(const ViewItem& item) { addTo(Stage::items, item); }
  void add(const SignalItem& item) { addTo(Stage::items, item); }

  /// Of the device whose items have been added.
  void addNamedJoints(const std::string& device) {
    joints_.take([&](const std::string& owner, std::string line) {
      owned_[owner].add(Stage::items, &device, std::move(line));
    });
  }
  template <class Key>
  void addNamedJoints(const Key&) {}

  const std::optional<std::string_view> only_;
  NamedJointLines joints_;
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
    auto [path, end] = pathsOf(paths, name);
    for (; path != end; ++path) meet(path->second.owner);
  };
  eachItemOf(name, device, [&](const auto& item) { meet(item.owner()); });
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
