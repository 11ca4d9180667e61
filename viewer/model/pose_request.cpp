#include "viewer/model/pose_request.h"

#include <fmt/format.h>

#include "core/base/plain_text.h"
#include "core/cli/opened_session.h"
#include "core/cli/text_table.h"
#include "core/kinematics/joint_values.h"
#include "core/math/trigonometry.h"
#include "core/session/moment_name.h"
#include "core/session/timeline.h"

namespace rocinante {
namespace {

Error refused(std::string what) { return {ErrorKind::bad_argument, std::move(what), ""}; }

Result<std::vector<double>> requestedValues(const Model& model, const PoseRequest& request) {
  std::vector<double> values = *request.joints;
  if (Status fits = checkValueCount(model, values.size()); !fits) return fits.error();
  if (!request.degrees) return values;
  std::size_t next = 0;
  for (const std::size_t joint : model.movableJoints()) {
    for (std::size_t i = 0; i < valueCount(model.joints[joint].type); ++i, ++next) {
      if (kindOf(model.joints[joint], i) == ValueKind::angle)
        values[next] = radiansOf(values[next]);
    }
  }
  return values;
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

Result<SessionState> sessionState(const Cell& cell, const PoseRequest& request,
                                  StateDamage* damage) {
  if (request.log.empty()) return SessionState{};
  // What another program recorded is of the cell's devices. One inside a log is no file.
  std::error_code none;
  const bool is_file = std::filesystem::is_regular_file(cell.file, none);
  const auto opened = cli::openSession(
      request.log, is_file ? std::filesystem::path(cell.file) : std::filesystem::path());
  if (!opened) return opened.error();
  cli::warnOfAccount(opened->log, &cell);
  Result<Timeline> session = Timeline::open(opened->log);
  if (!session) return session.error();
  const auto moment = request.at.empty() ? momentOfEvent(request.event, *session)
                                         : parseMoment(request.at, *session);
  if (!moment) return moment.error();
  if (*moment < session->start() || *moment > session->end()) {
    return refused(fmt::format("the session does not include `{}`",
                               plainText(request.at.empty() ? request.event : request.at)));
  }
  const auto state = session->stateAt(*moment, damage);
  if (!state) return state.error();
  return **state;
}

}  // namespace

Result<SessionState> posedState(const Cell& cell, const PoseRequest& request, StateDamage* damage) {
  Result<SessionState> state = sessionState(cell, request, damage);
  if (!state) return state.error();
  const bool is_stated = request.joints || !request.named.empty() || request.base;
  if (!is_stated && request.device.empty()) return state;
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
    Result<std::vector<double>> given = requestedValues(*posed->model, request);
    if (!given) return given.error();
    values = std::move(*given);
    say(StatementKind::joints).numbers = values;
  }
  std::vector<std::string_view> names;
  std::vector<double> named;
  for (const auto& [name, value] : request.named) {
    const auto found = drivenValue(*posed->model, name);
    if (!found) return found.error();
    names.emplace_back(name);
    const bool turns =
        kindOf(posed->model->joints[found->joint], found->component) == ValueKind::angle;
    named.push_back(request.degrees && turns ? radiansOf(value) : value);
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

}  // namespace rocinante
