#include "golden/run/track_file.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

#include "core/base/hash.h"

namespace rocinante {
namespace {

constexpr std::string_view kTrackMagic = "rocinante track 1\n";
constexpr std::size_t kChecksumBytes = 16;

/// Visits the fields of a track; `Wire` reads or writes.
template <class Wire, class Track>
void trackFields(Wire& wire, Track& track) {
  wire.item(track.origin);
  wire.item(track.start);
  wire.item(track.end);
  wire.item(track.step);
  wire.item(track.samples);
  wire.item(track.devices);
  wire.item(track.facts);
  wire.item(track.events);
  wire.item(track.left_out);
}

class TrackWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void item(const T& value) { append(&value, sizeof value); }
  void item(const std::string& text) {
    item(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }
  template <class T>
  void item(const std::vector<T>& values) {
    item(static_cast<std::uint64_t>(values.size()));
    if constexpr (std::is_arithmetic_v<T>) {
      append(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) item(value);
    }
  }
  template <class T>
  void item(const std::map<std::string, T, std::less<>>& values) {
    item(static_cast<std::uint64_t>(values.size()));
    for (const auto& [name, value] : values) {
      item(name);
      item(value);
    }
  }
  void item(const Account& account) { item(accountLines(account)); }
  void item(const TrackColumn& column) {
    item(column.part);
    item(column.kind);
    item(column.offset);
  }
  void item(const DeviceTrack& device) {
    item(device.columns);
    item(device.width);
    item(device.rows);
    item(device.updates);
  }
  void item(const FactChange& change) {
    item(change.at);
    item(change.text);
    item(change.shape);
  }
  void item(const Event& event) {
    item(event.time);
    item(event.source);
    item(event.text);
  }
  Bytes bytes;

 private:
  void append(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
  }
};

class TrackReader {
 public:
  explicit TrackReader(ByteView bytes) : bytes_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void item(T& value) { take(&value, sizeof value); }
  void item(std::string& text) {
    text.resize(count(1));
    take(text.data(), text.size());
  }
  template <class T>
  void item(std::vector<T>& values) {
    if constexpr (std::is_arithmetic_v<T>) {
      const std::size_t size = count(sizeof(T)) * sizeof(T);
      if (!sound_ || size == 0) return;
      // Not resized first: zeros would be written before what is there.
      const ByteView taken = bytes_.first(size);
      values.reserve(size / sizeof(T));
      for (std::size_t at = 0; at < size; at += sizeof(T)) {
        T value;
        std::memcpy(&value, taken.data() + at, sizeof value);
        values.push_back(value);
      }
      bytes_ = bytes_.subspan(size);
    } else {
      values.resize(count(8));
      for (T& value : values) item(value);
    }
  }
  template <class T>
  void item(std::map<std::string, T, std::less<>>& values) {
    for (std::size_t i = count(8); i > 0 && sound_; --i) {
      std::string name;
      item(name);
      item(values[name]);
    }
  }
  void item(Account& account) {
    std::string lines;
    item(lines);
    account = accountOfLines(lines);
  }
  void item(TrackColumn& column) {
    item(column.part);
    item(column.kind);
    item(column.offset);
  }
  void item(DeviceTrack& device) {
    item(device.columns);
    item(device.width);
    item(device.rows);
    item(device.updates);
  }
  void item(FactChange& change) {
    item(change.at);
    item(change.text);
    item(change.shape);
  }
  void item(Event& event) {
    item(event.time);
    item(event.source);
    item(event.text);
  }
  bool readAll() const { return sound_ && bytes_.empty(); }

 private:
  /// Bounded by what remains: each item takes at least `least_bytes`.
  std::size_t count(std::size_t least_bytes) {
    std::uint64_t many = 0;
    item(many);
    if (many > bytes_.size() / least_bytes) sound_ = false;
    return sound_ ? static_cast<std::size_t>(many) : 0;
  }
  void take(void* data, std::size_t size) {
    if (size > bytes_.size()) sound_ = false;
    if (!sound_ || size == 0) return;
    std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }

  ByteView bytes_;
  bool sound_ = true;
};

/// What judging relies on.
bool isSound(const SessionTrack& track) {
  if (track.step <= Nanoseconds(0) || track.samples == 0 || track.end < track.start) return false;
  return std::ranges::all_of(track.devices, [&](const auto& entry) {
    const DeviceTrack& device = entry.second;
    std::size_t width = 0;
    for (const TrackColumn& column : device.columns) {
      if (column.kind > TrackColumn::Kind::link_pose || column.offset != width) return false;
      width += column.width();
    }
    return width == device.width && width > 0 && device.updates.size() == track.samples &&
           (device.rows.size() == width || device.rows.size() / width == track.samples) &&
           device.rows.size() % width == 0;
  });
}

}  // namespace

Bytes encodeTrack(const SessionTrack& track, std::string_view key) {
  TrackWriter writer;
  const auto head = bytesOf(kTrackMagic);
  writer.bytes.assign(head.begin(), head.end());
  writer.item(std::string(key));
  trackFields(writer, track);
  const auto checksum = xxh3(writer.bytes);
  writer.bytes.insert(writer.bytes.end(), checksum.begin(), checksum.end());
  return std::move(writer.bytes);
}

std::optional<SessionTrack> decodeTrack(ByteView bytes, std::string_view key) {
  const auto head = bytesOf(kTrackMagic);
  if (bytes.size() < head.size() + kChecksumBytes ||
      !std::ranges::equal(bytes.first(head.size()), head)) {
    return std::nullopt;
  }
  const ByteView content = bytes.first(bytes.size() - kChecksumBytes);
  if (!std::ranges::equal(xxh3(content), bytes.last(kChecksumBytes))) return std::nullopt;
  TrackReader reader(content.subspan(head.size()));
  std::string its_key;
  reader.item(its_key);
  if (its_key != key) return std::nullopt;
  SessionTrack track;
  trackFields(reader, track);
  if (!reader.readAll() || !isSound(track)) return std::nullopt;
  return track;
}

}  // namespace rocinante
