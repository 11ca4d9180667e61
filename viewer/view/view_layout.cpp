#include "viewer/view/view_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/atomic_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxBytes = 1U << 20U;
constexpr double kMaxUnits = 1e5;
constexpr std::size_t kMaxPanels = 64;
constexpr std::size_t kMaxInsets = 64;
constexpr std::size_t kMaxPlots = 64;  // a window and a page have room for fewer

float units(TomlTable& table, std::string_view key) {
  const double given = table.number(key).value_or(0);
  return std::isfinite(given) ? static_cast<float>(std::clamp(given, 0.0, kMaxUnits)) : 0;
}

std::string listText(const std::vector<std::string>& texts) {
  std::string list = "[";
  for (const std::string& text : texts) list += (list.size() > 1 ? ", " : "") + tomlText(text);
  return list + "]";
}

void readPlots(TomlTable& root, ViewLayout& layout) {
  if (!root.has("plots")) return;
  ViewLayout::Plots plots;
  plots.values = root.texts("plots");
  if (plots.values.size() > kMaxPlots) {
    root.error("view.layout", "plots", fmt::format("there are more than {} plots", kMaxPlots));
  }
  if (root.has("plots_height")) plots.height = units(root, "plots_height");
  plots.hidden = root.flag("plots_hidden").value_or(false);
  layout.plots = std::move(plots);
}

}  // namespace

std::string panelText(const std::string& name, const PanelPlace& place) {
  std::string text = "name = " + tomlText(name) + "\n";
  if (place.moved) {
    text += fmt::format("{} = {:.1f}\n{} = {:.1f}\n", place.from_right ? "right" : "left",
                        place.across, place.from_bottom ? "bottom" : "top", place.down);
  }
  if (place.width > 0) text += fmt::format("width = {:.1f}\n", place.width);
  if (place.collapsed) text += "collapsed = true\n";
  return text;
}

std::pair<std::string, PanelPlace> readPanel(TomlTable& table) {
  PanelPlace place;
  const std::string name = table.requiredText("name").value_or("");
  const auto left = table.has("left");
  const auto right = table.has("right");
  const auto top = table.has("top");
  place.moved = left || right;
  place.from_right = !left && right;
  place.from_bottom = !top && table.has("bottom");
  place.across = units(table, place.from_right ? "right" : "left");
  place.down = units(table, place.from_bottom ? "bottom" : "top");
  place.width = units(table, "width");
  place.collapsed = table.flag("collapsed").value_or(false);
  table.finish();
  return {name, place};
}

std::string ViewLayout::text() const {
  std::string text =
      "# A layout of rocinante view: --layout, or the command `layout`.\nformat = 1\n";
  if (is_light) text += fmt::format("theme = \"{}\"\n", *is_light ? "light" : "dark");
  if (!camera.empty()) text += "camera = " + tomlText(camera) + "\n";
  if (plots) {
    text +=
        fmt::format("plots = {}\nplots_height = {:.1f}\n", listText(plots->values), plots->height);
    if (plots->hidden) text += "plots_hidden = true\n";
  }
  if (insets) text += "insets = " + listText(*insets) + "\n";
  for (const auto& [name, place] : panels) text += "\n[[panel]]\n" + panelText(name, place);
  return text;
}

Result<ViewLayout> ViewLayout::parse(std::string_view text, const std::string& file) {
  const auto document = parseToml(text, file);
  if (!document.ok()) return document.error();
  Findings findings;
  ViewLayout layout;
  {
    FaultList faults(findings, file);
    TomlTable root(*document, "the layout", faults);
    if (root.number("format").value_or(0) != 1) {
      root.error("view.layout", "format", "the format is not 1");
    }
    if (const auto theme = root.text("theme")) {
      layout.is_light = *theme == "light";
      if (*theme != "light" && *theme != "dark") {
        root.error("view.layout", "theme", "the theme is neither dark nor light");
      }
    }
    layout.camera = root.text("camera").value_or("");
    readPlots(root, layout);
    if (root.has("insets")) layout.insets = root.texts("insets");
    if (layout.insets && layout.insets->size() > kMaxInsets) {
      root.error("view.layout", "insets", fmt::format("there are more than {} insets", kMaxInsets));
    }
    for (TomlTable& panel : root.tables("panel", "[[panel]]")) {
      if (layout.panels.size() >= kMaxPanels) {
        panel.error("view.layout", "name",
                    fmt::format("there are more than {} panels", kMaxPanels));
        break;
      }
      layout.panels.insert(readPanel(panel));
    }
    root.finish();
  }
  if (const Finding* fault = firstError(findings)) {
    return Error{ErrorKind::damaged, fault->text, fault->place()};
  }
  return layout;
}

Result<ViewLayout> ViewLayout::load(const fs::path& file) {
  const auto text = readFile(file, kMaxBytes);
  if (!text.ok()) return text.error();
  return parse(*text, file.string());
}

Status ViewLayout::save(const fs::path& file) const {
  std::error_code unknown;
  if (fs::exists(file, unknown)) {
    if (const auto before = load(file); !before.ok()) {
      return Error{ErrorKind::refused, "this file is no layout: " + before.error().what,
                   file.string()};
    }
  }
  const std::string bytes = text();
  return writeFileWhole(file, std::as_bytes(std::span(bytes)), true);
}

}  // namespace rocinante
