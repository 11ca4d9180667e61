#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/check/tally.h"
#include "core/model/model.h"
#include "core/packet/packet.h"

namespace rocinante {

/// Judges what a session says about one device against its model. Findings come at the end, when
/// it is known whether the device ever appeared.
class DeviceJudge {
 public:
  explicit DeviceJudge(std::string name) : name_(std::move(name)) {}

  /// The cell has it. `optional`: it waits for `add`, and nobody need drive it.
  void appearInCell(const Model* model, bool optional);
  /// `add` brought it; null when the cell knows no such model.
  void appearByAdd(const Model* model, const Statement& add, const Place& place);

  /// Any statement that names the device.
  void mention(const Place& place) { mentioned_.hit(place); }
  void judgeLink(std::string_view link, const Place& place);
  /// By the names of the order that this source last gave, when `ordered` says that the state
  /// still holds one; else positional.
  void judgeJoints(std::span<const double> values, bool ordered, std::uint32_t source,
                   const Place& place);
  void judgeNamed(std::span<const std::string_view> names, std::span<const double> values,
                  std::uint32_t source, const Place& place);
  void judgeOrder(std::span<const std::string_view> names, std::uint32_t source,
                  const Place& place);
  void judgePose(std::uint32_t source, const Place& place);

  /// `sources`: names by number.
  void report(const std::vector<std::string>& sources, std::vector<Finding>& findings) const;

 private:
  static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kNoValue = std::numeric_limits<std::size_t>::max();

  /// One value of the model's movable joints, in the order of positional `joints`.
  struct Value {
    std::string name;
    const char* unit = "";
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    std::uint32_t writer = kNobody;
    Tally beyond;
    double worst = 0, worst_excess = 0;
    LogTime worst_at{};
  };
  /// What `joints` of each source mean: numbers in `values_`, kNoValue for a name that is none.
  struct Order {
    std::vector<std::string> names;
    std::vector<std::size_t> values;
  };
  struct TwoSources {
    Tally tally;
    std::uint32_t before = 0, now = 0;
  };

  void useModel(const Model* model);
  void listValues(const Model& model);
  void judgePositional(std::span<const double> values, std::uint32_t source, const Place& place);
  void resolve(Order& order) const;
  void judgeValue(std::size_t value, double number, std::uint32_t source, const Place& place);
  void noteWriter(std::uint32_t& writer, std::uint32_t source, TwoSources& two, const Place& place);
  /// Number of the value in `values_`; kNoValue, with the fault counted, when there is none.
  std::size_t valueNamed(std::string_view value_name, const Place& place);

  std::string name_;
  bool in_cell_ = false, optional_ = false, added_ = false, driven_ = false;
  const Model* model_ = nullptr;
  std::vector<Value> values_;
  std::map<std::string, std::size_t, std::less<>> value_by_name_;
  std::map<std::uint32_t, Order> orders_;
  std::uint32_t pose_writer_ = kNobody;

  Tally mentioned_, unknown_model_, other_kinematics_, joint_count_;
  std::string unknown_model_name_, joint_count_text_;
  std::map<std::string, Tally, std::less<>> unknown_links_, unknown_joints_, undrivable_joints_;
  TwoSources two_drivers_, two_posers_;
};

}  // namespace rocinante
