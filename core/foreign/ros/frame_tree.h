#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foreign/ros/device_finder.h"
#include "core/math/vector.h"
#include "core/report/account.h"

namespace rocinante::ros {

/// Most frames that are followed; transforms of further ones are refused.
inline constexpr std::size_t kMaxFrames = 4096;
/// Most frames between one and its root; a longer chain, or a loop, has no place.
inline constexpr std::size_t kMaxFrameDepth = 256;

bool isFinite(const Vec3& vector);

/// The frames of tf: who is whose parent, and where. The newest transform of a frame counts. Turns
/// frames into places that packets can say: in the world, or carried by a link of a device.
class FrameTree {
 public:
  explicit FrameTree(const DeviceFinder& devices) : devices_(devices) {}

  /// Who said where a frame is. A better one replaces a worse one, never the other way round.
  enum class Origin : std::uint8_t { none, odometry, transform };

  enum class Taken : std::uint8_t {
    yes,
    overruled,  ///< a better origin has placed the frame
    refused,    ///< no room, or a name or number that no packet can say
  };
  /// Places `child` in `parent`. `pose` may have any length of quaternion but zero.
  Taken place(std::string_view parent, std::string_view child, const Pose& pose, Origin origin);

  struct Place {
    std::string device, link;  ///< the carrier; empty: the world
    Pose pose;
  };
  /// Of a frame, in the world or in the link that it is or hangs on; a frame that nothing placed is
  /// the world itself. Empty for a loop.
  std::optional<Place> placeOf(std::string_view frame);
  /// Of a pose in a frame, for the device `own`, whose links do not carry it. Empty also when the
  /// pose is not a finite one.
  std::optional<Place> placeIn(std::string_view frame, const Pose& pose, std::string_view own);

  /// The device or link that a frame is, by its name alone; a root has no `link`. Empty for none,
  /// and without a cell.
  std::optional<DeviceFinder::Link> ownerOf(std::string_view frame);

  /// A device that was moved since the last call.
  struct Moved {
    const std::string* device;
    Place place;
  };
  /// Each once, in the order in which their frames came.
  std::vector<Moved> takeMoved();

  /// Transforms that moved nothing, by their frames: those of links that joints move, and frames
  /// that no device, and nothing that was drawn, hangs on.
  Account account() const;

 private:
  struct Frame {
    std::string name;
    std::string other_prefix;      ///< not empty: a link of this device, but with another prefix
    std::uint64_t transforms = 0;  ///< that placed it
    mutable bool used = false;     ///< something was placed in it
    std::optional<std::string> device;       ///< whose root it is
    std::optional<DeviceFinder::Link> link;  ///< that it is
    std::optional<std::size_t> parent;
    Pose pose;
    Origin origin = Origin::none;
    bool moved = false;
  };

  std::optional<std::size_t> frameOf(std::string_view name);
  void findLink(Frame& frame);
  /// Links of `own` do not carry it. `moved`: whether the frame or one on the way was moved.
  std::optional<Place> placeOf(std::size_t frame, std::string_view own, bool& moved) const;

  const DeviceFinder& devices_;
  std::vector<Frame> frames_;
  std::map<std::string, std::size_t, std::less<>> by_name_;
  std::vector<std::size_t> device_frames_;  ///< those that are roots of devices
  std::vector<std::size_t> moved_;
  /// What stands before the links of a device in the names of frames, by the first that came.
  std::map<std::string, std::string, std::less<>> prefixes_;
};

}  // namespace rocinante::ros
