#include "viewer/ui/model/view_model.h"

#include <algorithm>
#include <utility>

#include "core/cell/view_path.h"
#include "core/session/marks.h"
#include "core/session/moment_name.h"

namespace rocinante {

Result<ViewModel> ViewModel::make(Cell cell, std::optional<Timeline> session,
                                  std::optional<LiveFeed> feed, std::vector<std::string> hide,
                                  std::vector<std::string> show) {
  ViewModel model;
  model.cell_ = std::make_unique<Cell>(std::move(cell));
  model.poser_.emplace(*model.cell_);
  model.names_.emplace(*model.cell_);
  if (session) model.names_->useLog(session->log().name());
  if (feed) model.names_->expectOthers();
  for (Status known : {model.names_->check(hide), model.names_->check(show)}) {
    if (!known) return known.error();
  }
  model.hidden_.insert(hide.begin(), hide.end());
  model.shown_paths_.insert(show.begin(), show.end());
  if (auto chosen = model.updateChoice(); !chosen) return chosen.error();
  model.feed_ = std::move(feed);
  if (model.feed_) {
    model.live_ = std::make_unique<LiveSnapshot>();
    model.keeping_trouble_ = model.feed_->keepingFault();
  }
  if (session) {
    StateDamage hiding;  // the panel counts all places of damage
    auto events = session->events(&hiding);
    if (!events.ok()) return events.error();
    model.events_ = **events;
    model.cursor_.emplace(session->start(), session->end());
    model.viewer.time_view = TimeView(session->start(), session->end());
    for (const LossSpan& span : session->log().losses()) {
      model.recorded_losses_ += span.counts.kernel + span.counts.queue + span.counts.disk;
    }
    model.log_grows_ = session->growing();
    model.session_ = std::move(session);
    model.cursor_->setGrowing(model.log_grows_);
    model.cursor_->followNow();
  }
  for (const CellInset& inset : model.cell_->insets) model.viewer.insets.push_back({inset, true});
  model.resetCamera();
  return model;
}

Status ViewModel::showBeside(Timeline beside, std::string_view align) {
  if (!session_) return Error{ErrorKind::bad_argument, "--beside needs a log", {}};
  StateDamage hiding;  // the panel counts all places of damage
  auto alignment = alignBeside(align, *session_, beside, hiding);
  if (!alignment.ok()) return alignment.error();
  dropBesideStudies();
  beside_.emplace(*cell_, std::move(beside), std::move(*alignment));
  names_->expectBeside();
  beside_shown = true;
  scene_is_old_ = true;
  return {};
}

void ViewModel::endBeside() {
  dropBesideStudies();
  beside_.reset();
  const auto is_ghost = [](const std::string& path) { return path.starts_with(kBesidePrefix); };
  std::erase_if(hidden_, is_ghost);
  std::erase_if(shown_paths_, is_ghost);
  static_cast<void>(updateChoice());  // fewer paths are no worse
  scene_is_old_ = true;
}

Status ViewModel::updateChoice() {
  auto choice = ViewChoice::make(hiddenPaths(), shownPaths());
  if (!choice.ok()) return choice.error();
  choice_ = std::move(*choice);
  return {};
}

Status ViewModel::findTrails(LogTime moment) {
  // Places behind the end of a log that grows would be remembered as they are not.
  const bool may_lack = log_grows_ && session_;
  const LogTime known = may_lack ? std::min(moment, session_->end()) : moment;
  return poser_->findTrails(style_, session(), known, damage_, extras_);
}

Status ViewModel::findState(LogTime moment) {
  // Trails first: they query states too, and only the last one is valid.
  damage_ = {};
  if (auto trails = findTrails(moment); !trails) return trails;
  const auto state = session_->stateAt(moment, &damage_);
  if (!state.ok()) return state.error();
  receive(**state);
  seen_damage_.add(damage_);
  return {};
}

void ViewModel::receive(const SessionState& state) {
  received_ = &state;
  scene_is_old_ = true;
}

Result<bool> ViewModel::update(SteadyTime now) {
  style_.lengths = hand.units.length;  // which panels change by themselves
  enterDriving(now);
  bool changed = !shown_.has_value() || std::exchange(style_changed_, false);
  changed = std::exchange(beside_was_shown_, beside_shown) != beside_shown || changed;
  LogTime moment = shownTime();
  if (feed_ && hear(now)) changed = true;
  if (log_grows_ || feed_) changed = watchLog(now) || changed;
  const bool shows_live = feed_ && showsNow();
  if (shows_live) {
    moment = live_->time;
    if (heard_) {
      changed = others_.look(live_->state, live_->sources, feedTime(now)) || changed;
    }
    if (changed) {
      damage_ = {};
      if (auto trails = findTrails(moment); !trails) loseLog(trails.error());
    }
    // Set each time: this model may have been moved.
    const SessionState& live = heard_ ? live_->state : empty_state_;
    if (received_ != &live) receive(live);
  } else if (cursor_) {
    moment = cursor_->position(now);
    if (changed || shown_ != moment) {
      if (auto found = showMoment(moment); !found) {
        if (!log_grows_) return found.error();
        receive(empty_state_);
        loseLog(found.error());
      }
      changed = true;
    }
  } else if (received_ != &empty_state_) {
    receive(empty_state_);
  }
  shown_ = moment;
  // What the past has is never sent.
  if (feed_ && !shows_live) hand.stopDriving();
  hand.setSituation(shows_live, !shows_live && cursor_ && cursor_->playing());
  changed = hand.takeChanged() || changed;
  changed = moves.takeChanged() || changed;
  changed = publishing.takeChanged() || changed;
  changed = std::exchange(scene_is_old_, false) || changed;
  if (!moves.poses().empty()) {
    if (changed) state_ = moves.over(*hand.over(*received_, moment), *cell_, moment);
  } else if (changed || !hand.drawn()) {
    state_ = hand.over(*received_, moment);
  }
  if (changed) {
    if (auto posed = pose(moment); !posed) return posed.error();
    follow();
    // Checking thousands of devices for each frame would cost as much as posing them.
    if (!feed_ || !mismatched_at_ || now - *mismatched_at_ >= std::chrono::milliseconds(500)) {
      mismatched_ = rocinante::mismatchedDevices(*cell_, scene_, *state_);
      mismatched_at_ = now;
    }
    nearest_is_old_ = true;
  }
  return lookForNearest() || changed;
}

Status ViewModel::pose(LogTime moment) {
  scene_ = poser_->pose(style_, *state_, extras_);
  publishing.addTo(scene_);
  if (feed_ && showsNow()) {
    // That window's pointer has gone silent: drop it.
    std::erase_if(scene_.drawings, [this](const PosedDrawing& drawing) {
      return (drawing.id == Publisher::kPointer || drawing.id == Publisher::kPointerName) &&
             others_.isSilent(drawing.source);
    });
  }
  if (!beside_ || !beside_shown) return {};
  StateDamage damage;
  if (auto added = beside_->addGhosts(scene_, moment, damage); !added) return added;
  damage_.add(damage);
  seen_damage_.add(damage);
  return {};
}

Selection ViewModel::inspected() const {
  if (!selected.device.empty() || session_ || feed_) return selected;
  for (const PosedDevice& device : scene_.devices) {
    if (device.model != nullptr && device.model->positionalCount() > 0) return {device.name, ""};
  }
  return {};
}

void ViewModel::enterDriving(SteadyTime now) {
  if (!hand.takeEntered()) return;
  if (feed_) {
    goToNow();
  } else if (cursor_) {
    cursor_->pause(now);
  }
}

Status ViewModel::setByHand(const std::string& device,
                            const std::function<Status(const PosedDevice&)>& set, SteadyTime now) {
  const PosedDevice* const posed = scene_.findDevice(device);
  if (posed == nullptr) {
    return Error{ErrorKind::bad_argument, "there is no such device now", device};
  }
  enterDriving(now);
  const bool shows_live = feed_ && showsNow();
  if (cursor_ && !shows_live) cursor_->pause(now);
  hand.setSituation(shows_live, false);
  return set(*posed);
}

Status ViewModel::setByHand(const std::string& device, const std::string& value_name, double value,
                            SteadyTime now) {
  return setByHand(
      device, [&](const PosedDevice& posed) { return hand.set(posed, value_name, value); }, now);
}

Status ViewModel::setByHand(const std::string& device, std::span<const double> values,
                            SteadyTime now) {
  return setByHand(
      device, [&](const PosedDevice& posed) { return hand.setAll(posed, values); }, now);
}

Result<Pose> ViewModel::movablePose(const std::string& device) const {
  const auto refused = [&](std::string what) {
    return Error{ErrorKind::bad_argument, std::move(what), device};
  };
  const PosedDevice* const posed = scene_.findDevice(device);
  if (cell_->findDevice(device) == nullptr) return refused("the cell has no such device");
  if (posed == nullptr) return refused("there is no such device now");
  const DeviceState* const device_state = received_->findDevice(device);
  if (device_state != nullptr && device_state->pose)
    return refused("packets say where the device is");
  // The scene has it there only from the next update on.
  const Pose* const moved = moves.find(device);
  return moved == nullptr ? posed->pose : *moved;
}

Status ViewModel::addMark(const std::string& text) {
  if (!session_) return Error{ErrorKind::bad_argument, "a mark needs a log", {}};
  Event mark;
  mark.time = shownTime();
  mark.text = text;
  if (auto added = rocinante::addMark(session_->logAt(mark.time).name(), mark); !added)
    return added;
  const auto after = std::ranges::upper_bound(events_, mark.time, {}, &Event::time);
  events_.insert(after, std::move(mark));
  return {};
}

Result<std::optional<LogTime>> ViewModel::packetBeside(bool after) {
  if (!session_) return std::optional<LogTime>();
  const std::string& log = session_->logAt(shownTime()).name();
  if (!walker_ || walker_->name() != log) {
    auto opened = log_grows_ ? LogReader::openGrowing(log) : LogReader::open(log);
    if (!opened.ok()) return opened.error();
    walker_ = std::move(*opened);
  }
  if (auto grown = walker_->refresh(); !grown.ok()) return grown.error();
  const LogTime from = after ? shownTime() + Nanoseconds(1) : shownTime();
  if (auto there = walker_->seek(from); !there) return there.error();
  while (true) {
    const auto message = after ? walker_->next() : walker_->previous();
    if (!message.ok()) return message.error();
    if (!*message) return std::optional<LogTime>();
    if ((*message)->channel->captured()) return std::optional<LogTime>((*message)->log_time);
  }
}

Result<LogTime> ViewModel::momentNamed(const std::string& text) {
  if (session_ && !isSessionTime(text)) return parseMoment(text, *session_);
  // The end of a live session is where the network is.
  return parseSessionTime(text, origin(), cursor_ ? cursor_->end() : origin());
}

const Event* ViewModel::eventBeside(LogTime moment, bool after) const {
  if (after) {
    const auto next = std::ranges::upper_bound(events_, moment, {}, &Event::time);
    return next == events_.end() ? nullptr : &*next;
  }
  const auto here = std::ranges::lower_bound(events_, moment, {}, &Event::time);
  return here == events_.begin() ? nullptr : &*std::prev(here);
}

void ViewModel::useLooksByDefault() {
  RenderStyle style = style_;
  style.shadows = style.contact = style.camera_cone = true;
  setStyle(style);
  looks_by_default_ = true;
}

void ViewModel::dropLooksByDefault() {
  RenderStyle style = style_;
  style.shadows = style.contact = false;
  setStyle(style);
}

void ViewModel::setStyle(const RenderStyle& style) {
  if (style.shadows != style_.shadows || style.contact != style_.contact) looks_by_default_ = false;
  // The picture's lengths and the panels' have one unit.
  if (style.lengths != style_.lengths) hand.units.length = style.lengths;
  style_changed_ = style_changed_ || !(style == style_);
  style_ = style;
}

RenderStyle ViewModel::frameStyle() const {
  RenderStyle style = style_;
  if (viewer.picking.first())
    style.measures.push_back({*viewer.picking.first(), *viewer.picking.first()});
  style.lengths = hand.units.length;
  if (viewer.outline_selected && !selected.device.empty())
    style.outlined.push_back(selected.path());
  return style;
}

void ViewModel::pickPoint(const Selection& link, const Vec3& point) {
  if (auto measure = viewer.picking.add(scene_, link, point)) {
    RenderStyle style = style_;
    style.measures.push_back(std::move(*measure));
    setStyle(style);
  }
}

bool ViewModel::setVisible(const std::string& path, std::optional<bool> visible) {
  const auto hidden_before = hidden_;
  const auto shown_before = shown_paths_;
  const auto wanted = parseViewPath(path);
  if (!wanted) return false;
  // A user may have written it in another way.
  const auto isWanted = [&](const std::string& other) {
    const auto named = parseViewPath(other);
    return named.ok() && *named == *wanted;
  };
  std::erase_if(hidden_, isWanted);
  std::erase_if(shown_paths_, isWanted);
  if (visible) (*visible ? shown_paths_ : hidden_).insert(path);
  if (updateChoice()) return true;
  hidden_ = hidden_before;
  shown_paths_ = shown_before;
  return false;
}

bool ViewModel::showOnly(const std::string& path) {
  const auto isKept = [&](const PosedDevice& one) {
    return Selection{one.name, ""}.path() == path;
  };
  const auto kept = std::ranges::find_if(scene_.devices, isKept);
  if (kept == scene_.devices.end()) return false;
  hidden_.clear();
  shown_paths_.clear();
  if (!kept->visible) shown_paths_.insert(path);
  for (const PosedDevice& one : scene_.devices) {
    if (!isKept(one)) hidden_.insert(Selection{one.name, ""}.path());
  }
  return updateChoice().ok();
}

bool ViewModel::layerVisibleByDefault(const CellLayer& layer) const {
  const auto found = state_->visibility().find(Path{true, "layer", layer.name});
  if (found == state_->visibility().end()) return layer.visible;
  switch (found->second.value.kind) {
    case Visibility::Kind::shown:
      return true;
    case Visibility::Kind::hidden:
      return false;
    case Visibility::Kind::by_default:
      break;
  }
  return layer.visible;
}

std::optional<bool> ViewModel::chosenVisibility(const std::string& path) const {
  if (hidden_.contains(path)) return false;
  if (shown_paths_.contains(path)) return true;
  const auto wanted = parseViewPath(path);
  const auto names = [&](const std::string& other) {
    const auto named = parseViewPath(other);
    return wanted.ok() && named.ok() && *named == *wanted;
  };
  if (std::ranges::any_of(hidden_, names)) return false;
  if (std::ranges::any_of(shown_paths_, names)) return true;
  return std::nullopt;
}

}  // namespace rocinante
