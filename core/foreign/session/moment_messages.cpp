#include "core/foreign/session/moment_messages.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/math/transform.h"
#include "core/packet/packet_limits.h"

namespace rocinante {
namespace {

bool sameMatrices(const std::vector<Mat4>& a, const std::vector<Mat4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat4)) == 0;
}

}  // namespace

MomentMessages::MomentMessages(const Cell* cell, SessionFormat& format)
    : cell_(cell), format_(format) {
  if (cell != nullptr) poses_.emplace(*cell);
}

void MomentMessages::notice(const Packet& packet) {
  ++packets_;
  bool draws = packet.header.part.has_value() || packet.header.reset;
  // A source that restarts has drawn nothing yet.
  const auto kept = kept_.find(packet.header.source);
  if (kept != kept_.end() && kept->second.run != packet.header.run) draws = true;
  for (const Statement& statement : packet.statements) {
    switch (statement.kind) {
      case StatementKind::line:
      case StatementKind::points:
      case StatementKind::label:
      case StatementKind::erase:
        draws = true;
        break;
      case StatementKind::remove:
        all_drawn_ = true;  // with what is drawn on the device
        break;
      case StatementKind::signal:
      case StatementKind::signals:
        if (statement.path.first.empty()) is_bare_stated_ = true;
        noticeSignals(statement);
        break;
      default:
        break;
    }
  }
  if (draws) drawn_.insert(std::string(packet.header.source));
  if (packet.header.part || packet.header.reset) is_bare_stated_ = true;
}

void MomentMessages::noticeSignals(const Statement& statement) {
  // A cancelled one is missing from the state: areNoticed() counts.
  if (all_noticed_ || statement.is_default || format_.requestsAllSignals()) return;
  auto& of_owner =
      noticed_[{std::string(statement.path.first), std::string(statement.path.second)}];
  for (const std::string_view name : statement.names) {
    if (of_owner.contains(name)) continue;
    // More than a state can have: what a stranger names takes no more memory.
    if (noticed_count_ == limits::kSignals) {
      all_noticed_ = true;
      return;
    }
    of_owner.emplace(name);
    ++noticed_count_;
  }
}

Status MomentMessages::moment(MessageSink& out, LogTime time, const SessionState& state) {
  Status written = cell_ == nullptr ? bareFrames(out, time, state) : cellFrames(out, time, state);
  if (written) written = joints(out, time, state);
  if (written) written = signals(out, time, state);
  if (written) written = drawings(out, time, state);
  before_ = time;
  forgetGone(state);
  return written;
}

/// Devices come and go in a live session: what is kept of them does not outgrow the state.
void MomentMessages::forgetGone(const SessionState& state) {
  constexpr std::size_t kFew = 64;
  if (known_.size() < 2 * state.devices().size() + 2 * models_.size() + kFew) return;
  std::erase_if(known_, [&](const auto& each) {
    return state.findDevice(each.first) == nullptr && !models_.contains(each.first);
  });
}

bool MomentMessages::framesDue(Known& known, std::vector<Mat4> now, bool is_written,
                               LogTime time) const {
  const bool is_first = known.links.empty();
  const bool has_moved = !sameMatrices(known.links, now);
  const Nanoseconds last = format_.framesLast();
  const bool is_old = !is_first && last.count() > 0 && time - known.frames_written >= last;
  if (!is_first && !has_moved && !is_written && !is_old) return false;
  known.links = std::move(now);
  known.frames_written = time;
  return true;
}

Status MomentMessages::cellFrames(MessageSink& out, LogTime time, const SessionState& state) {
  const PosedScene scene = poses_->pose(state);
  for (const PosedDevice& device : scene.devices) {
    if (device.ghost) continue;
    const DeviceState* const stated = state.findDevice(device.name);
    std::vector<Mat4> now{device.base};
    now.insert(now.end(), device.link_world.begin(), device.link_world.end());
    if (!framesDue(known_[device.name], std::move(now), stated != nullptr && isWritten(*stated),
                   time)) {
      continue;
    }
    Status written = format_.frames(out, time, device.name, deviceFrames(device));
    if (!written) return written;
    models_[device.name] = device.model;
  }
  return shown ? shown(time, scene) : Status{};
}

Status MomentMessages::bareFrames(MessageSink& out, LogTime time, const SessionState& state) {
  for (const auto& [name, device] : state.devices()) {
    if (!device.pose || isRemoved(device)) continue;
    const PoseValue& pose = device.pose->value;
    if (!pose.carrier.second.empty()) carried_.insert(name);
    if (!framesDue(known_[name], {matrixOf(pose.pose)}, isWritten(device), time)) continue;
    const FramePose frame{frameName(pose.carrier.first, pose.carrier.second), name, pose.pose};
    if (Status written = format_.frames(out, time, name, {&frame, 1}); !written) return written;
  }
  return {};
}

Status MomentMessages::joints(MessageSink& out, LogTime time, const SessionState& state) {
  for (const auto& [name, device] : state.devices()) {
    if (!hasJoints(device) || isRemoved(device)) continue;
    Known& known = known_[name];
    if (known.joints_written && !isWritten(device)) continue;
    known.joints_written = true;
    const auto model = models_.find(name);
    std::vector<NamedValue> values =
        jointValues(model == models_.end() ? nullptr : model->second, device);
    known.in_joints = addSpeedsAndEfforts(device, values);
    if (Status written = format_.joints(out, time, name, values); !written) return written;
  }
  return {};
}

Status MomentMessages::signals(MessageSink& out, LogTime time, const SessionState& state) {
  // Those of no device have no last_write: packets tell, or that there are others than before.
  std::uint64_t applied = 0;
  for (const auto& [source, counts] : state.counts()) applied += counts.packets + counts.by_others;
  const std::uint64_t applied_before = std::exchange(applied_, applied);
  const bool counts_anew = applied < applied_before;
  // A state that was read from a keyframe may hold what no packet said.
  const bool is_other =
      counts_anew || applied > applied_before + std::exchange(packets_, std::uint64_t{0});
  const std::size_t before = std::exchange(bare_signals_, state.signals().size());
  const bool is_bare_stated = std::exchange(is_bare_stated_, false);
  const bool are_noticed =
      !format_.requestsAllSignals() && !is_other && !all_noticed_ && areNoticed(state);
  Status written = are_noticed ? noticedSignals(out, time, state) : Status();
  noticed_.clear();
  noticed_count_ = 0;
  all_noticed_ = false;
  if (are_noticed) return written;
  if (is_bare_stated || counts_anew || before != bare_signals_ || !format_.requestsAllSignals()) {
    written = signalsOf(out, time, {}, state.signals());
  }
  for (const auto& [name, device] : state.devices()) {
    if (written && isWritten(device)) written = signalsOf(out, time, name, device.signals);
  }
  // What is gone is said once more, as nothing.
  for (auto each = stated_signals_.begin(); each != stated_signals_.end() && written;) {
    const auto& [device, link] = each->first;
    const DeviceState* const of_device = device.empty() ? nullptr : state.findDevice(device);
    const bool is_gone = !device.empty() && of_device == nullptr;
    const Signals none;
    const Signals& now = is_gone                ? none
                         : of_device == nullptr ? state.signals()
                                                : of_device->signals;
    const auto first = now.lower_bound(SignalNameView(link, ""));
    if (first != now.end() && first->first.link == link) {
      ++each;
      continue;
    }
    written = format_.signals(out, time, each->first, {}, true);
    each = stated_signals_.erase(each);
  }
  stated_count_ = 0;
  for (const auto& [owner, known] : stated_signals_) stated_count_ += known.by_name.size();
  return written;
}

bool MomentMessages::areNoticed(const SessionState& state) const {
  // What was said and what packets added since are all that the state can have: when they are as
  // many, nothing has gone.
  std::size_t count = stated_count_;
  for (const auto& [owner, names] : noticed_) {
    const auto known = stated_signals_.find(owner);
    for (const std::string& name : names) {
      if (known != stated_signals_.end() && known->second.by_name.contains(name)) continue;
      if (state.findSignal(owner.first, {owner.second, name}) != nullptr) ++count;
    }
  }
  return count == state.signalCount();
}

Status MomentMessages::noticedSignals(MessageSink& out, LogTime time, const SessionState& state) {
  std::vector<StatedSignal> news;
  for (const auto& [owner, names] : noticed_) {
    news.clear();
    bool is_first = false;
    for (const std::string& name : names) {
      const Item<SignalValue>* const item = state.findSignal(owner.first, {owner.second, name});
      if (item == nullptr) continue;
      StatedSignals& known = stated_signals_[owner];
      is_first |= known.by_name.empty();
      known.newest = std::max(known.newest, item->stated.packet);
      const std::size_t before = known.by_name.size();
      const bool is_new = known.take(name, *item, false);
      stated_count_ += known.by_name.size() - before;
      if (is_new) news.push_back({name, &item->value, true, isInJoints(owner, name)});
    }
    if (news.empty()) continue;
    if (Status written = format_.signals(out, time, owner, news, is_first); !written) {
      return written;
    }
  }
  return {};
}

bool MomentMessages::StatedSignals::take(const std::string& name, const Item<SignalValue>& item,
                                         bool counts_anew) {
  const auto [kept, is_unknown] = by_name.try_emplace(name, item);
  Item<SignalValue>& before = kept->second;
  const bool is_stated = !counts_anew && item.stated.packet > before.stated.packet;
  const bool is_new = is_unknown || is_stated || item.value != before.value;
  before.stated = item.stated;
  if (is_new) before.value = item.value;
  return is_new;
}

bool MomentMessages::isInJoints(const SignalOwner& owner, std::string_view name) const {
  if (!owner.second.empty()) return false;
  const auto known = known_.find(owner.first);
  return known != known_.end() && known->second.in_joints.contains(name);
}

Status MomentMessages::signalsOf(MessageSink& out, LogTime time, const std::string& device,
                                 const Signals& signals) {
  std::vector<StatedSignal> all;
  for (auto first = signals.begin(); first != signals.end();) {
    const SignalOwner owner{device, first->first.link};
    const std::string& link = owner.second;
    StatedSignals& known = stated_signals_[owner];
    std::uint64_t newest = 0;
    auto last = first;
    for (; last != signals.end() && last->first.link == link; ++last) {
      newest = std::max(newest, last->second.stated.packet);
    }
    // A state that was read from a keyframe counts packets anew.
    const bool counts_anew = newest < known.newest;
    known.newest = newest;
    bool is_due = false;
    bool all_requested = known.by_name.empty();
    all.clear();
    for (; first != last; ++first) {
      const auto& [name, item] = *first;
      const bool is_new = known.take(name.name, item, counts_anew);
      is_due |= is_new;
      all.push_back({name.name, &item.value, is_new, isInJoints(owner, name.name)});
    }
    if (known.by_name.size() != all.size()) {
      is_due = all_requested = true;
      std::erase_if(known.by_name, [&](const auto& each) {
        return !signals.contains(SignalNameView(link, each.first));
      });
    }
    if (!is_due) continue;
    if (Status written = format_.signals(out, time, owner, all, all_requested); !written) {
      return written;
    }
  }
  return {};
}

Status MomentMessages::drawings(MessageSink& out, LogTime time, const SessionState& state) {
  if (!has_begun_ || all_drawn_) {
    for (const auto& [key, drawing] : state.drawings()) drawn_.insert(key.first);
    for (const auto& [source, kept] : kept_) drawn_.insert(source);
  }
  has_begun_ = true;
  all_drawn_ = false;
  for (const std::string& source : drawn_) {
    SessionFormat::Drawings now;
    auto each = state.drawings().lower_bound({source, ""});
    for (; each != state.drawings().end() && each->first.first == source; ++each) {
      now.emplace_back(each->first.second, &each->second);
    }
    const auto stated = state.sources().find(source);
    const auto known = kept_.find(source);
    if (known == kept_.end() && now.empty()) continue;
    Drawn& kept = known == kept_.end() ? kept_[source] : known->second;
    if (stated != state.sources().end()) kept.run = stated->second.run;
    const bool is_same = std::equal(
        now.begin(), now.end(), kept.drawings.begin(), kept.drawings.end(),
        [](const auto& a, const auto& b) { return a.first == b.first && *a.second == b.second; });
    if (is_same) continue;
    kept.drawings.clear();
    for (const auto& [id, drawing] : now) kept.drawings.emplace_back(id, *drawing);
    if (Status written = format_.drawings(out, time, source, now); !written) return written;
  }
  drawn_.clear();
  return {};
}

}  // namespace rocinante
