#include "core/foreign/recordings/row_translation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/foreign/ros/names.h"
#include "core/foreign/table/table_column.h"
#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

using Fate = ros::DeviceFinder::Fate;

constexpr std::size_t kNoPlace = std::numeric_limits<std::size_t>::max();
constexpr std::string_view kNoDevice = "rows with joints of no device; --device names one";
constexpr std::string_view kManyDevices =
    "rows with joints of several devices; DEVICE.JOINT names one";
constexpr std::string_view kPartOfPose = "rows with a part of a pose";

}  // namespace

RowTranslation::RowTranslation(std::string topic, std::string_view decoder)
    : topic_(std::move(topic)) {
  first_words_ = "RK1 " + encodeName(ros::sourceOf(topic_, decoder)) + " - ";
}

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
  left_out_.clear();
  const ros::DeviceFinder& devices = devices_ != nullptr ? *devices_ : nobody_;
  const auto isDevice = [&](std::string_view name) {
    return !devices.knowsDevices() || devices.deviceOfTopic(name) == name;
  };
  // Names without a device, or with one that the cell does not have: their joints tell.
  std::vector<std::string_view> plain;
  std::vector<std::size_t> plain_places;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto column = tableColumn(names_[i]);
    if (column && column->pose_part && ros::isName(column->device)) {
      addPose(std::string(column->device), *column->pose_part, i);
    } else if (column && !column->pose_part && isDevice(column->device)) {
      addJoint(std::string(column->device), std::string(column->joint), i);
    } else {
      plain.push_back(names_[i]);
      plain_places.push_back(i);
    }
  }
  const auto homes = devices.homesOf(topic_, plain);
  const auto leaveOut = [&](std::string_view sentence) {
    if (std::ranges::find(left_out_, sentence) == left_out_.end()) {
      left_out_.emplace_back(sentence);
    }
  };
  for (std::size_t i = 0; i < homes.size(); ++i) {
    if (homes[i].fate == Fate::said) {
      addJoint(homes[i].device, homes[i].name, plain_places[i]);
    } else if (homes[i].fate == Fate::ambiguous) {
      leaveOut(kManyDevices);
    } else if (homes[i].fate == Fate::unknown) {
      // As written, so that `check` can name the device that the cell lacks.
      const auto column = tableColumn(plain[i]);
      if (column && !column->pose_part) {
        addJoint(std::string(column->device), std::string(column->joint), plain_places[i]);
      } else {
        leaveOut(kNoDevice);
      }
    }
  }
  for (const DevicePlan& plan : plans_) {
    if (std::ranges::find(plan.places, kNoPlace) != plan.places.end()) leaveOut(kPartOfPose);
  }
  std::erase_if(plans_, [](const DevicePlan& plan) {
    return std::ranges::find(plan.places, kNoPlace) != plan.places.end();
  });
}

void RowTranslation::addJoint(const std::string& device, const std::string& joint,
                              std::size_t place) {
  if (!ros::isName(device) || !ros::isName(joint)) return;
  const std::string first_words = "joint " + encodeName(device);
  DevicePlan* plan = nullptr;
  for (DevicePlan& each : plans_) {
    if (each.first_words == first_words && each.places.size() < limits::kJointValues) plan = &each;
  }
  if (plan == nullptr) {
    plan = &plans_.emplace_back();
    plan->first_words = first_words;
  }
  plan->places.push_back(place);
  plan->prefixes.push_back(" " + encodeName(joint) + "=");
}

void RowTranslation::addPose(const std::string& device, std::size_t part, std::size_t place) {
  const std::string first_words = "pose " + encodeName(device);
  DevicePlan* plan = nullptr;
  for (DevicePlan& each : plans_) {
    if (each.first_words == first_words) plan = &each;
  }
  if (plan == nullptr) {
    plan = &plans_.emplace_back();
    plan->first_words = first_words;
    plan->places.assign(kPoseEndings.size(), kNoPlace);
  }
  plan->places[part] = place;
}

void RowTranslation::note(std::string_view sentence) {
  const auto found = notes_.find(sentence);
  if (found != notes_.end()) {
    ++found->second;
  } else {
    notes_.emplace(sentence, 1);
  }
}

void RowTranslation::sayJoints(const DevicePlan& plan, std::span<const double> numbers) {
  const std::size_t before = text_.size();
  text_ += plan.first_words;
  const std::size_t empty = text_.size();
  for (std::size_t i = 0; i < plan.places.size(); ++i) {
    const double number = numbers[plan.places[i]];
    if (!std::isfinite(number)) continue;
    text_ += plan.prefixes[i];
    appendNumber(text_, number);
  }
  if (text_.size() == empty) {
    text_.resize(before);
  } else {
    text_ += '\n';
  }
}

bool RowTranslation::sayPose(const DevicePlan& plan, std::span<const double> numbers) {
  const auto said = static_cast<std::size_t>(std::ranges::count_if(
      plan.places, [&](std::size_t place) { return std::isfinite(numbers[place]); }));
  if (said == 0) return true;
  if (said < plan.places.size()) return false;
  text_ += plan.first_words;
  for (const std::size_t place : plan.places) {
    text_ += ' ';
    appendNumber(text_, numbers[place]);
  }
  text_ += '\n';
  return true;
}

RowTranslation::Outcome RowTranslation::translate(Nanoseconds time,
                                                  std::span<const double> numbers) {
  for (const std::string& sentence : left_out_) note(sentence);
  text_ = first_words_;
  if (time.count() < 0) {
    text_ += '-';
  } else {
    appendSeconds(text_, time.count());
  }
  text_ += '\n';
  const std::size_t header_bytes = text_.size();
  for (const DevicePlan& plan : plans_) {
    if (!plan.prefixes.empty()) {
      sayJoints(plan, numbers);
    } else if (!sayPose(plan, numbers)) {
      return {{}, true};
    }
  }
  if (text_.size() == header_bytes) return {};
  return {text_, false};
}

}  // namespace rocinante
