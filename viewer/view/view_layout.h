#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/document/toml_table.h"
#include "viewer/view/panel_place.h"

namespace rocinante {

/// What a window shows and where, as a file that people share: NAME.layout.toml
/// (docs/programs/view.md, "Layouts"); a page begins with it, too. A plain value; what it does not
/// say stays as it is, but for panels: those that it does not name stand at their edges.
struct ViewLayout {
  std::optional<bool> is_light;
  std::string camera;  ///< empty: not said
  std::map<std::string, PanelPlace> panels;
  struct Plots {
    /// As the command `plot` takes them: VALUE, or `VALUE over VALUE`. Not looked into.
    std::vector<std::string> values;
    float height = 200;  ///< in interface units
    bool hidden = false;
  };
  std::optional<Plots> plots;
  std::optional<std::vector<std::string>> insets;  ///< as parseInset() takes them

  std::string text() const;
  /// damaged, with its place, for what is no layout.
  static Result<ViewLayout> parse(std::string_view text, const std::string& file);
  static Result<ViewLayout> load(const std::filesystem::path& file);
  /// Replaces a layout; refused for a file that is none.
  Status save(const std::filesystem::path& file) const;
};

/// One panel's place as a table's lines, and back: its name with what it says.
std::string panelText(const std::string& name, const PanelPlace& place);
std::pair<std::string, PanelPlace> readPanel(TomlTable& table);

}  // namespace rocinante
