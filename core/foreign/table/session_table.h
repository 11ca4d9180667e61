#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// A session as a table: one column for each joint value and each component of a pose, named as
/// `source --csv` reads them: DEVICE.JOINT, and DEVICE:x :y :z :qx :qy :qz :qw (metres, unit
/// quaternion, in the world). Devices are in order of their names; of each its joints, then its
/// pose. The columns are found first, by showing it every state (notice), then rows are filled.
///
/// Names of joints: those that packets use; for positional values those of the device's model, if
/// `cell` has one with as many, else their numbers from 1. With a cell, a device whose joints are
/// stated has a column for every joint of its model; those that no packet states have the model's
/// own value. Without one, and for what is not stated yet, removed, or forgotten, the value is NaN.
///
/// With signals, a device has columns for its numbers and booleans (1 or 0) behind its pose, named
/// `signal PATH NAME`; those of no device are the last columns.
class SessionTable {
 public:
  /// `cell` is borrowed; null: none. `devices` are patterns (core/base/pattern.h); empty: all, and
  /// the signals of no device.
  SessionTable(const Cell* cell, std::vector<std::string> devices, bool with_signals = false);

  /// Adds columns for what the state at `moment` says of devices that were written then.
  void notice(const SessionState& state, LogTime moment);
  /// The same for everything in the state, as at the beginning.
  void noticeAll(const SessionState& state);
  /// Ends noticing.
  void layOut();

  /// Valid after layOut().
  const std::vector<std::string>& columns() const { return columns_; }
  /// True if something of a device in the table was written at `moment`.
  bool wasWritten(const SessionState& state, LogTime moment);
  /// `row` is as long as columns().
  void fill(const SessionState& state, std::span<double> row);
  /// Of a row that is written: the units of its numbers.
  void noticeUnits(const SessionState& state, LogTime moment);

  /// A column that has numbers in several units.
  struct SeveralUnits {
    std::string column;
    std::string first, other;  ///< empty: none was stated
    LogTime other_at;          ///< the first row in another one
  };
  /// In order of the columns.
  std::vector<SeveralUnits> severalUnits() const;
  /// What the reader of the table should know: sentences, found by layOut() and fill(). Not a loss:
  /// names that the session does not tell, columns that `source --csv` would read differently.
  std::vector<std::string> remarks() const;
  /// What is missing in the table: poses in the space of another device, without a cell that says
  /// where that is.
  std::vector<std::string> gaps() const;
  /// Signals with texts, which have no column, each once: "signal arm mode".
  std::vector<std::string> texts() const;
  /// Of a table without columns: which devices no pattern matches, "; there are arm, gantry", or
  /// the one that was probably meant. Empty: every device was chosen.
  std::string otherDevices() const;

 private:
  struct SignalColumn {
    std::size_t place = 0;  ///< among those of the device
    std::optional<std::string> unit;
    std::string other_unit;
    std::optional<LogTime> other_at;
  };
  /// The columns of signals, in order.
  using SignalColumns = std::map<SignalName, SignalColumn, SignalOrder>;
  struct Device {
    const Model* model = nullptr;
    std::vector<std::string> joints;                 ///< in the order of their columns
    std::map<std::string, std::size_t> joint_place;  ///< into `joints`, by name
    std::vector<std::string> positional;             ///< names of positional values
    std::vector<double> own_values;                  ///< by joint: of the model; else NaN
    std::size_t most_positional = 0;
    bool has_pose = false;
    std::size_t first_column = 0;
    bool has_bare_numbers = false;
    SignalColumns signals;
  };
  using Devices = std::map<std::string, Device, std::less<>>;

  bool chosen(std::string_view device);
  void noticeDevice(const std::string& name, const DeviceState& state);
  const Model* modelOf(const std::string& name, const DeviceState& state) const;
  void addJoint(Device& device, std::string_view joint);
  void noticeSignals(const std::string& device, const Signals& signals, SignalColumns& columns);
  void layOutSignals(const std::string& device, SignalColumns& columns);
  /// Calls visit(column, value) for each number and boolean that has a column.
  template <class Columns, class Visit>
  static void eachSignal(Columns& columns, const Signals& signals, Visit visit);
  static void fillSignals(const SignalColumns& columns, const Signals& signals,
                          std::span<double> row);
  void fillJoints(const Device& device, const DeviceState& state, std::span<double> row) const;
  void fillPose(const std::string& name, const SessionState& state, const PoseValue& pose,
                std::span<double> row);

  const Cell* cell_;
  std::vector<std::string> patterns_;
  std::map<std::string, bool, std::less<>> chosen_;  ///< the answers of the patterns
  bool with_signals_;
  Devices devices_;
  SignalColumns of_none_;          ///< signals of no device
  std::size_t first_of_none_ = 0;  ///< their first column
  /// When one of them was stated last, in packets: as noticed, and as filled.
  std::uint64_t noticed_of_none_ = 0, written_of_none_ = 0;
  std::vector<std::string> columns_;
  std::map<std::string, SignalColumns, std::less<>> texts_;  ///< by device
  std::set<std::string> carried_;  ///< devices with poses that are not known in the world
};

}  // namespace rocinante
