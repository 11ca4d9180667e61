#include "core/foreign/recordings/row_translation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/foreign/ros/names.h"
#include "core/foreign/table/table_column.h"
#include "core/packet/packet_limits.h"

namespace rocinante {
namespace {

using Fate = ros::DeviceFinder::Fate;

constexpr std::size_t kNoPlace = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kMaxNamed = 1024;
constexpr std::string_view kNoDevice = "a joint of no device; `log import --device` names one";
constexpr std::string_view kManyDevices = "a joint of several devices; DEVICE.JOINT names one";
constexpr std::string_view kPassive = "a fixed or mimic joint";
constexpr std::string_view kPartOfPose = "a pose needs all seven components";
constexpr std::string_view kTwice = "said twice: the first of them counts";
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
  said_.clear();
  unused_.clear();
  const ros::DeviceFinder& devices = devices_ != nullptr ? *devices_ : nobody_;
  const auto isDevice = [&](std::string_view name) {
    return !devices.knowsDevices() || devices.deviceOfTopic(name) == name;
  };
  std::vector<bool> is_placed(names_.size());
  findPlainPose(is_placed);
  // Names without a device, or with one that the cell does not have: their joints tell. By the
  // topic that they come from.
  std::map<std::string, std::pair<std::vector<std::string_view>, std::vector<std::size_t>>> plain;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (is_placed[i]) continue;
    const std::string_view reason = notAValue(names_[i]);
    const auto column = tableColumn(names_[i]);
    if (!reason.empty()) {
      unused_.push_back({i, reason, Severity::note});
    } else if (column && column->pose_part && isName(column->device)) {
      addPose(std::string(column->device), *column->pose_part, i);
    } else if (column && !column->topic.empty()) {
      auto& [names, places] = plain[std::string(column->topic)];
      names.push_back(column->joint);
      places.push_back(i);
    } else if (column && !column->pose_part && isDevice(column->device)) {
      addJoint(std::string(column->device), std::string(column->joint), i);
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
  for (std::size_t i = 0; i < homes.size(); ++i) {
    switch (homes[i].fate) {
      case Fate::said:
        addJoint(homes[i].device, homes[i].name, places[i]);
        break;
      case Fate::ambiguous:
        unused_.push_back({places[i], kManyDevices, Severity::warning});
        break;
      case Fate::passive:
        unused_.push_back({places[i], kPassive, Severity::note});
        break;
      case Fate::unknown:
        // As written, so that `check` can name the device that the cell lacks.
        const auto column = tableColumn(names[i]);
        if (column && !column->pose_part && !column->device.empty()) {
          addJoint(std::string(column->device), std::string(column->joint), places[i]);
        } else {
          unused_.push_back({places[i], kNoDevice, Severity::warning});
        }
    }
  }
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

void RowTranslation::addJoint(const std::string& device, const std::string& joint,
                              std::size_t place) {
  if (!isName(device) || !isName(joint)) {
    unused_.push_back({place, kNoName, Severity::warning});
    return;
  }
  if (!said_.emplace(device, joint).second) {
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
  said_names_.clear();
  said_numbers_.clear();
  for (std::size_t i = 0; i < plan.places.size(); ++i) {
    const double number = row[plan.places[i]];
    if (!std::isfinite(number)) continue;
    said_names_.push_back(plan.joints[i]);
    said_numbers_.push_back(number);
  }
  if (said_names_.empty()) return;
  Statement statement;
  statement.kind = StatementKind::joint;
  statement.name = plan.device;
  statement.names = said_names_;
  statement.numbers = said_numbers_;
  packet_.add(statement);
}

bool RowTranslation::sayPose(const DevicePlan& plan, std::span<const double> row) {
  said_numbers_.clear();
  for (const std::size_t place : plan.places) {
    if (std::isfinite(row[place])) said_numbers_.push_back(row[place]);
  }
  if (said_numbers_.empty()) return true;
  if (said_numbers_.size() < plan.places.size()) return false;
  Statement statement;
  statement.kind = StatementKind::pose;
  statement.name = plan.device;
  statement.numbers = said_numbers_;
  packet_.add(statement);
  return true;
}

RowTranslation::Outcome RowTranslation::translate(Nanoseconds time,
                                                  std::span<const double> numbers) {
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
  if (!packet_.hasStatements()) return {};
  return {packet_.text(), false};
}

}  // namespace rocinante
