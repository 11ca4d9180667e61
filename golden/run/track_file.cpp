#include "golden/run/track_file.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

#include "core/base/hash.h"

namespace rocinante {
namespace {

constexpr std::string_view kTrackMagic = "rocinante track 6\n";
constexpr std::size_t kChecksumBytes = 16, kSizeBytes = 8;
constexpr std::size_t kFootBytes = kChecksumBytes + kSizeBytes;

/// Visits the fields of a track; `Wire` reads or writes.
template <class Wire, class Track>
void trackFields(Wire& wire, Track& track) {
  wire.item(track.origin);
  wire.item(track.start);
  wire.item(track.end);
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
    item(column.series);
    item(column.offset);
    item(column.is_stated);
  }
  void item(const TrackSeries& series) {
    item(series.width);
    item(series.rows);
    item(series.blocks);
  }
  void item(const DeviceTrack& device) {
    item(device.columns);
    item(device.series);
    item(device.updates);
  }
  void item(const FactChange& change) {
    item(change.at);
    item(change.text);
    item(change.shape);
    item(change.is_restated);
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
    item(column.series);
    item(column.offset);
    item(column.is_stated);
  }
  void item(TrackSeries& series) {
    item(series.width);
    item(series.rows);
    item(series.blocks);
  }
  void item(DeviceTrack& device) {
    item(device.columns);
    item(device.series);
    item(device.updates);
  }
  void item(FactChange& change) {
    item(change.at);
    item(change.text);
    item(change.shape);
    item(change.is_restated);
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

/// True when the blocks of a series lie within `bytes` of samples.
bool isSound(const TrackSeries& series, std::uint64_t bytes) {
  constexpr std::uint64_t kMostWidth = std::uint64_t{1} << 32;
  if (series.width > kMostWidth || series.rows > bytes) return false;
  const std::uint64_t blocks = (series.rows + kBlockRows - 1) / kBlockRows;
  if (series.blocks.size() != blocks) return false;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t rows = std::min<std::uint64_t>(kBlockRows, series.rows - i * kBlockRows);
    const std::uint64_t size = rows * (series.width + 1) * sizeof(double);
    if (size > bytes || series.blocks[i] > bytes - size) return false;
  }
  return true;
}

/// What judging relies on.
bool isSound(const SessionTrack& track, std::uint64_t bytes) {
  if (track.end < track.start) return false;
  return std::ranges::all_of(track.devices, [&](const auto& entry) {
    const DeviceTrack& device = entry.second;
    return std::ranges::all_of(device.series,
                               [&](const TrackSeries& series) { return isSound(series, bytes); }) &&
           std::ranges::all_of(device.columns, [&](const TrackColumn& column) {
             return column.kind <= TrackColumn::Kind::link_pose &&
                    column.series < device.series.size() &&
                    column.width() <= device.series[column.series].width &&
                    column.offset <= device.series[column.series].width - column.width();
           });
  });
}

}  // namespace

Bytes encodeTrackTail(const SessionTrack& track, std::string_view key) {
  TrackWriter writer;
  const auto head = bytesOf(kTrackMagic);
  writer.bytes.assign(head.begin(), head.end());
  writer.item(std::string(key));
  trackFields(writer, track);
  writer.item(static_cast<std::uint64_t>(track.samples->view().size()));
  Xxh3 hash;
  hash.add(track.samples->view());
  hash.add(writer.bytes);
  const auto checksum = hash.digest();
  writer.bytes.insert(writer.bytes.end(), checksum.begin(), checksum.end());
  return std::move(writer.bytes);
}

std::optional<SessionTrack> decodeTrack(MappedFile file, std::string_view key) {
  const ByteView bytes = file.bytes();
  if (bytes.size() < kFootBytes) return std::nullopt;
  const ByteView content = bytes.first(bytes.size() - kChecksumBytes);
  if (!std::ranges::equal(xxh3(content), bytes.last(kChecksumBytes))) return std::nullopt;
  std::uint64_t samples = 0;
  std::memcpy(&samples, content.last(kSizeBytes).data(), kSizeBytes);
  const auto head = bytesOf(kTrackMagic);
  if (samples > content.size() - kSizeBytes) return std::nullopt;
  const ByteView tail = content.subspan(samples, content.size() - kSizeBytes - samples);
  if (tail.size() < head.size() || !std::ranges::equal(tail.first(head.size()), head)) {
    return std::nullopt;
  }
  TrackReader reader(tail.subspan(head.size()));
  std::string its_key;
  reader.item(its_key);
  if (its_key != key) return std::nullopt;
  SessionTrack track;
  trackFields(reader, track);
  if (!reader.readAll() || !isSound(track, samples)) return std::nullopt;
  track.samples = std::make_shared<const SampleBytes>(std::move(file), samples);
  return track;
}

}  // namespace rocinante
