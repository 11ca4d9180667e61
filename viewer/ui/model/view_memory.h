#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "viewer/ui/model/open_state.h"
#include "viewer/ui/model/panel_places.h"

namespace rocinante {

enum class Theme { dark, light };

/// Where the panels lie over a cell.
struct CellMemory {
  std::filesystem::path cell;
  std::map<std::string, PanelPlace> panels;
};

/// What the window remembers of a user from one run to the next (docs/programs/view.md): kept in
/// XDG_CONFIG_HOME/rocinante/view.toml, else HOME/.config/rocinante/view.toml.
struct ViewMemory {
  static constexpr std::size_t kMaxRecent = 12;
  static constexpr std::size_t kMaxCells = 50;

  Theme theme = Theme::dark;
  bool wall_clock = false;            ///< the time line has the time of day, too
  int width = 0, height = 0;          ///< of the window; 0: never said
  std::vector<RecentContent> recent;  ///< newest first
  std::vector<CellMemory> cells;      ///< newest first

  /// Puts it first among the recent ones.
  void shown(const RecentContent& content);
  void keepPanels(const std::filesystem::path& cell, std::map<std::string, PanelPlace> panels);
  const std::map<std::string, PanelPlace>* panelsOf(const std::filesystem::path& cell) const;

  /// As the file has it; names that are not UTF-8 are left out.
  std::string text() const;
  /// damaged with FILE:LINE:COLUMN when it is not TOML or says something else.
  static Result<ViewMemory> parse(std::string_view text, const std::string& file);

  /// Empty when neither folder is an absolute path.
  static std::filesystem::path fileOfUser();
  /// What the file says; nothing remembered when there is none.
  static Result<ViewMemory> load(const std::filesystem::path& file);
  /// Makes the folder if need be.
  Status save(const std::filesystem::path& file) const;
};

}  // namespace rocinante
