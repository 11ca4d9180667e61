#include "golden/suite/suite_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/duration_text.h"

namespace rocinante {
namespace {

constexpr int kMaxPictureSide = 8192;
constexpr int kMaxGrowPx = 64;

std::optional<Nanoseconds> durationOf(SuiteTable& table, std::string_view key) {
  const auto text = table.text(key);
  if (!text) return std::nullopt;
  const auto duration = parseDuration(*text);
  if (duration.ok()) return *duration;
  table.complain(*table.node(key), fmt::format("`{}` must be a duration, such as \"0.5s\"", key));
  return std::nullopt;
}

void readMoment(SuiteTable& table, SuiteCase& made) {
  CaseMoment& moment = made.moment;
  moment.at = table.text("at");
  moment.event = table.text("event");
  moment.events = table.text("events");
  moment.every = durationOf(table, "every");
  if (moment.every && *moment.every <= Nanoseconds(0)) {
    table.complain(*table.node("every"), "`every` must be a duration above zero, such as \"0.5s\"");
  }
  if (const auto after = durationOf(table, "after")) {
    moment.after = *after;
    if (!moment.event && !moment.events) {
      table.complain(*table.node("after"), "`after` needs `event` or `events`");
    }
  }
  if (const auto occurrence = table.integer("occurrence")) {
    if (!moment.event || *occurrence == 0 || std::abs(*occurrence) > 1'000'000) {
      table.complain(*table.node("occurrence"),
                     "`occurrence` needs `event` and is 1 for the first, -1 for the last");
    } else {
      moment.occurrence = static_cast<int>(*occurrence);
    }
  }
  const auto given = std::ranges::count_if(
      std::initializer_list<std::string_view>{"at", "event", "events", "every"},
      [&](std::string_view key) { return table.has(key); });
  if (given > 1)
    table.complainHere("a case can have only one of `at`, `event`, `events` and `every`");
}

/// The whole numbers of a list of exactly `count`; empty for anything else.
template <std::size_t count>
std::optional<std::array<int, count>> wholeNumbers(const TomlNode& node, int least, int most) {
  std::array<int, count> numbers{};
  if (node.kind != TomlNode::Kind::array || node.items.size() != count) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    const TomlNode& item = node.items[i];
    if (item.kind != TomlNode::Kind::integer || item.integer < least || item.integer > most) {
      return std::nullopt;
    }
    numbers[i] = static_cast<int>(item.integer);
  }
  return numbers;
}

void readArea(SuiteTable& owner, const TomlNode& node, std::string_view key,
              std::vector<PictureArea>& areas) {
  PictureArea area;
  if (node.kind == TomlNode::Kind::text) {
    area.path = node.text;
  } else if (node.kind == TomlNode::Kind::table) {
    SuiteTable table(node, owner.file(), owner.fault());
    table.onlyKeys({"path", "rectangle", "grow"});
    area.path = table.text("path").value_or("");
    if (const TomlNode* rectangle = table.node("rectangle")) {
      const auto sides = wholeNumbers<4>(*rectangle, 0, kMaxPictureSide);
      if (sides && (*sides)[2] > 0 && (*sides)[3] > 0) {
        area.rectangle = MaskRectangle{(*sides)[0], (*sides)[1], (*sides)[2], (*sides)[3]};
      } else {
        table.complain(*rectangle, "`rectangle` must be [x, y, width, height] in pixels");
      }
    }
    const auto grow = table.integer("grow").value_or(0);
    if (grow < 0 || grow > kMaxGrowPx) {
      table.complain(*table.node("grow"), fmt::format("`grow` must be 0 to {} pixels", kMaxGrowPx));
    } else {
      area.grow_px = static_cast<int>(grow);
    }
    if (table.has("path") == table.has("rectangle")) {
      table.complainHere("an area needs either a `path` or a `rectangle`");
    }
  } else {
    owner.complain(node, fmt::format("`{}` must be a list of PATHs and of {{ path = ... }} or {{ "
                                     "rectangle = [x, y, width, height] }}",
                                     key));
  }
  if (!area.rectangle && (area.path == "layer/grid" || area.path == "layer/gnomon")) {
    owner.complain(node, fmt::format("`hide` {} instead: it then needs no mask", area.path));
  } else if (!area.rectangle && area.path.empty()) {
    owner.complain(node,
                   "an area's PATH must be DEVICE, DEVICE/LINK, layer/NAME or drawing/SOURCE/ID");
  }
  areas.push_back(std::move(area));
}

void readAreas(SuiteTable& table, std::string_view key, std::vector<PictureArea>& areas) {
  const TomlNode* node = table.node(key);
  if (node == nullptr) return;
  areas.clear();
  if (node->kind != TomlNode::Kind::array) {
    readArea(table, *node, key, areas);
    return;
  }
  for (const TomlNode& item : node->items) readArea(table, item, key, areas);
}

/// One value of a style table as text.
std::optional<std::string> styleValue(const TomlNode& node) {
  switch (node.kind) {
    case TomlNode::Kind::text:
      return node.text;
    case TomlNode::Kind::flag:
      return std::string(node.flag ? "on" : "off");
    case TomlNode::Kind::integer:
      return std::to_string(node.integer);
    case TomlNode::Kind::number:
      return fmt::format("{}", node.number);
    default:
      return std::nullopt;
  }
}

void readStyle(SuiteTable& table, RenderStyle& style) {
  const TomlNode* node = table.table("style");
  if (node == nullptr) return;
  style = {};
  const auto set = [&](const std::string& key, const TomlNode& value) {
    const auto text = styleValue(value);
    if (!text) {
      table.complain(value, fmt::format("`{}` of a style must be a string, true or false", key));
    } else if (auto done = setStyle(style, key, *text); !done) {
      table.complain(value, done.error().what);
    }
  };
  for (const TomlNode::Entry& entry : node->entries) {
    if (entry.key.starts_with("x-")) continue;
    if (entry.value.kind != TomlNode::Kind::array) {
      set(entry.key, entry.value);
      continue;
    }
    for (const TomlNode& item : entry.value.items) set(entry.key, item);
  }
}

/// true: the cell's; false: none; or a list of them.
void readInsets(SuiteTable& table, SuiteCase& made) {
  const TomlNode* node = table.node("insets");
  if (node == nullptr) return;
  const bool is_list = node->kind == TomlNode::Kind::array;
  const auto words = is_list ? table.texts("insets") : std::vector<std::string>();
  auto insets = parseInsets(words, is_list || !table.flag("insets").value_or(true));
  if (!insets.ok()) return table.complain(*node, insets.error().what);
  made.insets = std::move(*insets);
}

void readTolerance(SuiteTable& table, const Suite& suite, SuiteCase& made) {
  const TomlNode* node = table.node("tolerance");
  if (node == nullptr) return;
  made.limit_from = table.lineOf(*node);
  if (node->kind == TomlNode::Kind::table) {
    SuiteTable limits(*node, table.file(), table.fault());
    made.tolerance = readLimits(limits, "own limits");
    return;
  }
  const auto name = table.text("tolerance");
  if (!name) return;
  if (const auto own = suite.tolerances.find(*name); own != suite.tolerances.end()) {
    made.tolerance = own->second;
    made.limit_from = fmt::format("[tolerance.{}], {}", *name, made.limit_from);
    return;
  }
  const auto tolerance = Tolerance::named(*name);
  if (tolerance.ok()) {
    made.tolerance = *tolerance;
    return;
  }
  std::string own_names;
  for (const auto& [own, limits] : suite.tolerances) own_names += fmt::format("\"{}\", ", own);
  table.complain(*node,
                 fmt::format("`tolerance` must be {}\"exact\", \"rounding\", \"cpu\", \"loose\" or "
                             "{{ tile_mean = ..., tile_over = ... }}",
                             own_names));
}

void readExpectation(SuiteTable& table, SuiteCase& made) {
  const auto expect = table.text("expect");
  const auto reason = table.text("reason");
  made.reason = reason.value_or("");
  if (!expect) {
    if (reason) table.complain(*table.node("reason"), "`reason` needs `expect`");
    return;
  }
  made.expect_different = *expect == "different";
  if (*expect != "different" && *expect != "same") {
    table.complain(*table.node("expect"), "`expect` must be \"same\" or \"different\"");
  } else if (made.expect_different && made.reason.empty()) {
    table.complain(*table.node("expect"),
                   "a case that expects a difference needs `reason = \"...\"`");
  }
}

}  // namespace

bool isFileText(std::string_view text) {
  return std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
}

bool isCaseName(std::string_view name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' && name.front() != '-' &&
         isFileText(name);
}

Tolerance readLimits(SuiteTable& table, std::string name) {
  table.onlyKeys({"tile_mean", "tile_over"});
  Tolerance made{std::move(name), false, table.number("tile_mean").value_or(0),
                 table.integer("tile_over").value_or(0)};
  if (!(made.tile_mean >= 0 && made.tile_mean <= 255) || made.tile_over < 0 ||
      made.tile_over > 256) {
    table.complainHere("tile_mean must be 0 to 255, tile_over 0 to 256");
  }
  return made;
}

void readCaseLook(SuiteTable& table, const Suite& suite, SuiteCase& made) {
  if (table.has("camera")) made.cameras = table.textOrTexts("camera");
  if (const TomlNode* size = table.node("size")) {
    if (const auto sides = wholeNumbers<2>(*size, 1, kMaxPictureSide)) {
      made.width = (*sides)[0];
      made.height = (*sides)[1];
    } else {
      table.complain(*size, "`size` must be [width, height], each from 1 to 8192");
    }
  }
  if (const auto samples = table.integer("samples")) {
    if (*samples != 1 && *samples != 2 && *samples != 4 && *samples != 8) {
      table.complain(*table.node("samples"), "`samples` must be 1, 2, 4 or 8");
    }
    made.samples = static_cast<int>(*samples);
  }
  if (table.has("layers")) made.layers = table.texts("layers");
  if (table.has("hide")) made.hide = table.texts("hide");
  if (table.has("show")) made.show = table.texts("show");
  if (table.has("tags")) made.tags = table.texts("tags");
  if (const auto scale = table.number("scale")) {
    if (!(*scale >= kLeastScale && *scale <= kLargestScale)) {
      table.complain(*table.node("scale"),
                     fmt::format("`scale` must be {} to {}", kLeastScale, kLargestScale));
    }
    made.scale = *scale;
  }
  readInsets(table, made);
  made.panel = table.flag("panel").value_or(made.panel);
  readStyle(table, made.style);
  readAreas(table, "mask", made.mask);
  readAreas(table, "judge_only", made.judge_only);
  readTolerance(table, suite, made);
  if (table.has("tolerance")) made.across_keys = made.tolerance;
}

void readDefaults(SuiteTable& table, const Suite& suite, SuiteCase& made) {
  table.onlyKeys({"camera", "size", "scale", "samples", "layers", "hide", "show", "insets", "panel",
                  "style", "mask", "judge_only", "tolerance", "tags"});
  readCaseLook(table, suite, made);
  if (table.has("tolerance")) made.limit_from = "[defaults], " + made.limit_from;
}

void readCase(SuiteTable& table, const Suite& suite, SuiteCase& made) {
  table.onlyKeys({"name",       "at",        "event",  "occurrence", "after",   "events",
                  "every",      "camera",    "size",   "scale",      "samples", "layers",
                  "hide",       "show",      "insets", "panel",      "style",   "mask",
                  "judge_only", "tolerance", "expect", "reason",     "tags"});
  made.name = table.text("name").value_or("");
  if (!isCaseName(made.name)) {
    table.complainHere("a case needs a `name` of at most 100 letters, digits, `_`, `-` and `.`");
  }
  readMoment(table, made);
  readCaseLook(table, suite, made);
  readExpectation(table, made);
}

}  // namespace rocinante
