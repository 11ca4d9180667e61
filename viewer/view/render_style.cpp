#include "viewer/view/render_style.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/duration_text.h"
#include "core/cell/view_path.h"

namespace rocinante {
namespace {

/// A trail has a fixed number of points: beyond a day they are useless.
constexpr Nanoseconds kLongestTrail = std::chrono::hours(24);

constexpr std::array kKeys{
    StyleKey{"shading", "standard|plain", "plain: one light and even ambient light"},
    StyleKey{"shadows", "on|off", "shadows of the key light"},
    StyleKey{"contact", "on|off", "darker where surfaces are near each other"},
    StyleKey{"edges", "on|only|off", "crisp edges; only: a line drawing"},
    StyleKey{"labels", "beside|apart", "apart: labels that do not cover each other"},
    StyleKey{"ghosts", "plain|clear", "clear: ghosts in one tone, behind the actual device"},
    StyleKey{"limits", "on|off", "links near a joint's limit amber, beyond it red"},
    StyleKey{"clearance", "on|off", "distances of links that `check` judges, red where too near"},
    StyleKey{"scale-bar", "on|off", "a scale bar, true at the camera's target"},
    StyleKey{"camera-cone", "on|off", "what the picture shows, in insets without perspective"},
    StyleKey{"layer-looks", "on|off", "off: ignore the cell's styles of layers"},
    StyleKey{"outlined", "PATH[#GROUP]", "an outline, also where the object is hidden", true},
    StyleKey{"wireframe", "PATH[#GROUP]", "triangle edges instead of surfaces", true},
    StyleKey{"transparent", "PATH[#GROUP][@OPACITY]", "see-through; default opacity 0.3", true},
    StyleKey{"collision", "PATH", "collision geometry instead of visuals", true},
    StyleKey{"collision-over", "PATH", "collision geometry over visuals", true},
    StyleKey{"trail", "PATH[@SECONDS]", "path of a device or link; default: the last 5 s", true},
    StyleKey{"axes", "PATH", "the axes of a link, of all of a device, or of all: *", true},
    StyleKey{"measure", "PATH@X,Y,Z~PATH@X,Y,Z", "the distance of two points of links", true},
    StyleKey{"lengths", "mm|m", "the unit of distances"},
};

Error badStyle(std::string what) { return Error{ErrorKind::bad_argument, std::move(what), {}}; }

/// Null when there is no such key.
const StyleKey* keyNamed(std::string_view key) {
  std::string name(key);
  std::replace(name.begin(), name.end(), '_', '-');
  const auto found = std::find_if(kKeys.begin(), kKeys.end(),
                                  [&](const StyleKey& one) { return one.key == name; });
  return found == kKeys.end() ? nullptr : &*found;
}

Error badValue(const StyleKey& key, std::string_view value) {
  return badStyle("`" + std::string(value) + "` is not a value of the style `" +
                  std::string(key.key) + "`: " + std::string(key.values));
}

template <class T>
bool choose(T& target, std::string_view value,
            std::initializer_list<std::pair<std::string_view, T>> words) {
  for (const auto& [word, meaning] : words) {
    if (value != word) continue;
    target = meaning;
    return true;
  }
  return false;
}

bool chooseSwitch(bool& target, std::string_view value) {
  return choose(target, value, {{"on", true}, {"true", true}, {"off", false}, {"false", false}});
}

bool chooseEdges(EdgeStyle& target, std::string_view value) {
  return choose(target, value,
                {{"off", EdgeStyle::none},
                 {"false", EdgeStyle::none},
                 {"on", EdgeStyle::over},
                 {"true", EdgeStyle::over},
                 {"only", EdgeStyle::only}});
}

/// Splits "PATH@REST" at the last `@`, which names cannot contain unencoded.
std::pair<std::string_view, std::string_view> splitAt(std::string_view value) {
  const std::size_t at = value.rfind('@');
  if (at == std::string_view::npos) return {value, {}};
  return {value.substr(0, at), value.substr(at + 1)};
}

template <class T>
void addOnce(std::vector<T>& list, T value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(std::move(value));
}

Status addTransparent(RenderStyle& style, const StyleKey& key, std::string_view value) {
  const auto [path, opacity] = splitAt(value);
  if (const auto fit = parseViewPath(path); !fit) return fit.error();
  TransparentStyle one{std::string(path)};
  if (path.size() != value.size()) {
    const char* end = opacity.data() + opacity.size();
    const auto [stopped, fault] = std::from_chars(opacity.data(), end, one.opacity);
    // Written so that NaN is refused.
    const bool fit = fault == std::errc() && stopped == end && one.opacity >= 0 && one.opacity <= 1;
    if (!fit) return badValue(key, value);
  }
  addOnce(style.transparent, std::move(one));
  return {};
}

Status addTrail(RenderStyle& style, const StyleKey& key, std::string_view value) {
  const auto [path, window] = splitAt(value);
  const auto named = parseViewPath(path);
  if (!named) return named.error();
  if (named->has_group || named->all_devices || named->path.is_layer) return badValue(key, value);
  TrailStyle one{std::string(path)};
  if (path.size() != value.size()) {
    const auto span = parseDuration(window);
    if (!span || span->count() <= 0 || *span > kLongestTrail) return badValue(key, value);
    one.window = *span;
  }
  addOnce(style.trails, std::move(one));
  return {};
}

Status addPath(std::vector<std::string>& list, std::string_view value) {
  if (const auto fit = parseViewPath(value); !fit) return fit.error();
  addOnce(list, std::string(value));
  return {};
}

/// Collision geometry belongs to a link: its groups are not those of the visuals.
Status addLink(std::vector<std::string>& list, const StyleKey& key, std::string_view value) {
  const auto path = parseViewPath(value);
  if (!path) return path.error();
  if (path->has_group) return badValue(key, value);
  addOnce(list, std::string(value));
  return {};
}

Status addMeasure(RenderStyle& style, const StyleKey& key, std::string_view value) {
  auto measure = parseMeasure(value);
  if (!measure) return badValue(key, value);
  addOnce(style.measures, std::move(*measure));
  return {};
}

std::string shortest(double number) {
  std::array<char, 32> text{};
  const auto [end, fault] = std::to_chars(text.data(), text.data() + text.size(), number);
  return fault == std::errc() ? std::string(text.data(), end) : std::string();
}

/// Sets or adds one value, independent of the others.
Status setOne(RenderStyle& style, const StyleKey& key, std::string_view value) {
  const std::string_view name = key.key;
  if (name == "outlined") return addPath(style.outlined, value);
  if (name == "wireframe") return addPath(style.wireframe, value);
  if (name == "collision") return addLink(style.collision, key, value);
  if (name == "collision-over") return addLink(style.collision_over, key, value);
  if (name == "transparent") return addTransparent(style, key, value);
  if (name == "trail") return addTrail(style, key, value);
  if (name == "axes") return addLink(style.frames, key, value);
  if (name == "measure") return addMeasure(style, key, value);

  bool fit = false;
  if (name == "shading") {
    fit =
        choose(style.shading, value, {{"standard", Shading::standard}, {"plain", Shading::plain}});
  } else if (name == "edges") {
    fit = chooseEdges(style.edges, value);
  } else if (name == "labels") {
    fit =
        choose(style.labels, value, {{"beside", LabelStyle::beside}, {"apart", LabelStyle::apart}});
  } else if (name == "ghosts") {
    fit = choose(style.ghosts, value, {{"plain", GhostStyle::plain}, {"clear", GhostStyle::clear}});
  } else if (name == "shadows") {
    fit = chooseSwitch(style.shadows, value);
  } else if (name == "contact") {
    fit = chooseSwitch(style.contact, value);
  } else if (name == "limits") {
    fit = chooseSwitch(style.limits, value);
  } else if (name == "clearance") {
    fit = chooseSwitch(style.clearance, value);
  } else if (name == "scale-bar") {
    fit = chooseSwitch(style.scale_bar, value);
  } else if (name == "camera-cone") {
    fit = chooseSwitch(style.camera_cone, value);
  } else if (name == "lengths") {
    fit =
        choose(style.lengths, value, {{"mm", LengthUnit::millimetres}, {"m", LengthUnit::metres}});
  } else if (name == "layer-looks") {
    fit = chooseSwitch(style.layer_looks, value);
  }
  if (!fit) return badValue(key, value);
  return {};
}

}  // namespace

std::span<const StyleKey> styleKeys() { return kKeys; }

Status setStyle(RenderStyle& style, std::string_view key_text, std::string_view value) {
  const StyleKey* key = keyNamed(key_text);
  if (key == nullptr) {
    std::string all;
    for (const StyleKey& one : kKeys) all += (all.empty() ? "" : ", ") + std::string(one.key);
    return badStyle("`" + std::string(key_text) + "` is not a style; the styles are: " + all);
  }
  const bool shadows = style.shadows;
  const bool contact = style.contact;
  const Shading shading = style.shading;
  Status set = setOne(style, *key, value);
  const bool changed =
      style.shadows != shadows || style.contact != contact || style.shading != shading;
  if (changed && style.shading == Shading::plain && (style.shadows || style.contact)) {
    const std::string_view what = style.shadows ? "shadows" : "contact";
    style.shadows = shadows;
    style.contact = contact;
    style.shading = shading;
    return badStyle("plain shading draws no " + std::string(what) +
                    ": leave out one of the two styles");
  }
  return set;
}

Status setStyle(RenderStyle& style, std::string_view word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) return setStyle(style, word, "on");
  return setStyle(style, word.substr(0, equals), word.substr(equals + 1));
}

std::vector<std::pair<std::string, std::string>> styleWords(const RenderStyle& style) {
  const RenderStyle plain;
  std::vector<std::pair<std::string, std::string>> words;
  const auto say = [&](const char* key, std::string value) {
    words.emplace_back(key, std::move(value));
  };
  if (style.shading != plain.shading) say("shading", "plain");
  if (style.shadows && style.shading == Shading::standard) say("shadows", "on");
  if (style.contact && style.shading == Shading::standard) say("contact", "on");
  if (style.edges != plain.edges) say("edges", style.edges == EdgeStyle::only ? "only" : "on");
  if (style.labels != plain.labels) say("labels", "apart");
  if (style.ghosts != plain.ghosts) say("ghosts", "clear");
  if (style.limits) say("limits", "on");
  if (style.clearance) say("clearance", "on");
  if (style.scale_bar) say("scale-bar", "on");
  if (style.camera_cone) say("camera-cone", "on");
  if (!style.layer_looks) say("layer-looks", "off");
  for (const std::string& path : style.outlined) say("outlined", path);
  for (const std::string& path : style.wireframe) say("wireframe", path);
  for (const TransparentStyle& one : style.transparent) {
    say("transparent", one.path + "@" + shortest(one.opacity));
  }
  for (const std::string& path : style.collision) say("collision", path);
  for (const std::string& path : style.collision_over) say("collision-over", path);
  for (const TrailStyle& one : style.trails) {
    say("trail", one.path + "@" + secondsText(one.window) + "s");
  }
  for (const std::string& path : style.frames) say("axes", path);
  for (const MeasureStyle& one : style.measures) say("measure", measureText(one));
  if (style.lengths != plain.lengths) say("lengths", "m");
  return words;
}

}  // namespace rocinante
