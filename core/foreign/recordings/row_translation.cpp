#include "core/foreign/recordings/row_translation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/foreign/ros/names.h"
#include "core/foreign/table/table_column.h"
#include "core/foreign/table/table_fields.h"
#include "core/packet/packet_limits.h"

namespace rocinante {
namespace {

using JointMatch = ros::DeviceFinder::JointMatch;

constexpr std::size_t kNoPlace = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kMaxNamed = 1024;
constexpr std::string_view kManyDevices = "a joint of several devices; DEVICE.JOINT names one";
constexpr std::string_view kPassive = "a fixed or mimic joint";
constexpr std::string_view kPartOfPose = "a pose needs all seven components";
constexpr std::string_view kTwice = "stated twice: the first of them counts";
constexpr std::string_view kNoName = "packets have no such name";

}  // namespace

RowTranslation::RowTranslation(std::string topic, std::string_view decoder, std::string kind)
    : topic_(std::move(topic)), source_(ros::sourceOf(topic_, decoder)), kind_(std::move(kind)) {}

void RowTranslation::setNames(std::span<const std::string_view> names) {
  if (std::ranges::equal(names, names_)) return;
  names_.assign(names.begin(), names.end());
  makePlans();
}

void RowTranslation::setNames(std::span<const std::string> names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  setNames(views);
}

void RowTranslation::makePlans() {
  plans_.clear();
  seen_.clear();
  unused_.clear();
  signals_.clear();
  signal_at_.assign(names_.size(), kNoSignal);
  word_at_.assign(names_.size(), kNoSignal);
  const ros::DeviceFinder& devices = devices_ != nullptr ? *devices_ : nobody_;
  const auto isDevice = [&](std::string_view name) {
    return !devices.knowsDevices() || devices.deviceOfTopic(name) == name;
  };
  std::vector<bool> is_placed(names_.size());
  findPlainPose(is_placed);
  with_joints_.clear();
  for (const std::string& name : names_) {
    const auto column = tableColumn(name);
    if (column && devices.hasJoint(column->device, column->joint)) {
      with_joints_.emplace(column->device);
    }
  }
  // Names without a device, or with one that the cell does not have: their joints tell. By the
  // topic that they come from.
  std::map<std::string, std::pair<std::vector<std::string_view>, std::vector<std::size_t>>> plain;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (is_placed[i]) continue;
    const std::string_view reason = notAValue(names_[i]);
    const auto column = tableColumn(names_[i]);
    if (!reason.empty()) {
      unused_.push_back({i, reason, Severity::note});
    } else if (isSignalColumn(names_[i])) {
      auto signal = signalNamed(names_[i]);
      signal ? addSignal(std::move(*signal), i) : unused_.push_back({i, kNoName});
    } else if (column && column->pose_part && isName(column->device)) {
      addPose(std::string(column->device), *column->pose_part, i);
    } else if (column && !column->topic.empty()) {
      auto& [names, places] = plain[std::string(column->topic)];
      names.push_back(column->joint);
      places.push_back(i);
    } else if (column && !column->pose_part && isDevice(column->device)) {
      if (isSignalOf(column->device, column->joint)) {
        addSignal({std::string(column->device), {"", std::string(column->joint)}}, i);
      } else {
        addJoint(std::string(column->device), std::string(column->joint), i);
      }
    } else {
      auto& [names, places] = plain[topic_];
      names.push_back(names_[i]);
      places.push_back(i);
    }
  }
  for (const auto& [topic, named] : plain) findHomes(topic, named.first, named.second);
  const auto is_part = [](const DevicePlan& plan) {
    return std::ranges::find(plan.places, kNoPlace) != plan.places.end();
  };
  for (const DevicePlan& plan : plans_) {
    if (!is_part(plan)) continue;
    for (const std::size_t place : plan.places) {
      if (place != kNoPlace) unused_.push_back({place, kPartOfPose, Severity::warning});
    }
  }
  std::erase_if(plans_, is_part);
  followed_.clear();
  for (const std::string& name : names_) followed_.push_back(overwritten_.numberOf(name));
  for (const Unused& each : unused_) followed_[each.place] = OverwrittenRows::kNoName;
}

/// A pose without a device, as TUM writes it.
void RowTranslation::findPlainPose(std::vector<bool>& is_placed) {
  std::array<std::size_t, kPoseEndings.size()> places{};
  places.fill(kNoPlace);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (const auto part = plainPosePart(names_[i])) places[*part] = i;
  }
  if (std::ranges::find(places, kNoPlace) != places.end()) return;
  const ros::DeviceFinder& devices = devices_ != nullptr ? *devices_ : nobody_;
  const std::optional<std::string> only = devices.onlyDevice();
  std::string device = devices.fallback();
  if (device.empty() && only) device = *only;
  if (device.empty() && !devices.knowsDevices()) device = devices.madeUpDevice(topic_, "robot");
  for (std::size_t part = 0; part < places.size(); ++part) {
    is_placed[places[part]] = true;
    if (device.empty()) {
      unused_.push_back({places[part], "a pose of no device; `log import --device` names one",
                         Severity::warning});
    } else {
      addPose(device, part, places[part]);
    }
  }
}

void RowTranslation::findHomes(std::string_view topic, std::span<const std::string_view> names,
                               std::span<const std::size_t> places) {
  const ros::DeviceFinder& devices = devices_ != nullptr ? *devices_ : nobody_;
  const auto homes = devices.homesOf(topic, names);
  for (const auto& home : homes) {
    if (devices.hasJoint(home.device, home.name)) with_joints_.insert(home.device);
  }
  for (std::size_t i = 0; i < homes.size(); ++i) {
    const auto column = tableColumn(names_[places[i]]);
    const std::string quantity(column ? column->quantity : "");
    switch (homes[i].match) {
      case JointMatch::driven:
        if (isSignalOf(homes[i].device, homes[i].name)) {
          addSignal({deviceOfPlain(topic), {"", homes[i].name + quantity}}, places[i]);
        } else if (!quantity.empty()) {
          addSignal({homes[i].device, {"", homes[i].name + quantity}}, places[i]);
        } else {
          addJoint(homes[i].device, homes[i].name, places[i]);
        }
        break;
      case JointMatch::ambiguous:
        unused_.push_back({places[i], kManyDevices, Severity::warning});
        break;
      case JointMatch::passive:
        unused_.push_back({places[i], kPassive, Severity::note});
        break;
      case JointMatch::unknown:
        // As written, so that `check` can name the device that the cell lacks.
        if (column && !column->pose_part && !column->device.empty()) {
          addJoint(std::string(column->device), std::string(column->joint), places[i]);
        } else {
          addSignal({deviceOfPlain(topic), {"", std::string(names[i]) + quantity}}, places[i]);
        }
    }
  }
}

/// Where no name is a joint of the device, all may be misspelled: they stay joints, and `check`
/// names them.
bool RowTranslation::isSignalOf(std::string_view device, std::string_view name) const {
  return devices_ != nullptr && devices_->lacksJoint(device, name) && with_joints_.contains(device);
}

/// Of a name that is no joint and names none; empty: of no device.
std::string RowTranslation::deviceOfPlain(std::string_view topic) const {
  if (devices_ == nullptr) return {};
  if (!devices_->fallback().empty()) return devices_->fallback();
  if (const auto only = devices_->onlyDevice()) return *only;
  return devices_->deviceOfTopic(topic).value_or("");
}

/// Why not; empty: it is said.
std::string_view RowTranslation::placeSignal(NamedSignal signal, std::size_t place) {
  if (!isName(signal.name.name)) return kNoName;
  if (!seen_.emplace("signal", signalNameText(signal.device, signal.name)).second) return kTwice;
  signal_at_[place] = signals_.size();
  signals_.push_back(std::move(signal));
  return {};
}

void RowTranslation::addSignal(NamedSignal signal, std::size_t place) {
  const std::string_view refused = placeSignal(std::move(signal), place);
  if (!refused.empty()) unused_.push_back({place, refused});
}

/// What a text or a truth is that stands where a joint or nothing was expected.
std::size_t RowTranslation::signalOfWord(std::size_t place) {
  if (isSignal(place)) return signal_at_[place];
  if (word_at_[place] != kNoSignal) return word_at_[place];
  const auto column = tableColumn(names_[place]);
  const bool is_of_device = column && !column->pose_part && !column->device.empty() &&
                            isName(column->device) &&
                            (devices_ == nullptr || !devices_->knowsDevices() ||
                             devices_->deviceOfTopic(column->device) == column->device);
  NamedSignal signal{deviceOfPlain(topic_), {"", names_[place]}};
  if (is_of_device) signal = {std::string(column->device), {"", std::string(column->joint)}};
  const std::string_view refused = placeSignal(std::move(signal), place);
  if (!refused.empty()) leaveOut(names_[place], refused, Severity::warning);
  std::swap(word_at_[place], signal_at_[place]);
  return word_at_[place];
}

void RowTranslation::leaveOut(std::string_view name, std::string_view reason, Severity severity) {
  if (named_.contains(name)) return;
  // Beyond these an account only counts, and a hostile file has any number.
  if (named_.size() < kMaxNamed) named_.emplace(name);
  account_.leaveOut({.kind = kind_,
                     .name = std::string(name),
                     .reason = std::string(reason),
                     .severity = severity});
}

void RowTranslation::nameUnused(std::span<const double> numbers) {
  std::erase_if(unused_, [&](const Unused& each) {
    if (std::isnan(numbers[each.place])) return false;
    leaveOut(names_[each.place], each.reason, each.severity);
    return true;
  });
}

void RowTranslation::noteStated(Nanoseconds time, std::span<const double> numbers,
                                std::span<const Word> words) {
  for (std::size_t place = 0; place < numbers.size(); ++place) {
    if (std::isfinite(numbers[place])) overwritten_.state(followed_[place], time, line_);
  }
  for (const Word& word : words) overwritten_.state(followed_[word.place], time, line_);
}

void RowTranslation::addJoint(const std::string& device, const std::string& joint,
                              std::size_t place) {
  if (!isName(device) || !isName(joint)) {
    unused_.push_back({place, kNoName, Severity::warning});
    return;
  }
  if (!seen_.emplace(device, joint).second) {
    unused_.push_back({place, kTwice, Severity::warning});
    return;
  }
  DevicePlan* plan = nullptr;
  for (DevicePlan& each : plans_) {
    const bool has_room = !each.joints.empty() && each.joints.size() < limits::kJointValues;
    if (each.device == device && has_room) plan = &each;
  }
  if (plan == nullptr) {
    plan = &plans_.emplace_back();
    plan->device = device;
  }
  plan->places.push_back(place);
  plan->joints.push_back(joint);
}

void RowTranslation::addPose(const std::string& device, std::size_t part, std::size_t place) {
  DevicePlan* plan = nullptr;
  for (DevicePlan& each : plans_) {
    if (each.device == device && each.joints.empty()) plan = &each;
  }
  if (plan == nullptr) {
    plan = &plans_.emplace_back();
    plan->device = device;
    plan->places.assign(kPoseEndings.size(), kNoPlace);
  }
  if (plan->places[part] != kNoPlace) {
    unused_.push_back({place, kTwice, Severity::warning});
  } else {
    plan->places[part] = place;
  }
}

void RowTranslation::sayJoints(const DevicePlan& plan, std::span<const double> row) {
  stated_names_.clear();
  stated_numbers_.clear();
  for (std::size_t i = 0; i < plan.places.size(); ++i) {
    const double number = row[plan.places[i]];
    if (!std::isfinite(number)) continue;
    stated_names_.push_back(plan.joints[i]);
    stated_numbers_.push_back(number);
  }
  if (stated_names_.empty()) return;
  Statement statement;
  statement.kind = StatementKind::joint;
  statement.name = plan.device;
  statement.names = stated_names_;
  statement.numbers = stated_numbers_;
  packet_.add(statement);
}

bool RowTranslation::sayPose(const DevicePlan& plan, std::span<const double> row) {
  stated_numbers_.clear();
  for (const std::size_t place : plan.places) {
    if (std::isfinite(row[place])) stated_numbers_.push_back(row[place]);
  }
  if (stated_numbers_.empty()) return true;
  if (stated_numbers_.size() < plan.places.size()) return false;
  Statement statement;
  statement.kind = StatementKind::pose;
  statement.name = plan.device;
  statement.numbers = stated_numbers_;
  packet_.add(statement);
  return true;
}

/// One `signals` statement for neighbours of one device or link; a text has its own.
void RowTranslation::saySignals(std::span<const double> row, std::span<const Word> words) {
  const NamedSignal* last = nullptr;
  const auto flush = [&] {
    if (stated_names_.empty()) return;
    Statement statement;
    statement.kind = StatementKind::signals;
    statement.path = {last->device, last->name.link};
    statement.names = stated_names_;
    statement.numbers = stated_numbers_;
    statement.signal_kinds = stated_kinds_;
    packet_.add(statement);
    stated_names_.clear();
    stated_numbers_.clear();
    stated_kinds_.clear();
  };
  const auto say = [&](const NamedSignal& signal, SignalKind kind, double number) {
    const bool is_neighbour = last != nullptr && last->device == signal.device &&
                              last->name.link == signal.name.link &&
                              stated_names_.size() < limits::kSignalValues;
    if (!is_neighbour) flush();
    last = &signal;
    stated_names_.push_back(signal.name.name);
    stated_numbers_.push_back(number);
    stated_kinds_.push_back(kind);
  };
  stated_names_.clear();
  stated_numbers_.clear();
  stated_kinds_.clear();
  // A word may make a signal of its name.
  for (const Word& word : words) signalOfWord(word.place);
  for (std::size_t place = 0; place < row.size(); ++place) {
    if (isSignal(place) && std::isfinite(row[place])) {
      say(signals_[signal_at_[place]], SignalKind::number, row[place]);
    }
    if (words.empty() || words.front().place != place) continue;
    const SignalValue& value = words.front().value;
    words = words.subspan(1);
    const std::size_t at = signalOfWord(place);
    if (at == kNoSignal) continue;
    if (value.kind != SignalKind::text) {
      say(signals_[at], value.kind, value.number);
    } else if (!isSignalText(value.text)) {
      leaveOut(names_[place], kNoSignalText, Severity::warning);
    } else {
      const std::string_view name = signals_[at].name.name;
      constexpr SignalKind kText = SignalKind::text;
      constexpr double kNothing = 0;
      Statement statement;
      statement.kind = StatementKind::signal;
      statement.path = {signals_[at].device, signals_[at].name.link};
      statement.names = std::span(&name, 1);
      statement.numbers = std::span(&kNothing, 1);
      statement.signal_kinds = std::span(&kText, 1);
      statement.text = value.text;
      packet_.add(statement);
    }
  }
  flush();
}

RowTranslation::Outcome RowTranslation::translate(Nanoseconds time, std::span<const double> numbers,
                                                  std::span<const Word> words) {
  if (!unused_.empty()) nameUnused(numbers);
  PacketHeader header;
  header.source = source_;
  if (time.count() >= 0) header.time_ns = time.count();
  packet_.begin(header);
  for (const DevicePlan& plan : plans_) {
    if (!plan.joints.empty()) {
      sayJoints(plan, numbers);
    } else if (!sayPose(plan, numbers)) {
      return {{}, true};
    }
  }
  if (!signals_.empty() || !words.empty()) saySignals(numbers, words);
  if (!packet_.hasStatements()) return {};
  noteStated(time, numbers, words);
  return {packet_.text(), false};
}

}  // namespace rocinante
