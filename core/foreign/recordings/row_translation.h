#pragma once

#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/time.h"
#include "core/foreign/recordings/overwritten_rows.h"
#include "core/foreign/ros/bag_reader.h"
#include "core/foreign/ros/device_finder.h"
#include "core/packet/item_text.h"
#include "core/packet/packet_text.h"
#include "core/report/account.h"

namespace rocinante {

/// Turns rows of named values into packet text: joints, poses and signals
/// (docs/other-formats.md, "Tables and JSON lines"). One per recording.
class RowTranslation {
 public:
  /// `topic` of the rows, `decoder` the name of what makes the packets: both are in their SOURCE.
  /// `kind`: what the account calls a name: "column".
  RowTranslation(std::string topic, std::string_view decoder, std::string kind);

  /// Borrowed; before the first row. Without it there is no cell and no device by default.
  void useDevices(const ros::DeviceFinder& devices) { devices_ = &devices; }

  /// The names of the next rows' numbers. Cheap when they are those of the rows before.
  void setNames(std::span<const std::string_view> names);
  void setNames(std::span<const std::string> names);

  /// Whether any value fits there, not only a number that a joint can have. After setNames().
  bool isSignal(std::size_t place) const { return signal_at_[place] != kNoSignal; }

  /// What is said in the place of a number.
  struct Word {
    std::size_t place = 0;
    SignalValue value;
  };
  /// In `numbers` NaN: the row does not say it, or says a word.
  struct Outcome {
    std::string_view packet;  ///< borrowed until the next call; empty: nothing to say
    bool malformed = false;   ///< a part of a pose alone
  };
  Outcome translate(Nanoseconds time, std::span<const double> numbers,
                    std::span<const Word> words = {});
  /// The line of the next row, from 1.
  void atLine(std::size_t line) { line_ = line; }
  const OverwrittenRows& overwritten() const { return overwritten_; }

  /// A name whose values are no numbers of a device.
  void leaveOut(std::string_view name, std::string_view reason, Severity severity);
  /// The names whose values were left out, each once, with the reason.
  const Account& account() const { return account_; }

 private:
  struct DevicePlan {
    std::string device;
    std::vector<std::size_t> places;  ///< of a row
    std::vector<std::string> joints;  ///< their names; empty: a pose
  };

  static constexpr std::size_t kNoSignal = std::numeric_limits<std::size_t>::max();

  /// A name that no packet has, until it has a value: then it is left out.
  struct Unused {
    std::size_t place = 0;
    std::string_view reason;
    Severity severity = Severity::warning;
  };

  void makePlans();
  void findPlainPose(std::vector<bool>& is_placed);
  void findHomes(std::string_view topic, std::span<const std::string_view> names,
                 std::span<const std::size_t> places);
  void addJoint(const std::string& device, const std::string& joint, std::size_t place);
  void addPose(const std::string& device, std::size_t part, std::size_t place);
  bool isSignalOf(std::string_view device, std::string_view name) const;
  std::string_view placeSignal(NamedSignal signal, std::size_t place);
  void addSignal(NamedSignal signal, std::size_t place);
  std::size_t signalOfWord(std::size_t place);
  std::string deviceOfPlain(std::string_view topic) const;
  void saySignals(std::span<const double> row, std::span<const Word> words);
  void nameUnused(std::span<const double> numbers);
  void noteStated(Nanoseconds time, std::span<const double> numbers, std::span<const Word> words);
  bool sayPose(const DevicePlan& plan, std::span<const double> row);
  void sayJoints(const DevicePlan& plan, std::span<const double> row);

  std::string topic_, source_;
  PacketTextWriter packet_;
  std::vector<std::string_view> stated_names_;
  std::vector<double> stated_numbers_;
  std::set<std::string, std::less<>> with_joints_;  ///< devices of which some name is a joint
  std::vector<SignalKind> stated_kinds_;
  const ros::DeviceFinder* devices_ = nullptr;
  const ros::DeviceFinder nobody_{nullptr, {}};
  std::vector<std::string> names_;
  std::vector<DevicePlan> plans_;
  std::vector<Unused> unused_;
  std::vector<NamedSignal> signals_;
  std::vector<std::size_t> signal_at_;  ///< by place, into `signals_`
  std::vector<std::size_t> word_at_;    ///< the same, of names whose numbers are no signal
  std::set<std::pair<std::string, std::string>> seen_;  ///< devices and joints of the plans
  std::string kind_;
  std::set<std::string, std::less<>> named_;  ///< in the account
  Account account_;
  OverwrittenRows overwritten_;
  std::vector<std::size_t> followed_;  ///< by place: the name's number; kNoName: no packet says it
  std::size_t line_ = 0;
};

}  // namespace rocinante
