#include "viewer/view/beside_session.h"

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/cell/device_appearance.h"
#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "core/math/turn_angle.h"

namespace rocinante {
namespace {

constexpr std::string_view kEventWord = "event:";

/// The first event of that text, from any source; null when there is none.
const Event* firstNamed(const std::vector<Event>& events, std::string_view text) {
  const auto found = std::ranges::find(events, text, &Event::text);
  return found == events.end() ? nullptr : &*found;
}

Error unaligned(std::string what) { return {ErrorKind::bad_argument, std::move(what), {}}; }

bool isNear(const Mat4& a, const Mat4& b) {
  const Vec3 apart = positionOf(a) - positionOf(b);
  // Not less or equal, so that what is not finite counts as elsewhere.
  if (!(glm::dot(apart, apart) <= BesideSession::kSamePlace_m * BesideSession::kSamePlace_m)) {
    return false;
  }
  return turnAngle(a, b) <= radiansOf(BesideSession::kSameTurn_deg);
}

}  // namespace

Result<EventAlignment> alignBeside(std::string_view how, Timeline& shown, Timeline& beside,
                                   StateDamage& damage) {
  EventAlignment alignment;
  alignment.anchor_a = shown.origin();
  alignment.anchor_b = beside.origin();
  if (how.empty() || how == "origin") return alignment;
  const bool by_one = how.starts_with(kEventWord);
  if (how != "events" && !by_one) {
    const auto offset = parseDuration(how);
    if (!offset) {
      return unaligned("`" + std::string(how) +
                       "` aligns nothing: use origin, events, event:TEXT or an offset, as 2.5s");
    }
    alignment.anchor_b += *offset;
    return alignment;
  }
  const auto of_shown = shown.events(&damage);
  if (!of_shown) return of_shown.error();
  const auto of_beside = beside.events(&damage);
  if (!of_beside) return of_beside.error();
  if (!by_one) {
    alignment = alignEvents(**of_shown, **of_beside, alignment.anchor_a, alignment.anchor_b);
    if (alignment.matched.empty()) return unaligned("the two sessions have no event in common");
    return alignment;
  }
  const std::string_view text = how.substr(kEventWord.size());
  const Event* const a = firstNamed(**of_shown, text);
  const Event* const b = firstNamed(**of_beside, text);
  if (a == nullptr || b == nullptr) {
    const Timeline& without = a == nullptr ? shown : beside;
    return Error{ErrorKind::bad_argument, "no event is called `" + std::string(text) + "`",
                 without.log().name()};
  }
  alignment.anchor_a = a->time;
  alignment.anchor_b = b->time;
  return alignment;
}

bool isSamePlace(const PosedDevice& a, const PosedDevice& b) {
  return a.model == b.model && std::ranges::equal(a.link_world, b.link_world, isNear);
}

bool BesideSession::covers(LogTime shown) const {
  const LogTime moment = momentAt(shown);
  return moment >= session_.start() && moment <= session_.end();
}

Status BesideSession::addGhosts(PosedScene& scene, LogTime shown, StateDamage& damage) {
  if (!covers(shown)) return {};
  const auto state = session_.stateAt(momentAt(shown), &damage);
  if (!state) return state.error();
  PosedScene other = poses_.pose(**state);
  for (PosedDevice& device : other.devices) {
    if (device.ghost) continue;
    const PosedDevice* const same = scene.findDevice(device.name);
    if (same != nullptr && isSamePlace(*same, device)) continue;
    device.name.insert(0, kBesidePrefix);
    device.ghost = true;
    std::ranges::fill(device.link_color, kGhostColor);
    for (PosedShare& share : device.shares) share.has_color = false;
    // Its carrier may be where it is in the shown session.
    device.pose = poseOf(device.base);
    device.carrier.clear();
    device.carrier_link.clear();
    scene.device_by_name.emplace(device.name, scene.devices.size());
    scene.devices.push_back(std::move(device));
  }
  return {};
}

}  // namespace rocinante
