#include "core/behaviour/track_cache.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "core/base/hash.h"
#include "core/kinematics/kinematics.h"
#include "core/log/mapped_file.h"
#include "core/report/account_wire.h"

namespace rocinante {
namespace {

/// Goes into keys: to be raised when tracks are made otherwise.
constexpr int kTrackVersion = 7;

}  // namespace

template <class Fields>
void fields(Fields& io, Taken<Fields, TrackColumn>& column) {
  auto& [part, kind, series, offset, is_stated, unit] = column;
  io(part, kind, series, offset, is_stated, unit);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, TrackSeries>& series) {
  auto& [width, rows, blocks] = series;
  io(width, rows, blocks);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, DeviceTrack>& device) {
  auto& [columns, series, updates] = device;
  io(columns, series, updates);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, FactChange>& change) {
  auto& [at, text, shape, is_restated] = change;
  io(at, text, shape, is_restated);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, Event>& event) {
  auto& [time, source, text] = event;
  io(time, source, text);
}

/// Its samples lie apart.
template <class Fields>
void fields(Fields& io, Taken<Fields, SessionTrack>& track) {
  auto& [origin, start, end, devices, numbers, rhythms, facts, events, is_imported, left_out,
         samples] = track;
  io(origin, start, end, devices, numbers, rhythms, facts, events, is_imported, left_out);
}

namespace {

constexpr std::string_view kTrackMagic = "rocinante track 10";
constexpr std::size_t kChecksumBytes = 16, kSizeBytes = 8;
constexpr std::size_t kFootBytes = kChecksumBytes + kSizeBytes;

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
  for (const auto& [item, series] : track.numbers) {
    if (series.width != 1 || !isSound(series, bytes)) return false;
  }
  for (const auto& [item, series] : track.rhythms) {
    if (series.width != 2 || !isSound(series, bytes)) return false;
  }
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
  StructWriter writer;
  writer(std::string(kTrackMagic), std::string(key), track,
         std::uint64_t{track.samples->view().size()});
  Bytes bytes = writer.take();
  Xxh3 hash;
  hash.add(track.samples->view());
  hash.add(bytes);
  const auto checksum = hash.digest();
  bytes.insert(bytes.end(), checksum.begin(), checksum.end());
  return bytes;
}

std::optional<SessionTrack> decodeTrack(MappedFile file, std::string_view key) {
  const ByteView bytes = file.bytes();
  if (bytes.size() < kFootBytes) return std::nullopt;
  const ByteView content = bytes.first(bytes.size() - kChecksumBytes);
  if (!std::ranges::equal(xxh3(content), bytes.last(kChecksumBytes))) return std::nullopt;
  std::uint64_t samples = 0;
  std::memcpy(&samples, content.last(kSizeBytes).data(), kSizeBytes);
  if (samples > content.size() - kSizeBytes) return std::nullopt;
  StructReader reader(content.subspan(samples, content.size() - kSizeBytes - samples));
  std::string magic, its_key;
  reader(magic, its_key);
  if (magic != kTrackMagic || its_key != key) return std::nullopt;
  SessionTrack track;
  reader(track);
  if (!reader.readAll() || !isSound(track, samples)) return std::nullopt;
  track.samples = std::make_shared<const SampleBytes>(std::move(file), samples);
  return track;
}

std::string trackCellHash(const Cell& cell) {
  std::string text;
  for (const CellDevice& device : cell.devices) {
    const Model* model = cell.modelOf(device);
    const Pose& pose = device.pose;
    text += fmt::format("{}\n{}\n{}\n{} {} {} {} {} {} {}\n{:016x}\n", device.name,
                        device.on_device, device.on_link, pose.position.x, pose.position.y,
                        pose.position.z, pose.orientation.x, pose.orientation.y, pose.orientation.z,
                        pose.orientation.w, model == nullptr ? 0 : kinematicsHash(*model));
  }
  for (const auto& [name, model] : cell.models) {
    text += fmt::format("{}\n{:016x}\n", name, model == nullptr ? 0 : kinematicsHash(*model));
  }
  return hexOf(xxh3(bytesOf(text)));
}

Result<SessionTrack> TrackCache::track(const Cell& cell, const std::filesystem::path& log,
                                       const std::string& bytes_hash,
                                       const std::vector<std::string>& links) const {
  if (files_.path().empty()) return trackSession(cell, log, links);
  const std::string key = hexOf(xxh3(bytesOf(fmt::format(
      "{} {} {} {}", kTrackVersion, bytes_hash, fmt::join(links, "\n"), trackCellHash(cell)))));
  // A kept file is replaced and removed, never changed: a mapping of it stays whole.
  if (auto kept = MappedFile::open(files_.fileOf(key));
      kept.ok() && kept->bytes().size() <= kMaxBytes) {
    if (auto track = decodeTrack(std::move(*kept), key)) {
      files_.touch(key);
      return std::move(*track);
    }
  }
  auto track = trackSession(cell, log, links);
  if (track.ok()) files_.store(key, {track->samples->view(), encodeTrackTail(*track, key)});
  return track;
}

}  // namespace rocinante
