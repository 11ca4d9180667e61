#include "golden/run/track_cache.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/hash.h"
#include "core/kinematics/kinematics.h"
#include "core/log/mapped_file.h"
#include "golden/run/track_file.h"

namespace rocinante {
namespace {

/// Goes into keys: to be raised when tracks are made otherwise.
constexpr int kTrackVersion = 4;

}  // namespace

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
