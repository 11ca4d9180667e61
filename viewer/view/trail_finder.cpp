#include "viewer/view/trail_finder.h"

#include <algorithm>
#include <cmath>

#include "core/math/transform.h"

namespace rocinante {
namespace {

/// Cached positions of one trail: many windows, a few megabytes.
constexpr std::size_t kMaxKnown = 100'000;
constexpr std::size_t kMaxTrailsKnown = 64;

bool isFinite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Division rounded down: moments before the origin have negative numbers.
std::int64_t floorDivide(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return quotient * b > a ? quotient - 1 : quotient;
}

}  // namespace

Result<std::vector<Trail>> TrailFinder::find(const std::vector<TrailStyle>& styles,
                                             Timeline& session, LogTime time, StateDamage& damage) {
  // Clear the whole cache, before taking pointers into it: the same positions are found again.
  if (known_.size() > kMaxTrailsKnown) known_.clear();
  std::vector<Wanted> wanted;
  for (const TrailStyle& style : styles) {
    const auto path = parseViewPath(style.path);
    if (!path) return path.error();
    Wanted one;
    one.path = *path;
    one.step = std::max(style.window / kTrailPoints, Nanoseconds(1));
    const LogTime begin = std::max(time - style.window, session.start());
    const std::int64_t step = one.step.count();
    one.first = floorDivide((begin - session.origin()).count() + step - 1, step);
    one.last = floorDivide((time - session.origin()).count() - 1, step);
    // Rounding of the step may allow a few more than the window has.
    one.first = std::max(one.first, one.last - kTrailPoints + 1);
    one.known = &known_[{style.path, step}];
    if (one.known->size() > kMaxKnown) one.known->clear();
    wanted.push_back(one);
  }
  if (Status found = findPlaces(wanted, session, damage); !found) return found.error();
  const auto now = session.stateAt(time, &damage);
  if (!now) return now.error();

  std::vector<Trail> trails;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Wanted& one = wanted[i];
    Trail trail{styles[i].path, {{}}};
    const auto add = [&](const Place& place, Nanoseconds before) {
      if (!place) {
        if (!trail.runs.back().empty()) trail.runs.emplace_back();
        return;
      }
      const double age =
          static_cast<double>(before.count()) / static_cast<double>(styles[i].window.count());
      trail.runs.back().push_back({*place, static_cast<float>(std::clamp(1 - age, 0.0, 1.0))});
    };
    for (std::int64_t k = one.first; k <= one.last; ++k) {
      add(one.known->at(k).place, time - (session.origin() + one.step * k));
    }
    add(placeOf(one.path, **now), Nanoseconds(0));
    if (trail.runs.back().empty()) trail.runs.pop_back();
    trails.push_back(std::move(trail));
  }
  return trails;
}

Status TrailFinder::findPlaces(const std::vector<Wanted>& wanted, Timeline& session,
                               StateDamage& damage) {
  // In time order, which is fastest for the session.
  std::map<LogTime, std::vector<std::pair<const Wanted*, std::int64_t>>> questions;
  for (const Wanted& one : wanted) {
    for (std::int64_t k = one.first; k <= one.last; ++k) {
      const auto known = one.known->find(k);
      if (known == one.known->end() || known->second.is_damaged) {
        questions[session.origin() + one.step * k].emplace_back(&one, k);
      }
    }
  }
  for (const auto& [time, samples] : questions) {
    StateDamage its;
    const auto state = session.stateAt(time, &its);
    if (!state) return state.error();
    for (const auto& [one, k] : samples) {
      (*one->known)[k] = {placeOf(one->path, **state), !its.empty()};
    }
    damage.add(its);
  }
  return {};
}

TrailFinder::Place TrailFinder::placeOf(const ViewPath& path, const SessionState& state) {
  need(path.path.first, state);
  const PosedScene scene = poseScene(part_, state);
  const auto found = scene.find(path.path.first, path.path.second);
  if (!found || !isFinite(positionOf(*found))) return std::nullopt;
  return positionOf(*found);
}

void TrailFinder::need(const std::string& device, const SessionState& state) {
  if (part_.models.empty()) {
    part_.models = cell_.models;
    part_.sources = cell_.sources;
  }
  // Computed for each state: carriers may have changed.
  std::set<std::string, std::less<>> met;
  std::vector<std::string> open{device};
  while (!open.empty()) {
    const std::string name = std::move(open.back());
    open.pop_back();
    if (name.empty() || !met.insert(name).second) continue;
    const bool is_new = needed_.insert(name).second;
    if (const CellDevice* own = cell_.findDevice(name)) {
      if (is_new) part_.devices.push_back(*own);
      open.push_back(own->on_device);
    }
    for (const CellSource& source : cell_.sources) {
      const auto ghost = source.ghost_of.find(name);
      if (ghost != source.ghost_of.end()) open.push_back(ghost->second);
    }
    const auto found = state.devices().find(name);
    if (found != state.devices().end() && found->second.pose) {
      open.push_back(found->second.pose->value.carrier.first);
    }
  }
}

}  // namespace rocinante
