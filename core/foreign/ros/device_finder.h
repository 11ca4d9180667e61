#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"

namespace rocinante::ros {

/// Which device of a cell a ROS name means (docs/other-formats.md, "How names find their devices").
/// Knows names only. A plain value; borrows nothing.
class DeviceFinder {
 public:
  /// `fallback`: the device for joints and frames that name none; empty: none.
  DeviceFinder(const Cell* cell, std::string fallback);

  struct Link {
    std::string device, link;
  };

  /// Without a cell every name is a device of its own.
  bool knowsDevices() const { return !devices_.empty(); }
  const std::string& fallback() const { return fallback_; }
  /// The device of a cell that has one.
  std::optional<std::string> onlyDevice() const;

  /// The device whose root the frame is: "arm/base_link", "arm", or "base_link" when one device
  /// alone has that root.
  std::optional<std::string> deviceOfFrame(std::string_view frame) const;
  /// The link that the frame is: "arm/link6", or "link6" when one device alone has it.
  std::optional<Link> linkOfFrame(std::string_view frame) const;
  /// A frame "PREFIX/LINK" whose PREFIX names no device (`frame_prefix` of robot_state_publisher, a
  /// namespace): LINK of the device that a part of PREFIX is, else of the one device that has it.
  struct PrefixedLink {
    Link link;
    bool is_root = false;
    bool is_named = false;  ///< PREFIX names the device
    std::string_view prefix;
  };
  std::optional<PrefixedLink> prefixedLinkOf(std::string_view frame) const;
  /// The device that a part of the topic's name is; the last one when there are several.
  std::optional<std::string> deviceOfTopic(std::string_view topic) const;
  /// Without a cell: the topic's namespace, or else `otherwise`.
  std::string madeUpDevice(std::string_view topic, std::string_view otherwise) const;

  bool hasJoint(std::string_view device, std::string_view joint) const {
    return jointOf(device, joint) != nullptr;
  }
  /// Whether the device has a model, and no joint or value of one of this name, nor one that it may
  /// be a misspelling of.
  bool lacksJoint(std::string_view device, std::string_view joint) const;

  enum class JointMatch : std::uint8_t {
    driven,     ///< of `device`, as joint `name`
    passive,    ///< a fixed or mimic joint: not sent
    ambiguous,  ///< a joint of several devices
    unknown,    ///< of no device
  };
  struct JointHome {
    JointMatch match = JointMatch::unknown;
    std::string device, name;
  };
  /// Where the joints of one message belong, in their order. `stated`: the device that goes before
  /// what the topic is called; empty: none.
  std::vector<JointHome> homesOf(std::string_view topic, std::span<const std::string_view> joints,
                                 std::string_view stated = {}) const;

 private:
  struct Joint {
    std::string device;
    bool driven = false;
  };
  const Joint* jointOf(std::string_view device, std::string_view name) const;
  JointHome homeOf(std::string_view joint, const std::optional<std::string>& by_topic) const;

  std::string fallback_;
  std::set<std::string, std::less<>> devices_, modelled_;
  std::multimap<std::string, Joint, std::less<>> joints_;
  std::multimap<std::string, std::string, std::less<>> roots_;  ///< root link -> device
  std::multimap<std::string, std::string, std::less<>> links_;  ///< any link -> device
};

}  // namespace rocinante::ros
