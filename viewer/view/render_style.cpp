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

Error badStyle(std::string what) { return Error{ErrorKind::bad_argument, std::move(what), {}}; }

Error badValue(const StyleKey& key, std::string_view value) {
  return badStyle("`" + std::string(value) + "` is not a value of the style `" +
                  std::string(key.key) + "`: " + std::string(key.values));
}

/// Splits "PATH@REST" at the last `@`, which names cannot contain unencoded.
std::pair<std::string_view, std::string_view> splitAt(std::string_view value) {
  const std::size_t at = value.rfind('@');
  if (at == std::string_view::npos) return {value, {}};
  return {value.substr(0, at), value.substr(at + 1)};
}

Result<TransparentStyle> transparentOf(const StyleKey& key, std::string_view value) {
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
  return one;
}

Result<TrailStyle> trailOf(const StyleKey& key, std::string_view value) {
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
  return one;
}

Result<std::string> pathOf(const StyleKey&, std::string_view value) {
  if (const auto fit = parseViewPath(value); !fit) return fit.error();
  return std::string(value);
}

/// Collision geometry belongs to a link: its groups are not those of the visuals.
Result<std::string> linkOf(const StyleKey& key, std::string_view value) {
  const auto path = parseViewPath(value);
  if (!path) return path.error();
  if (path->has_group) return badValue(key, value);
  return std::string(value);
}

Result<MeasureStyle> measureOf(const StyleKey& key, std::string_view value) {
  auto measure = parseMeasure(value);
  if (!measure) return badValue(key, value);
  return std::move(*measure);
}

std::string shortest(double number) {
  std::array<char, 32> text{};
  const auto [end, fault] = std::to_chars(text.data(), text.data() + text.size(), number);
  return fault == std::errc() ? std::string(text.data(), end) : std::string();
}

std::string valueOf(const std::string& path) { return path; }
std::string valueOf(const TransparentStyle& one) { return one.path + "@" + shortest(one.opacity); }
std::string valueOf(const TrailStyle& one) {
  return one.path + "@" + secondsText(one.window) + "s";
}
std::string valueOf(const MeasureStyle& one) { return measureText(one); }

/// A key, how one of its values is set or added, and all that differ from the default's.
struct StyleRow {
  StyleKey key;
  Status (*set)(RenderStyle& style, const StyleKey& key, std::string_view value);
  std::vector<std::string> (*values)(const RenderStyle& style);
};

/// A word for a value; of several for one value, the first is written.
template <class T>
struct Choice {
  std::string_view word;
  T value;
};

constexpr Choice<bool> kSwitch[] = {{"on", true}, {"true", true}, {"off", false}, {"false", false}};
constexpr Choice<Shading> kShadings[] = {{"standard", Shading::standard},
                                         {"plain", Shading::plain}};
constexpr Choice<EdgeStyle> kEdges[] = {{"on", EdgeStyle::over},
                                        {"true", EdgeStyle::over},
                                        {"only", EdgeStyle::only},
                                        {"off", EdgeStyle::none},
                                        {"false", EdgeStyle::none}};
constexpr Choice<LabelStyle> kLabels[] = {{"beside", LabelStyle::beside},
                                          {"apart", LabelStyle::apart}};
constexpr Choice<GhostStyle> kGhosts[] = {{"plain", GhostStyle::plain},
                                          {"clear", GhostStyle::clear}};
constexpr Choice<LengthUnit> kLengths[] = {{"mm", LengthUnit::millimetres},
                                           {"m", LengthUnit::metres}};

/// One of a few values.
template <auto kMember, const auto& kChoices = kSwitch>
constexpr StyleRow oneOf(std::string_view key, std::string_view values, std::string_view means) {
  return {{key, values, means},
          [](RenderStyle& style, const StyleKey& of, std::string_view value) -> Status {
            for (const auto& choice : kChoices) {
              if (choice.word != value) continue;
              style.*kMember = choice.value;
              return {};
            }
            return badValue(of, value);
          },
          [](const RenderStyle& style) -> std::vector<std::string> {
            if (style.*kMember == RenderStyle().*kMember) return {};
            for (const auto& choice : kChoices) {
              if (choice.value == style.*kMember) return {std::string(choice.word)};
            }
            return {};
          }};
}

/// Any number of what `kRead` reads.
template <auto kMember, auto kRead>
constexpr StyleRow listOf(std::string_view key, std::string_view values, std::string_view means) {
  return {{key, values, means, true},
          [](RenderStyle& style, const StyleKey& of, std::string_view value) -> Status {
            auto one = kRead(of, value);
            if (!one) return one.error();
            auto& all = style.*kMember;
            if (std::ranges::find(all, *one) == all.end()) all.push_back(std::move(*one));
            return {};
          },
          [](const RenderStyle& style) {
            std::vector<std::string> all;
            for (const auto& one : style.*kMember) all.push_back(valueOf(one));
            return all;
          }};
}

constexpr std::array kRows{
    oneOf<&RenderStyle::shading, kShadings>("shading", "standard|plain",
                                            "plain: one light and even ambient light"),
    oneOf<&RenderStyle::shadows>("shadows", "on|off", "shadows of the key light"),
    oneOf<&RenderStyle::contact>("contact", "on|off", "darker where surfaces are near each other"),
    oneOf<&RenderStyle::edges, kEdges>("edges", "on|only|off", "crisp edges; only: a line drawing"),
    oneOf<&RenderStyle::labels, kLabels>("labels", "beside|apart",
                                         "apart: labels that do not cover each other"),
    oneOf<&RenderStyle::ghosts, kGhosts>("ghosts", "plain|clear",
                                         "clear: ghosts in one tone, behind the actual device"),
    oneOf<&RenderStyle::limits>("limits", "on|off",
                                "links near a joint's limit amber, beyond it red"),
    oneOf<&RenderStyle::clearance>("clearance", "on|off",
                                   "distances of links that `check` judges, red where too near"),
    oneOf<&RenderStyle::scale_bar>("scale-bar", "on|off",
                                   "a scale bar, true at the camera's target"),
    oneOf<&RenderStyle::camera_cone>("camera-cone", "on|off",
                                     "what the picture shows, in insets without perspective"),
    oneOf<&RenderStyle::layer_looks>("layer-looks", "on|off",
                                     "off: ignore the cell's styles of layers"),
    listOf<&RenderStyle::outlined, pathOf>("outlined", "PATH[#GROUP]",
                                           "an outline, also where the object is hidden"),
    listOf<&RenderStyle::wireframe, pathOf>("wireframe", "PATH[#GROUP]",
                                            "triangle edges instead of surfaces"),
    listOf<&RenderStyle::transparent, transparentOf>("transparent", "PATH[#GROUP][@OPACITY]",
                                                     "see-through; default opacity 0.3"),
    listOf<&RenderStyle::collision, linkOf>("collision", "PATH",
                                            "collision geometry instead of visuals"),
    listOf<&RenderStyle::collision_over, linkOf>("collision-over", "PATH",
                                                 "collision geometry over visuals"),
    listOf<&RenderStyle::trails, trailOf>("trail", "PATH[@SECONDS]",
                                          "path of a device or link; default: the last 5 s"),
    listOf<&RenderStyle::frames, linkOf>("axes", "PATH",
                                         "the axes of a link, of all of a device, or of all: *"),
    listOf<&RenderStyle::measures, measureOf>("measure", "PATH@X,Y,Z~PATH@X,Y,Z",
                                              "the distance of two points of links"),
    oneOf<&RenderStyle::lengths, kLengths>("lengths", "mm|m", "the unit of distances"),
};

constexpr auto kKeys = [] {
  std::array<StyleKey, kRows.size()> keys;
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = kRows[i].key;
  return keys;
}();

/// Null when there is no such key.
const StyleRow* rowNamed(std::string_view key) {
  std::string name(key);
  std::ranges::replace(name, '_', '-');
  const auto found =
      std::ranges::find(kRows, name, [](const StyleRow& row) { return row.key.key; });
  return found == kRows.end() ? nullptr : &*found;
}

}  // namespace

std::span<const StyleKey> styleKeys() { return kKeys; }

Status setStyle(RenderStyle& style, std::string_view key_text, std::string_view value) {
  const StyleRow* const row = rowNamed(key_text);
  if (row == nullptr) {
    std::string all;
    for (const StyleKey& one : kKeys) all += (all.empty() ? "" : ", ") + std::string(one.key);
    return badStyle("`" + std::string(key_text) + "` is not a style; the styles are: " + all);
  }
  const bool shadows = style.shadows;
  const bool contact = style.contact;
  const Shading shading = style.shading;
  Status set = row->set(style, row->key, value);
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
  RenderStyle drawn = style;
  if (style.shading == Shading::plain) drawn.shadows = drawn.contact = false;
  std::vector<std::pair<std::string, std::string>> words;
  for (const StyleRow& row : kRows) {
    for (std::string& value : row.values(drawn)) {
      words.emplace_back(row.key.key, std::move(value));
    }
  }
  return words;
}

}  // namespace rocinante
