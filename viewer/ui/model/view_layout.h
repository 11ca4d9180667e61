#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/toml_table.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// What a window shows and where, as a file that people share: NAME.layout.toml
/// (docs/programs/view.md, "Layouts"). A plain value; what it does not say stays as it is.
struct ViewLayout {
  std::optional<bool> is_light;
  std::string camera;  ///< empty: not said
  std::map<std::string, PanelPlace> panels;
  struct Plots {
    std::vector<std::string> values;  ///< as the command `plot` takes them
    float height = 200;               ///< in interface units
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

ViewLayout layoutOf(const ViewModel& model);
/// Returns what of it this window does not have, a sentence each.
std::vector<std::string> applyLayout(const ViewLayout& layout, ViewModel& model);

/// One panel's place as a table's lines, and back: its name with what it says.
std::string panelText(const std::string& name, const PanelPlace& place);
std::pair<std::string, PanelPlace> readPanel(TomlTable& table);

}  // namespace rocinante
