#pragma once

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/check/judges/joint_judge.h"
#include "core/check/judges/presence_judge.h"
#include "core/check/judges/sender_judge.h"
#include "core/check/judges/tally.h"
#include "core/check/rules/rule_settings.h"
#include "core/kinematics/model.h"
#include "core/packet/packet.h"

namespace rocinante {

/// The part of the cell's `[[source]]`s that concerns one device.
struct DeviceOwners {
  std::vector<std::string> names;  ///< sources whose `devices` name it
  /// Sources that list devices at all: devices that they do not list are not theirs. Borrowed.
  const std::set<std::string, std::less<>>* bound = nullptr;

  bool allow(std::string_view source) const;
};

/// Facts that are known only at the end.
struct SessionRoster {
  const std::vector<std::string>& sources;  ///< names by number
  const std::set<std::string, std::less<>>&
      missing;                                   ///< sources of the cell that never sent a packet
  const std::vector<std::string_view>& devices;  ///< that the cell has
};

/// Judges what a session says about one device against its model. Findings come at the end, when
/// it is known whether the device ever appeared.
class DeviceJudge {
 public:
  /// The rules must outlive it.
  DeviceJudge(std::string name, const RuleSettings& rules)
      : name_(std::move(name)), rules_(&rules) {}

  enum class Standing : std::uint8_t {
    there,     ///< from the start
    optional,  ///< it waits for `add` and need not be driven
    ghost,     ///< from its source's first packet on
  };
  void appearInCell(const Model* model, Standing standing);
  /// Where the cell puts it; borrowed.
  void setPlace(const CellDevice& device) { of_cell_ = &device; }
  void setOwners(DeviceOwners owners) { owners_ = std::move(owners); }

  /// `add` brought it; null when the cell knows no such model.
  void appearByAdd(const Model* model, const Statement& add, const PacketPlace& place);
  void disappear(const PacketPlace& place);

  /// Any statement that names the device, except `add` and `remove`.
  void mention(const PacketPlace& place) {
    if (mentioned_.count == 0 || !is_known_) mentioned_.hit(place);
    presence_.mention(place);
  }
  void judgeLink(std::string_view link, const PacketPlace& place);
  /// By the names of this source's last order if `ordered` (the state still holds one); else
  /// positional.
  void judgeJoints(std::span<const double> values, bool ordered, const PacketPlace& place);
  void judgeNamed(std::span<const std::string_view> names, std::span<const double> values,
                  const PacketPlace& place);
  void judgeOrder(std::span<const std::string_view> names, const PacketPlace& place);
  void judgePose(const Statement& pose, const PacketPlace& place);
  /// A value that was sent before the device had a model.
  void judgeEarlier(std::string_view value_name, double value, const PacketPlace& place);

  bool hasModel() const { return model_ != nullptr; }
  bool hasOrderOf(std::uint32_t source) const { return orders_.contains(source); }

  /// Drives or poses the device: a source's number and name.
  void writtenBy(std::string_view source_name, const PacketPlace& place);
  /// A movable device of the cell that should be driven and is not.
  bool isUndriven() const;
  const std::vector<std::string>& owners() const { return owners_.names; }
  /// A source that writes it although the cell gives it to others; empty: none.
  std::string stranger() const;

  void report(const SessionRoster& roster, Findings& findings) const;
  /// Forgets what was found, not what the device and its joints do.
  void dropFindings();
  /// The cell does not have it and no `add` keeps it: what is known of it may be forgotten.
  bool isStray() const { return !in_cell_ && !presence_.isThere(); }

 private:
  static constexpr std::uint32_t kNobody = TwoSources::kNobody;
  static constexpr std::size_t kNoValue = std::numeric_limits<std::size_t>::max();

  struct Value {
    JointJudge judge;
    std::uint32_t writer = kNobody;
    std::uint64_t stated_in = 0;  ///< number of the last statement that gave it
  };
  /// The order of each source's `joints`: indices into `values_`, kNoValue for an unknown name.
  struct Order {
    std::vector<std::string> names;
    std::vector<std::size_t> values;
  };
  struct Stranger {
    std::string name;
    Tally tally;
  };
  using NameTallies = std::map<std::string, Tally, std::less<>>;

  void useModel(const Model* model);
  void listValues(const Model& model);
  /// "`joints` takes them in this order: a, b, c".
  std::string expectedOrder() const;
  void judgePositional(std::span<const double> values, const PacketPlace& place);
  void resolve(Order& order) const;
  void judgeValue(std::size_t value, double number, const PacketPlace& place);
  void judgeUnitQuaternions(const PacketPlace& place);
  void judgeUnitOfPose(const Statement& pose, const PacketPlace& place);
  /// Index of the value in `values_`; kNoValue, with the fault counted, when there is none.
  std::size_t valueNamed(std::string_view value_name, const PacketPlace& place);

  void reportNames(Findings& findings) const;
  void reportValues(Findings& findings) const;
  bool reportDegrees(Findings& findings) const;
  bool reportPercent(Findings& findings) const;
  void reportUndriven(const SessionRoster& roster, Findings& findings) const;
  void reportWriters(const SessionRoster& roster, Findings& findings) const;

  std::string name_;
  const RuleSettings* rules_;
  DeviceOwners owners_;
  bool in_cell_ = false, is_optional_ = false, is_ghost_ = false, is_known_ = false;
  bool is_driven_ = false;
  PresenceJudge presence_;
  const Model* model_ = nullptr;
  std::vector<Value> values_;
  std::vector<std::size_t> quaternions_;  ///< the first of four values that form one
  std::map<std::string, std::size_t, std::less<>> value_by_name_;
  std::map<std::uint32_t, Order> orders_;
  std::uint32_t pose_writer_ = kNobody, writer_ = kNobody;
  const CellDevice* of_cell_ = nullptr;
  std::optional<bool> in_millimetres_;  ///< its first pose looked like it
  std::uint64_t statements_ = 0;
  std::map<std::uint32_t, Stranger> strangers_;
  Stranger* stranger_ = nullptr;  ///< of `writer_`

  Tally mentioned_, unknown_model_, other_kinematics_, joint_count_, repeated_joint_, not_unit_,
      millimetres_;
  std::string millimetres_text_, unknown_model_name_, joint_count_text_, joint_count_hint_,
      repeated_joint_name_;
  NameTallies unknown_links_, unknown_joints_, undrivable_joints_;
  NameTallies early_links_, early_joints_;  ///< sent before there was a model to judge them
  TwoSources two_drivers_, two_posers_;
  Findings earlier_;  ///< about the values of a model that it no longer has
};

}  // namespace rocinante
