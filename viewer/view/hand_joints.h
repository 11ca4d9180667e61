#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The SOURCE of what withHand() folds; none that sends.
inline constexpr std::string_view kHandSource = "rocinante-view";

/// Values by Model::findJointValue's names, by device: radians and metres. No device without
/// values.
using JointsByDevice =
    std::map<std::string, std::map<std::string, double, std::less<>>, std::less<>>;

/// The `joint` statements that say them, one a device. Views into `joints`, which is copied.
class JointStatements {
 public:
  explicit JointStatements(JointsByDevice joints);
  JointStatements(const JointStatements&) = delete;
  JointStatements& operator=(const JointStatements&) = delete;
  std::span<const Statement> all() const { return statements_; }

 private:
  JointsByDevice joints_;
  std::vector<std::vector<std::string_view>> names_;
  std::vector<std::vector<double>> numbers_;
  std::vector<Statement> statements_;
};

/// Joint values set by hand, by the window's sliders or by `--joints`: radians and metres, not
/// bounded by limits. A plain value. docs/decisions/018.
class HandJoints {
 public:
  using Values = JointsByDevice::mapped_type;

  /// bad_argument for a value that the model has not (drivenValue) or that is not finite.
  Status set(const std::string& device, const Model& model, const std::string& value_name,
             double value);
  /// All values of a full positional `joints`; bad_argument for another count.
  Status setAll(const std::string& device, const Model& model, std::span<const double> values);
  void reset(const std::string& device, const std::string& value_name);
  void reset(const std::string& device);
  void clear() { devices_.clear(); }

  bool empty() const { return devices_.empty(); }
  const JointsByDevice& devices() const { return devices_; }
  std::optional<double> find(std::string_view device, std::string_view value_name) const;
  /// How many values of how many devices are set.
  std::size_t count() const;

  bool operator==(const HandJoints&) const = default;

 private:
  JointsByDevice devices_;
};

/// `received` with the values folded over it, as one more packet by kHandSource at `moment`, which
/// is not before the last one folded. So mimic joints follow, and the picture is that of a source
/// saying the same.
SessionState withHand(const SessionState& received, LogTime moment, const HandJoints& hand);

/// Sets the values of "[DEVICE=]VALUES", the text of `--joints`: all joints of the device in its
/// model's order, radians and metres. DEVICE as in a PATH; it may be missing when only one device
/// of the cell has joints. bad_argument when the cell cannot take them.
Status setJoints(HandJoints& hand, const Cell& cell, std::string_view text);

/// The text for setJoints(): shortest numbers that read back as the same doubles.
std::string jointsText(const Cell& cell, const std::string& device, std::span<const double> values);

}  // namespace rocinante
