#include "viewer/model/pose_request.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/name_hint.h"
#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "core/math/trigonometry.h"
#include "core/session/timeline.h"

namespace rocinante {
namespace {

Error refused(std::string what) { return {ErrorKind::bad_argument, std::move(what), ""}; }

// The names of the values of a positional `joints`, in order.
std::vector<std::string> valueNames(const Model& model) {
  std::vector<std::string> names;
  for (const std::size_t i : model.movableJoints()) {
    const Joint& joint = model.joints[i];
    const std::string name = plainText(joint.name);
    if (joint.type == JointType::planar) {
      for (const char* part : {".x", ".y", ".yaw"}) names.push_back(name + part);
    } else if (joint.type == JointType::floating) {
      for (const char* part : {".x", ".y", ".z", ".qx", ".qy", ".qz", ".qw"}) {
        names.push_back(name + part);
      }
    } else {
      names.push_back(name);
    }
  }
  return names;
}

bool turns(const Model& model, const JointValue& value) {
  switch (model.joints[value.joint].type) {
    case JointType::revolute:
    case JointType::continuous:
      return true;
    case JointType::planar:
      return value.component == 2;
    default:
      return false;
  }
}

Result<std::vector<double>> positionalValues(const Model& model, const PoseRequest& request) {
  std::vector<double> values = *request.joints;
  if (values.size() != model.positionalCount()) {
    const std::vector<std::string> names = valueNames(model);
    std::string what = fmt::format("{}, but the model takes {}",
                                   cli::counted(values.size(), "joint value"), names.size());
    if (!names.empty() && names.size() <= 32) what += fmt::format(": {}", fmt::join(names, " "));
    return refused(std::move(what));
  }
  if (!request.degrees) return values;
  std::size_t next = 0;
  for (const std::size_t joint : model.movableJoints()) {
    for (std::size_t i = 0; i < valueCount(model.joints[joint].type); ++i, ++next) {
      if (turns(model, {joint, i})) values[next] = radiansOf(values[next]);
    }
  }
  return values;
}

Error unknownJoint(const Model& model, const std::string& name) {
  if (const auto joint = model.findJoint(name)) {
    const Joint& found = model.joints[*joint];
    if (found.mimic) {
      return refused(fmt::format("joint `{}` mimics `{}` and cannot have its own value",
                                 plainText(name),
                                 plainText(model.joints[found.mimic->joint].name)));
    }
    if (found.type == JointType::fixed) {
      return refused(fmt::format("joint `{}` is fixed", plainText(name)));
    }
    return refused(fmt::format("joint `{0}` is {1}: its values are `{0}.x` and so on",
                               plainText(name), nameOf(found.type)));
  }
  const std::vector<std::string> names = valueNames(model);
  const std::string hint = didYouMean(name, {names.begin(), names.end()});
  return refused(fmt::format("the model has no joint `{}`{}{}", plainText(name),
                             hint.empty() ? "" : "; ", hint));
}

// The device that receives the values, and its model.
struct Posed {
  const CellDevice* device = nullptr;
  const Model* model = nullptr;
};

Result<Posed> posedDevice(const Cell& cell, const std::string& name) {
  if (name.empty() && cell.devices.size() != 1) {
    return refused(fmt::format("the cell has {}: choose one with --device",
                               cli::counted(cell.devices.size(), "device")));
  }
  const CellDevice* device = name.empty() ? &cell.devices.front() : cell.findDevice(name);
  if (device == nullptr) {
    return refused(fmt::format("the cell has no device `{}`", plainText(name)));
  }
  const Model* model = cell.modelOf(*device);
  if (model == nullptr) {
    return refused(
        fmt::format("the model of device `{}` could not be read", plainText(device->name)));
  }
  return Posed{device, model};
}

Result<SessionState> sessionState(const PoseRequest& request, StateDamage* damage) {
  if (request.log.empty()) return SessionState{};
  Result<Timeline> session = Timeline::open(request.log);
  if (!session) return session.error();
  const auto moment = parseSessionTime(request.at, session->origin(), session->end());
  if (!moment) return moment.error();
  if (*moment < session->start() || *moment > session->end()) {
    return refused(fmt::format("the session does not include `{}`", plainText(request.at)));
  }
  const auto state = session->stateAt(*moment, damage);
  if (!state) return state.error();
  return **state;
}

}  // namespace

Result<SessionState> posedState(const Cell& cell, const PoseRequest& request, StateDamage* damage) {
  Result<SessionState> state = sessionState(request, damage);
  if (!state) return state.error();
  const bool says = request.joints || !request.named.empty() || request.base;
  if (!says && request.device.empty()) return state;
  const Result<Posed> posed = posedDevice(cell, request.device);
  if (!posed) return posed.error();

  std::vector<Statement> statements;
  const auto say = [&](StatementKind kind) -> Statement& {
    Statement& statement = statements.emplace_back();
    statement.kind = kind;
    statement.name = posed->device->name;
    return statement;
  };
  // A requested device is added, even if it waits for `add`.
  if (posed->device->optional && request.log.empty()) {
    say(StatementKind::add).text = posed->device->model;
  }
  std::vector<double> base, values;
  if (request.base) {
    const Pose& pose = *request.base;
    base = {pose.position.x,    pose.position.y,    pose.position.z,   pose.orientation.x,
            pose.orientation.y, pose.orientation.z, pose.orientation.w};
    say(StatementKind::pose).numbers = base;
  }
  if (request.joints) {
    Result<std::vector<double>> given = positionalValues(*posed->model, request);
    if (!given) return given.error();
    values = std::move(*given);
    say(StatementKind::joints).numbers = values;
  }
  std::vector<std::string_view> names;
  std::vector<double> named;
  for (const auto& [name, value] : request.named) {
    const auto found = posed->model->findJointValue(name);
    if (!found) return unknownJoint(*posed->model, name);
    names.emplace_back(name);
    named.push_back(request.degrees && turns(*posed->model, *found) ? radiansOf(value) : value);
  }
  if (!names.empty()) {
    Statement& statement = say(StatementKind::joint);
    statement.names = names;
    statement.numbers = named;
  }
  Packet packet;
  packet.header.source = "rocinante-model";
  packet.statements = statements;
  // After everything that a log may contain.
  state->apply(LogTime::max() - std::chrono::hours(1), packet);
  return state;
}

Result<std::vector<double>> parseNumbers(std::string_view text) {
  std::vector<double> numbers;
  constexpr std::string_view kBetween = " \t,";
  for (std::size_t at = text.find_first_not_of(kBetween); at != std::string_view::npos;
       at = text.find_first_not_of(kBetween, at)) {
    const std::size_t end = std::min(text.find_first_of(kBetween, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const std::string_view digits = word.substr(word.front() == '+' ? 1 : 0);
    double value = 0;
    const auto [stop, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (fault != std::errc() || stop != digits.data() + digits.size() || !std::isfinite(value)) {
      return refused(fmt::format("`{}` is not a number", plainText(word)));
    }
    numbers.push_back(value);
    at = end;
  }
  return numbers;
}

}  // namespace rocinante
