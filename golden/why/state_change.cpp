#include "golden/why/state_change.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/cell/posed_scene.h"
#include "core/math/transform.h"
#include "core/math/turn_angle.h"

namespace rocinante {
namespace {

constexpr double kDegrees = 57.29577951308232;

/// Decimals that show a difference with two digits, from 3 to 9.
int decimalsFor(double difference) {
  int decimals = 3;
  for (double unit = 1e-2; decimals < 9 && std::abs(difference) < unit; unit /= 10) ++decimals;
  return decimals;
}

std::string fromToText(double from, double to, std::string_view unit) {
  if (unit == "rad") return fromToText(from * kDegrees, to * kDegrees, "°");
  const int decimals = decimalsFor(to - from);
  if (unit == "°") return fmt::format("{:.{}f}° -> {:.{}f}°", from, decimals, to, decimals);
  return fmt::format("{:.{}f} -> {:.{}f}{}{}", from, decimals, to, decimals,
                     unit.empty() ? "" : " ", unit);
}

struct Component {
  std::string_view suffix, unit;
};

/// Names and units of a joint's values.
std::vector<Component> componentsOf(JointType type) {
  switch (type) {
    case JointType::fixed:
      return {};
    case JointType::revolute:
    case JointType::continuous:
      return {{"", "rad"}};
    case JointType::prismatic:
      return {{"", "m"}};
    case JointType::planar:
      return {{".x", "m"}, {".y", "m"}, {".yaw", "rad"}};
    case JointType::floating:
      return {{".x", "m"}, {".y", "m"}, {".z", "m"}, {".qx", ""},
              {".qy", ""}, {".qz", ""}, {".qw", ""}};
  }
  return {};
}

const DeviceState* deviceIn(const SessionState& state, const std::string& name) {
  const auto found = state.devices().find(name);
  return found == state.devices().end() ? nullptr : &found->second;
}

double distance(const Mat4& a, const Mat4& b) {
  return std::hypot(a[3][0] - b[3][0], a[3][1] - b[3][1], a[3][2] - b[3][2]);
}

class StateComparison {
 public:
  StateComparison(const Moment& golden, const Moment& frame)
      : golden_(golden),
        frame_(frame),
        golden_scene_(poseScene(golden.cell, golden.state)),
        frame_scene_(poseScene(frame.cell, frame.state)) {}

  std::vector<StateChange> changes(const std::string& camera) {
    for (const PosedDevice& now : frame_scene_.devices) {
      const PosedDevice* before = golden_scene_.findDevice(now.name);
      if (before == nullptr) {
        add(now.name, now.name + ": only in the frame's session");
      } else {
        compareDevice(*before, now);
      }
    }
    for (const PosedDevice& before : golden_scene_.devices) {
      if (frame_scene_.findDevice(before.name) == nullptr) {
        add(before.name, fmt::format("device {} is gone from this frame", before.name));
      }
    }
    compareDrawings();
    compareCamera(camera);
    return std::move(changes_);
  }

  MovedLinks moved() const {
    MovedLinks moved;
    for (const PosedDevice& now : frame_scene_.devices) {
      const PosedDevice* before = golden_scene_.findDevice(now.name);
      if (before == nullptr) continue;
      for (std::size_t link = 0; link < now.model->links.size(); ++link) {
        const std::string& name = now.model->links[link].name;
        const auto there = before->model->findLink(name);
        if (there && linkMoved(*before, *there, now, link)) moved.emplace(now.name, name);
      }
    }
    return moved;
  }

 private:
  void add(std::string item, std::string text, std::optional<double> amount = {},
           bool is_angle = false, std::string common = {}) {
    changes_.push_back({std::move(item), std::move(text), amount, is_angle, std::move(common)});
  }

  static bool linkMoved(const PosedDevice& before, std::size_t there, const PosedDevice& now,
                        std::size_t link) {
    if (before.link_world[there] != now.link_world[link]) return true;
    const std::vector<Visual>& old_visuals = before.model->links[there].visuals;
    const std::vector<Visual>& visuals = now.model->links[link].visuals;
    return !std::ranges::equal(old_visuals, visuals, [](const Visual& a, const Visual& b) {
      return matrixOf(a.origin) == matrixOf(b.origin) && a.scale == b.scale;
    });
  }

  void compareDevice(const PosedDevice& before, const PosedDevice& now) {
    const double moved = distance(before.base, now.base);
    const double turned = turnAngle(before.base, now.base);
    // Less is rounding: the same orientation may be stated by another quaternion.
    if (moved > 0 || turned > 1e-7) {
      add(now.name,
          fmt::format("{}: base moved by {:.{}f} m, turned by {:.2f}°", now.name, moved,
                      decimalsFor(moved), turned * kDegrees),
          moved, false, now.name + " is in another place in the session");
    }
    if (before.model->file != now.model->file && before.model->name != now.model->name) {
      add(now.name,
          fmt::format("{}: model {} -> {}", now.name, before.model->name, now.model->name));
    }
    compareJoints(before, now);
    compareLooks(before, now);
  }

  void compareJoints(const PosedDevice& before, const PosedDevice& now) {
    const JointVector old_values = jointsOf(*before.model, deviceIn(golden_.state, now.name));
    const JointVector values = jointsOf(*now.model, deviceIn(frame_.state, now.name));
    for (std::size_t joint = 0; joint < now.model->joints.size(); ++joint) {
      const Joint& its = now.model->joints[joint];
      const auto there = before.model->findJoint(its.name);
      if (!there || before.model->joints[*there].type != its.type) continue;
      const std::vector<Component> components = componentsOf(its.type);
      for (std::size_t i = 0; i < components.size(); ++i) {
        const double from = old_values.values[old_values.first_value[*there] + i];
        const double to = values.values[values.first_value[joint] + i];
        if (from == to) continue;
        const std::string item = fmt::format("{}/{}{}", now.name, its.name, components[i].suffix);
        add(item, fmt::format("{}: {}", item, fromToText(from, to, components[i].unit)),
            std::abs(to - from), components[i].unit == "rad",
            fmt::format("joint {} of {} has other values in the session", its.name, now.name));
      }
    }
  }

  void compareLooks(const PosedDevice& before, const PosedDevice& now) {
    const auto shownText = [](bool shown) { return shown ? "shown" : "hidden"; };
    const auto colorText = [](const std::optional<std::uint32_t>& color) {
      return color ? fmt::format("#{:08x}", *color) : std::string("its own");
    };
    if (before.visible != now.visible) {
      add(now.name,
          fmt::format("{}: {} -> {}", now.name, shownText(before.visible), shownText(now.visible)));
    }
    for (std::size_t link = 0; link < now.model->links.size(); ++link) {
      const auto there = before.model->findLink(now.model->links[link].name);
      const std::string item = now.name + "/" + now.model->links[link].name;
      if (!there) {
        add(item, item + ": link not in the golden's model");
        continue;
      }
      if (before.visible == now.visible && before.link_visible[*there] != now.link_visible[link]) {
        add(item, fmt::format("{}: {} -> {}", item, shownText(before.link_visible[*there]),
                              shownText(now.link_visible[link])));
      }
      if (before.link_color[*there] != now.link_color[link]) {
        add(item, fmt::format("{}: colour {} -> {}", item, colorText(before.link_color[*there]),
                              colorText(now.link_color[link])));
      }
    }
    for (const Link& link : before.model->links) {
      const std::string item = now.name + "/" + link.name;
      if (!now.model->findLink(link.name)) add(item, item + ": link no longer in the model");
    }
  }

  void compareDrawings() {
    const auto& before = golden_.state.drawings();
    const auto& now = frame_.state.drawings();
    const auto itemOf = [](const auto& key) { return "drawing " + key.first + "/" + key.second; };
    for (const auto& [key, drawing] : now) {
      const auto found = before.find(key);
      if (found == before.end()) {
        add(itemOf(key), itemOf(key) + ": only in the frame's session");
      } else if (found->second.text != drawing.text) {
        add(itemOf(key),
            fmt::format("{}: \"{}\" -> \"{}\"", itemOf(key), found->second.text, drawing.text), {},
            false, itemOf(key) + " has another text");
      } else if (!(found->second == drawing)) {
        add(itemOf(key), itemOf(key) + ": drawn differently");
      }
    }
    for (const auto& [key, drawing] : before) {
      if (!now.contains(key)) add(itemOf(key), itemOf(key) + ": only in the golden's session");
    }
  }

  void compareCamera(const std::string& name) {
    if (name.empty()) return;
    const PosedCamera* before = golden_scene_.findCamera(name);
    const PosedCamera* now = frame_scene_.findCamera(name);
    if (before == nullptr || now == nullptr) return;
    const std::string item = "camera " + name;
    const auto compare = [&](const char* what, const Vec3& a, const Vec3& b) {
      const double moved = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
      if (moved > 0) {
        add(item, fmt::format("{}: {} moved by {:.{}f} m", item, what, moved, decimalsFor(moved)),
            moved, false, item + " has moved");
      }
    };
    compare("eye", before->eye, now->eye);
    compare("target", before->target, now->target);
    if (before->fov_deg != now->fov_deg) {
      add(item, fmt::format("{}: field of view {}", item,
                            fromToText(before->fov_deg, now->fov_deg, "°")));
    }
  }

  const Moment& golden_;
  const Moment& frame_;
  PosedScene golden_scene_, frame_scene_;
  std::vector<StateChange> changes_;
};

}  // namespace

std::vector<StateChange> stateChanges(const Moment& golden, const Moment& frame,
                                      const std::string& camera) {
  return StateComparison(golden, frame).changes(camera);
}

MovedLinks movedLinks(const Moment& golden, const Moment& frame) {
  return StateComparison(golden, frame).moved();
}

}  // namespace rocinante
