#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/base/time.h"
#include "core/math/vector.h"
#include "core/packet/name_cache.h"
#include "core/packet/packet.h"

namespace rocinante {

// Longer than other headers: the state is one plain value, and its parts are public with it.

/// A path whose names are owned. Orders as (is_layer, first, second).
struct Path {
  bool is_layer = false;
  std::string first;
  std::string second;
  auto operator<=>(const Path&) const = default;
};

/// When an item was last stated, counted in packets folded. Used for unfinished restatements and
/// not part of a state's identity: any two are equal.
struct StatedMark {
  std::uint64_t packet = 0;
  bool operator==(const StatedMark&) const { return true; }
};

/// A value with the SOURCE that wrote it last.
template <class T>
struct Item {
  T value;
  std::string owner;
  StatedMark stated;
  bool operator==(const Item&) const = default;
};

enum class Presence : std::uint8_t { added, removed };

struct PresenceValue {
  Presence presence = Presence::added;
  std::string model;                        ///< MODEL of `add`
  std::optional<std::uint64_t> kinematics;  ///< kin= of `add`
  bool operator==(const PresenceValue&) const = default;
};

struct PoseValue {
  Pose pose;
  Path carrier;  ///< empty `first`: the world
  bool operator==(const PoseValue&) const = default;
};

/// One named value: a number with its unit, true or false, or a text.
struct SignalValue {
  SignalKind kind = SignalKind::number;
  double number = 0;  ///< of booleans 1 or 0
  std::string text;   ///< of texts
  std::string unit;   ///< of numbers; empty while nobody has said one
  bool operator==(const SignalValue&) const = default;
};

/// What a signal is called within its device, or among those of no device.
struct SignalName {
  std::string link;  ///< empty: of the device itself
  std::string name;
  bool operator==(const SignalName&) const = default;
};
struct SignalNameView {
  SignalNameView(std::string_view of_link, std::string_view of_name)
      : link(of_link), name(of_name) {}
  SignalNameView(const SignalName& of) : link(of.link), name(of.name) {}
  std::string_view link, name;
  // Not <=>, which string_view lacks in the library of the page's compiler.
  bool operator<(const SignalNameView& o) const {
    return std::tie(link, name) < std::tie(o.link, o.name);
  }
};
struct SignalOrder {
  using is_transparent = void;
  bool operator()(const SignalNameView& a, const SignalNameView& b) const { return a < b; }
};
using Signals = std::map<SignalName, Item<SignalValue>, SignalOrder>;

/// Everything stated about one device. Nothing stated (an empty optional, a missing key) means the
/// cell's own value.
struct DeviceState {
  using Orders = std::map<std::string, Item<std::vector<std::string>>, std::less<>>;
  using NamedJoints = std::map<std::string, Item<double>, std::less<>>;

  std::optional<Item<PresenceValue>> presence;
  std::optional<Item<PoseValue>> pose;
  /// Positional values, one item: as many as the sender sent (check judges the count).
  std::optional<Item<std::vector<double>>> joints;
  /// Values by joint name. They override positional values; new positional values clear them.
  NamedJoints named_joints;
  /// The joints that a SOURCE's `joints DEVICE` means, by SOURCE (which is also the owner).
  Orders orders;
  Signals signals;       ///< of it and of its links
  LogTime last_write{};  ///< of any statement about this device

  /// Its items by kind, in the order in which they are sent.
  auto slots() { return std::tie(presence, joints, orders, named_joints, pose, signals); }
  auto slots() const { return std::tie(presence, joints, orders, named_joints, pose, signals); }

  bool operator==(const DeviceState&) const = default;
};

struct Visibility {
  enum class Kind : std::uint8_t { shown, hidden, by_default } kind = Kind::shown;
  bool operator==(const Visibility&) const = default;
};

struct ColorValue {
  std::optional<std::uint32_t> rgba;  ///< 0xRRGGBBAA; empty: stated to be the cell's own
  bool operator==(const ColorValue&) const = default;
};

/// A line, a cloud of points or a label of a source's drawing.
struct Drawing {
  StatementKind kind = StatementKind::line;
  std::uint32_t rgba = 0xFFFFFFFF;
  double size_px = 1;
  Path carrier;
  std::string text;  ///< labels
  /// The parts of a long line, in order; one for a short line. A missing part is an empty optional:
  /// a gap. Each holds x y z triples, metres. A line continues from part to part, but not across a
  /// gap.
  std::vector<std::optional<std::vector<double>>> parts;
  std::vector<StatedMark> parts_stated;  ///< by part: a restatement can remove single parts
  bool operator==(const Drawing&) const = default;
};

struct ViewValue {
  Vec3 eye{}, target{}, up{0, 0, 1};
  double fov_deg = 45;
  std::optional<double> ortho_height_m;
  Path carrier;
  bool operator==(const ViewValue&) const = default;
};

/// What the fold remembers of a source to apply "newest wins" and to complete restatements.
struct SourceState {
  std::string run;
  std::optional<std::uint64_t> highest_sequence;
  std::optional<std::int64_t> time_ns;  ///< TIME of the last datagram folded
  bool operator==(const SourceState&) const = default;
};

/// Counts that are not part of the state's identity. Restatements by others (`by=`) count only in
/// `by_others` and `faults`.
struct SourceCounts {
  std::uint64_t packets = 0;     ///< applied
  std::uint64_t by_others = 0;   ///< applied: restatements by other programs
  std::uint64_t whole = 0;       ///< its own, applied or late, that no relay filtered
  std::uint64_t filtered = 0;    ///< the others: from a filtering relay (`via=`)
  std::uint64_t late = 0;        ///< dropped: at or below the highest sequence
  std::uint64_t duplicates = 0;  ///< of those: a sequence number seen before
  std::uint64_t gap = 0;         ///< numbers not seen so far; via a relay see RelayCounts
  std::uint64_t restarts = 0;
  /// By PacketFault, of applied packets; items refused by the fold itself count as too_many.
  std::array<std::uint64_t, kPacketFaultCount> faults{};
  /// Which of the 64 numbers below the highest were seen, the nearest in the lowest bit.
  std::uint64_t recent = ~std::uint64_t{0};

  /// A source must be heard whole or filtered: what one path leaves out, the other overwrites.
  bool isMixed() const { return whole > 0 && filtered > 0; }
};

/// The output of a filtering relay (`via=RELAY:N`), judged by its own count.
struct RelayCounts {
  std::uint64_t packets = 0;
  std::uint64_t gap = 0;  ///< numbers not seen so far
  std::uint64_t restarts = 0;
  std::optional<std::uint64_t> highest;
  std::uint64_t recent = ~std::uint64_t{0};  ///< as in SourceCounts
};

struct Event {
  LogTime time;
  std::string source;
  std::string text;
};

/// The result of folding a packet.
enum class Applied : std::uint8_t {
  yes,
  late,     ///< dropped whole: not above the highest sequence of its source
  refused,  ///< dropped whole: a new source, and no room for one (docs/packet-format.md, "Limits")
};

/// The state of a session at a log time: live viewing, scrubbing, golden frames and check share
/// this one fold. A plain value: copy it to keep a moment. Independent of any cell. Not for sharing
/// between threads.
/// Defined by docs/packet-format.md, section "The fold".
class SessionState {
 public:
  /// Folds one packet. `time` must not go back (a datagram later in the log's order).
  Applied apply(LogTime time, const Packet& packet);

  using Devices = std::map<std::string, DeviceState, std::less<>>;
  /// (SOURCE, ID): IDs belong to their source.
  using Drawings = std::map<std::pair<std::string, std::string>, Drawing>;

  const Devices& devices() const { return devices_; }
  /// The state of one device; null when nothing was stated about it. Fast for a recently written
  /// one.
  const DeviceState* findDevice(std::string_view name) const {
    if (Devices::value_type* const* const known = device_cache_.find(name)) {
      return &(*known)->second;
    }
    const auto found = devices_.find(name);
    return found == devices_.end() ? nullptr : &found->second;
  }
  const std::map<Path, Item<Visibility>>& visibility() const { return visibility_; }
  const std::map<Path, Item<ColorValue>>& colors() const { return colors_; }
  const Drawings& drawings() const { return drawings_; }
  const std::map<std::string, Item<ViewValue>, std::less<>>& views() const { return views_; }
  /// Those that belong to no device; their `link` is empty.
  const Signals& signals() const { return signals_; }
  /// All items, by map; whoever walks over them uses the walkers of state_items.
  auto maps() const {
    return std::tie(devices_, visibility_, colors_, drawings_, views_, signals_);
  }
  static constexpr std::array<std::string_view, 6> kMapNames = {
      "devices", "visibility", "colors", "drawings", "views", "signals"};

  /// A signal of `device`, or of none when that is empty; null when it is not stated.
  const Item<SignalValue>* findSignal(std::string_view device, const SignalNameView& name) const {
    const DeviceState* const of_device = device.empty() ? nullptr : findDevice(device);
    if (of_device == nullptr && !device.empty()) return nullptr;
    const Signals& signals = of_device == nullptr ? signals_ : of_device->signals;
    const auto found = signals.find(name);
    return found == signals.end() ? nullptr : &found->second;
  }
  /// Of all devices and of none.
  std::size_t signalCount() const { return signal_count_; }
  const std::map<std::string, SourceState, std::less<>>& sources() const { return sources_; }

  /// Counters and faults since the state was made; never part of the identity.
  const std::map<std::string, SourceCounts, std::less<>>& counts() const { return counts_; }

  /// The same for relays that number their own output, by name.
  const std::map<std::string, RelayCounts, std::less<>>& relays() const { return relays_; }

  /// Memory used by items and sources, as the limits table counts it.
  std::uint64_t weight() const { return weight_; }

  /// Events of the packets folded since the last call, oldest first; events are not state.
  std::vector<Event> takeEvents();

  /// True while a restatement of a source is incomplete, as of the last packet.
  bool restatementOpen() const { return !open_.empty(); }
  /// The same at `now`: a restatement that has timed out is no longer open.
  bool restatementOpen(LogTime now) const;

  /// Same items with their owners, sources and last writes: a state's identity.
  bool sameAs(const SessionState& other) const;

  /// The identity as text, one item a line, sorted: equal exactly when sameAs(). Readable as a
  /// diff; identityHash() hashes it.
  std::string identityText() const;

 private:
  friend class StateFolder;

  /// A restatement with parts still missing.
  struct OpenRestatement {
    std::string id;
    std::vector<bool> came;
    std::size_t missing = 0;
    LogTime began{};
    std::uint64_t first_packet = 0;  ///< items stated before this packet are removed at the end
    bool nothing_before = false;     ///< it begins with the source's first packet: none to remove
  };

  auto ownMaps() { return std::tie(devices_, visibility_, colors_, drawings_, views_, signals_); }

  Devices devices_;
  std::map<Path, Item<Visibility>> visibility_;
  std::map<Path, Item<ColorValue>> colors_;
  Drawings drawings_;
  std::map<std::string, Item<ViewValue>, std::less<>> views_;
  Signals signals_;
  std::map<std::string, SourceState, std::less<>> sources_;
  std::uint64_t weight_ = 0;
  std::size_t signal_count_ = 0;  ///< of all devices and of none

  std::map<std::string, OpenRestatement, std::less<>> open_;  ///< by SOURCE
  LogTime open_until_{};       ///< when the first of `open_` times out
  std::uint64_t packets_ = 0;  ///< applied; the count in StatedMark

  std::map<std::string, SourceCounts, std::less<>> counts_;
  std::map<std::string, RelayCounts, std::less<>> relays_;
  std::vector<Event> events_;
  struct KnownSource {
    SourceState* state = nullptr;
    SourceCounts* counts = nullptr;
  };
  NameCache<KnownSource> source_cache_;
  NameCache<Devices::value_type*> device_cache_;
};

}  // namespace rocinante
