#include "viewer/web/web_session.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/bundle/baked_file.h"
#include "core/math/transform.h"
#include "core/report/json_text.h"
#include "viewer/bake/bake_cell.h"
#include "viewer/model/link_poses.h"
#include "viewer/render/renderer.h"
#include "viewer/shown/joint_rows.h"
#include "viewer/shown/signal_rows.h"
#include "viewer/shown/value_text.h"
#include "viewer/view/camera_choice.h"
#include "viewer/view/inset_layout.h"
#include "viewer/web/web_context.h"

namespace rocinante {
namespace {

constexpr const char* kLogName = "the page's log";

std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Those that a window begins with.
constexpr Units kUnits{};

Json jointJson(const JointRow& row) {
  Json json;
  json["name"] = row.name;
  json["value"] = row.value;
  json["text"] = jointValueText(row.kind, row.value, kUnits);
  json["outside"] = row.outside();
  return json;
}

/// What is listed of a session that states more; the page says how many more there are.
constexpr std::size_t kMostOfDevice = 256;  // signals
constexpr std::size_t kMostSignals = 4096;  // of all devices
constexpr std::size_t kMostBare = 1024;     // devices that are not in the cell

/// At most `room` of them; returns how many.
std::size_t addSignals(Json& device, const std::string& name, const Signals& signals,
                       std::size_t room) {
  if (signals.empty()) return 0;
  Json& list = device["signals"] = Json::array();
  for (const SignalRow& row : signalRows(name, signals, "", std::min(room, kMostOfDevice))) {
    list.push_back({{"name", row.name},
                    {"text", row.text},
                    {"series", row.series.text()},
                    {"kind", nameOf(row.kind)},
                    {"owner", row.owner}});
  }
  device["unlisted"] = signals.size() - list.size();
  return list.size();
}

Result<Cell> cellOf(Bytes bytes) {
  const auto file = std::make_shared<const Bytes>(std::move(bytes));
  const auto baked = BakedFile::parse(*file, "the page's cell");
  if (!baked) return baked.error();
  return readBakedCell(*baked, file);
}

}  // namespace

Result<WebSession> WebSession::openLive(Bytes cell_bytes) {
  auto cell = cellOf(std::move(cell_bytes));
  if (!cell) return cell.error();
  auto context = makeWebContext();
  if (!context) return context.error();
  auto maker = FrameMaker::open(std::move(*cell), std::nullopt, Profile::fast, std::move(*context));
  if (!maker) return maker.error();
  WebSession session(WebLog(), std::move(*maker));
  session.live_ = std::make_unique<WebLive>();
  session.maker_.showState(&session.live_->state());
  return session;
}

Result<WebSession> WebSession::open(Bytes cell_bytes, WebLog log, std::size_t there) {
  auto cell = cellOf(std::move(cell_bytes));
  if (!cell) return cell.error();
  auto reader = LogReader::openBytes(log.first(there), kLogName);
  if (!reader) return reader.error();
  auto context = makeWebContext();
  if (!context) return context.error();
  auto maker = FrameMaker::open(std::move(*cell), Timeline::of(std::move(*reader)), Profile::fast,
                                std::move(*context));
  if (!maker) return maker.error();
  return WebSession(std::move(log), std::move(*maker));
}

Status WebSession::openWhole() {
  auto reader = LogReader::openBytes(log_.whole(), kLogName);
  if (!reader) return reader.error();
  maker_.showSession(Timeline::of(std::move(*reader)));
  warning_.clear();
  return {};
}

bool WebSession::isFitted() const {
  FrameRequest request;
  request.camera = camera_;
  request.insets.emplace();
  return !by_hand_ && maker_.asksFit(request);
}

LogTime WebSession::momentOf(std::int64_t ns) {
  if (live_) return live_->time();
  Timeline& session = *maker_.session();
  return std::clamp(session.origin() + Nanoseconds(ns), session.start(), session.end());
}

void WebSession::note(const StateDamage& damage) {
  warning_ = damage.empty() ? "" : damage.what() + " (" + damage.where() + ")";
}

Result<const SessionState*> WebSession::stateAt(std::int64_t ns) {
  if (live_) return &live_->state();
  StateDamage damage;
  auto state = maker_.session()->stateAt(momentOf(ns), &damage);
  note(damage);
  return state;
}

FrameRequest WebSession::requestAt(std::int64_t ns, int width, int height) {
  FrameRequest request;
  request.time = momentOf(ns);
  request.camera = by_hand_ ? viewpointText(by_hand_->view()) : camera_;
  request.width = width;
  request.height = height;
  request.insets = insets_;
  if (!selected_path_.empty()) request.style.outlined.push_back(selected_path_);
  return request;
}

std::string WebSession::aboutJson() {
  Json json;
  json["live"] = live_ != nullptr;
  if (Timeline* const session = maker_.session()) {
    json["start_ns"] = (session->start() - session->origin()).count();
    json["end_ns"] = (session->end() - session->origin()).count();
  } else {
    json["start_ns"] = json["end_ns"] = 0;
  }
  json["cameras"] = Json::array();
  for (const CellCamera& camera : maker_.cell().cameras) json["cameras"].push_back(camera.name);
  for (const char* built_in : {"fit", "map"}) json["cameras"].push_back(built_in);
  json["devices"] = Json::array();
  json["movable"] = Json::array();
  for (const CellDevice& device : maker_.cell().devices) {
    json["devices"].push_back(device.name);
    const Model* const model = maker_.cell().modelOf(device);
    if (model != nullptr && !jointRows(*model, nullptr, "").empty()) {
      json["movable"].push_back(device.name);
    }
  }
  json["warnings"] = maker_.warnings();
  return text(json);
}

std::string WebSession::eventsJson() {
  if (live_) return "[]";
  Timeline& session = *maker_.session();
  Json json = Json::array();
  StateDamage damage;
  const auto events = session.events(&damage);
  if (!events) return "[]";
  for (const Event& event : **events) {
    Json one;
    one["ns"] = (event.time - session.origin()).count();
    one["text"] = event.text;
    json.push_back(std::move(one));
  }
  return text(json);
}

Result<std::string> WebSession::devicesJson(std::int64_t ns) {
  const auto state = stateAt(ns);
  if (!state) return state.error();
  const PosedScene scene = poseScene(maker_.cell(), **state);
  Json json = Json::array();
  std::size_t room = kMostSignals;
  // Whose values are beside its curves is listed in any case.
  const auto isSelected = [&](const std::string& name) {
    return name == (selected_ ? selected_->path.first : std::string());
  };
  const auto addSignalsOf = [&](Json& one, const std::string& name, const Signals& signals) {
    if (isSelected(name)) {
      addSignals(one, name, signals, kMostOfDevice);
    } else {
      room -= addSignals(one, name, signals, room);
    }
  };
  for (const PosedDevice& device : scene.devices) {
    Json one;
    one["name"] = device.name;
    one["visible"] = device.visible;
    one["joints"] = Json::array();
    const DeviceState* const device_state = (*state)->findDevice(device.name);
    for (const JointRow& row : jointRows(*device.model, device_state, "")) {
      one["joints"].push_back(jointJson(row));
    }
    if (selected_ && selected_->path.first == device.name && !selected_->path.second.empty()) {
      const auto link = device.model->findLink(selected_->path.second);
      if (link) {
        const Vec3 position = positionOf(device.link_world[*link]);
        one["link"] = {{"name", selected_->path.second},
                       {"text", positionText(position, kUnits.length)}};
      }
    }
    if (device_state != nullptr) addSignalsOf(one, device.name, device_state->signals);
    json.push_back(std::move(one));
  }
  // A device that is not in the cell is listed by its signals.
  std::size_t bare = 0;
  const auto addBare = [&](const std::string& name, const Signals& signals) {
    if (signals.empty()) return;
    if (!name.empty() && !isSelected(name) && ++bare > kMostBare) return;
    Json one = {{"name", name}, {"visible", true}, {"joints", Json::array()}};
    addSignalsOf(one, name, signals);
    json.push_back(std::move(one));
  };
  for (const auto& [name, device_state] : (*state)->devices()) {
    if (scene.findDevice(name) == nullptr) addBare(name, device_state.signals);
  }
  if (bare > kMostBare) json.push_back(Json{{"more", bare - kMostBare}});
  addBare({}, (*state)->signals());
  return text(json);
}

Result<std::string> WebSession::posesJson(std::int64_t ns) {
  const auto state = stateAt(ns);
  if (!state) return state.error();
  return forwardKinematicsJson(linkPoses(maker_.cell(), **state));
}

Status WebSession::draw(std::int64_t ns, int width, int height, double scale, Care care) {
  FrameRequest request = requestAt(ns, width, height);
  if (care == Care::moving) request.detail = governor_.rung();
  if (care == Care::first) {
    // What a browser's renderer compiles for it is little.
    request.samples = 1;
    request.style.shading = Shading::plain;
    request.insets.emplace();
    request.hide = {"layer/grid", "layer/gnomon"};
  } else {
    maker_.finishPictures();
  }
  request.scale = std::clamp(scale, kLeastScale, kLargestScale);
  StateDamage damage;
  Status shown = maker_.show(request, &damage);
  note(damage);
  return shown;
}

bool WebSession::makeNextDetail() {
  if (maker_.makeNextDetail()) return true;
  governor_.forget();
  return false;
}

Result<std::string> WebSession::pickJson(std::int64_t ns, double x, double y, int width,
                                         int height) {
  maker_.finishPictures();
  StateDamage damage;
  const auto picked = maker_.pick(requestAt(ns, width, height), x, y, &damage);
  if (!picked) return picked.error();
  if (!*picked) return std::string("null");
  return text(Json{{"device", (*picked)->name.device}, {"link", (*picked)->name.link}});
}

Status WebSession::select(const std::string& path) {
  selected_.reset();
  selected_path_.clear();
  if (path.empty()) return {};
  auto parsed = parseViewPath(path);
  if (!parsed) return parsed.error();
  // In the cell, or in the session as it ends or stands now.
  const std::string& device = parsed->path.first;
  if (maker_.cell().findDevice(device) == nullptr) {
    Timeline* const session = maker_.session();
    const auto state = stateAt(session ? (session->end() - session->origin()).count() : 0);
    if (!state) return state.error();
    if ((*state)->findDevice(device) == nullptr) {
      return Error{ErrorKind::not_found, "there is no device '" + device + "' to select", {}};
    }
  }
  FrameRequest request = requestAt(0, 640, 480);
  request.style.outlined = {path};
  if (const auto known = maker_.camera(request); !known) return known.error();
  selected_ = std::move(*parsed);
  selected_path_ = path;
  return {};
}

Status WebSession::addInset(const std::string& text) {
  auto inset = parseInset(text);
  if (!inset) return inset.error();
  FrameRequest request = requestAt(0, 640, 480);
  request.camera = inset->camera;
  if (const auto known = maker_.camera(request); !known) return known.error();
  if (!insets_) insets_.emplace();
  insets_->push_back(*std::move(inset));
  return {};
}

Status WebSession::choosePlot(const std::string& name) {
  if (!parseSeriesKey(name)) {
    return Error{ErrorKind::bad_argument, notPlotted(name), {}};
  }
  if (std::ranges::find(chosen_, name) == chosen_.end()) chosen_.push_back(name);
  return {};
}

std::string WebSession::chosenJson(std::int64_t ns) {
  return plots_ ? plots_->chosenJson(momentOf(ns)) : "{}";
}

Result<double> WebSession::readPlots(std::uint64_t messages) {
  if (live_) return 1.0;  // what was is not kept
  if (!plots_) {
    auto reader = LogReader::openBytes(log_.whole(), kLogName);
    if (!reader) return reader.error();
    if (Status there = reader->rewind(); !there) return there.error();
    plots_.emplace(maker_.cell(), std::move(*reader), maker_.session()->start(),
                   maker_.session()->end(), chosen_);
  }
  return plots_->read(messages);
}

Result<std::string> WebSession::plotsJson(const std::string& device, std::int64_t ns,
                                          std::size_t width, double height) {
  const auto state = stateAt(ns);
  if (!state) return state.error();
  const PosedScene scene = poseScene(maker_.cell(), **state);
  if (!plots_) return std::string("{}");
  return plots_->lanesJson(device, scene.findDevice(device), **state, width, height);
}

Status WebSession::useCamera(const std::string& name) {
  FrameRequest request = requestAt(0, 640, 480);
  request.camera = name;
  if (name.starts_with('@')) {
    const auto view = parseViewpoint(name);
    if (!view) return view.error();
  } else if (const auto view = maker_.camera(request); !view) {
    return view.error();
  }
  camera_ = name;
  by_hand_.reset();
  return {};
}

Status WebSession::takeByHand(std::int64_t ns, int width, int height) {
  if (by_hand_) return {};
  const auto view = maker_.camera(requestAt(ns, width, height));
  if (!view) return view.error();
  by_hand_.emplace(*view);
  return {};
}

Status WebSession::orbit(std::int64_t ns, double dx, double dy, int width, int height) {
  if (Status taken = takeByHand(ns, width, height); !taken) return taken;
  by_hand_->orbit(dx, dy, height);
  return {};
}

Status WebSession::pan(std::int64_t ns, double dx, double dy, int width, int height) {
  if (Status taken = takeByHand(ns, width, height); !taken) return taken;
  by_hand_->pan(dx, dy, height);
  return {};
}

Status WebSession::zoomAt(std::int64_t ns, double steps, double right, double down, int width,
                          int height) {
  if (Status taken = takeByHand(ns, width, height); !taken) return taken;
  by_hand_->zoomAt(steps, right, down, height);
  return {};
}

std::string WebSession::camera() const {
  return by_hand_ ? viewpointText(by_hand_->view()) : camera_;
}

}  // namespace rocinante
