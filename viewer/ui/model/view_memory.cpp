#include "viewer/ui/model/view_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/atomic_file.h"
#include "core/base/plain_text.h"
#include "core/document/toml_table.h"
#include "viewer/view/view_layout.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxBytes = 1U << 20U;
constexpr int kLeastSize = 64;
constexpr int kMaxSize = 8192;

bool canBeWritten(const fs::path& path) {
  return isUtf8(std::as_bytes(std::span(path.native().data(), path.native().size())));
}

std::optional<fs::path> absoluteVariable(const char* name) {
  const char* const value = std::getenv(name);
  if (value == nullptr || value[0] != '/') return std::nullopt;
  return fs::path(value);
}

}  // namespace

void ViewMemory::shown(const RecentContent& content) {
  std::erase(recent, content);
  recent.insert(recent.begin(), content);
  recent.resize(std::min(recent.size(), kMaxRecent));
}

void ViewMemory::keepPanels(const fs::path& cell, std::map<std::string, PanelPlace> panels) {
  std::erase_if(cells, [&](const CellMemory& one) { return one.cell == cell; });
  if (!panels.empty()) cells.insert(cells.begin(), {cell, std::move(panels)});
  cells.resize(std::min(cells.size(), kMaxCells));
}

const std::map<std::string, PanelPlace>* ViewMemory::panelsOf(const fs::path& cell) const {
  const auto found = std::ranges::find(cells, cell, &CellMemory::cell);
  return found == cells.end() ? nullptr : &found->panels;
}

std::string ViewMemory::text() const {
  std::string text = "# What rocinante view remembers; --fresh ignores it.\nformat = 1\n";
  text += fmt::format("theme = \"{}\"\n", theme == Theme::dark ? "dark" : "light");
  if (wall_clock) text += "clock = \"day\"\n";
  if (width > 0) text += fmt::format("size = [{}, {}]\n", width, height);
  for (const RecentContent& one : recent) {
    if (!canBeWritten(one.cell) || !canBeWritten(one.log)) continue;
    text += "\n[[recent]]\n";
    if (!one.cell.empty()) text += "cell = " + tomlText(one.cell.string()) + "\n";
    if (!one.log.empty()) text += "log = " + tomlText(one.log.string()) + "\n";
  }
  for (const CellMemory& one : cells) {
    if (one.cell.empty() || !canBeWritten(one.cell)) continue;
    text += "\n[[cell]]\nfile = " + tomlText(one.cell.string()) + "\n";
    for (const auto& [name, place] : one.panels) {
      text += "[[cell.panel]]\n" + panelText(name, place);
    }
  }
  return text;
}

Result<ViewMemory> ViewMemory::parse(std::string_view text, const std::string& file) {
  const auto document = parseToml(text, file);
  if (!document.ok()) return document.error();
  Findings findings;
  ViewMemory memory;
  {
    FaultList faults(findings, file);
    TomlTable root(*document, "the file", faults);
    if (root.number("format").value_or(0) != 1) {
      root.error("view.memory", "format", "the format is not 1");
    }
    const std::string theme = root.text("theme").value_or("dark");
    if (theme != "dark" && theme != "light") {
      root.error("view.memory", "theme", "the theme is neither dark nor light");
    }
    const std::string clock = root.text("clock").value_or("session");
    if (clock != "session" && clock != "day") {
      root.error("view.memory", "clock", "the clock is neither session nor day");
    }
    memory.wall_clock = clock == "day";
    memory.theme = theme == "light" ? Theme::light : Theme::dark;
    if (const auto size = root.pair("size")) {
      const auto side = [](double length) {
        return static_cast<int>(std::clamp(length, double{kLeastSize}, double{kMaxSize}));
      };
      memory.width = side(size->x);
      memory.height = side(size->y);
    }
    for (TomlTable& table : root.tables("recent", "[[recent]]")) {
      RecentContent one;
      one.cell = table.text("cell").value_or("");
      one.log = table.text("log").value_or("");
      table.finish();
      if (one == RecentContent()) continue;
      if (memory.recent.size() < kMaxRecent) memory.recent.push_back(std::move(one));
    }
    for (TomlTable& table : root.tables("cell", "[[cell]]")) {
      CellMemory one;
      one.cell = table.text("file").value_or("");
      for (TomlTable& panel : table.tables("panel", "[[cell.panel]]")) {
        one.panels.insert(readPanel(panel));
      }
      table.finish();
      if (one.cell.empty()) continue;
      if (memory.cells.size() < kMaxCells) memory.cells.push_back(std::move(one));
    }
    root.finish();
  }
  if (const Finding* fault = firstError(findings)) {
    return Error{ErrorKind::damaged, fault->text, fault->place()};
  }
  return memory;
}

fs::path ViewMemory::fileOfUser() {
  if (const auto config = absoluteVariable("XDG_CONFIG_HOME")) {
    return *config / "rocinante" / "view.toml";
  }
  if (const auto home = absoluteVariable("HOME")) {
    return *home / ".config" / "rocinante" / "view.toml";
  }
  return {};
}

Result<ViewMemory> ViewMemory::load(const fs::path& file) {
  std::error_code unknown;
  if (file.empty() || !fs::exists(file, unknown)) return ViewMemory();
  const auto text = readFile(file, kMaxBytes);
  if (!text.ok()) return text.error();
  return parse(*text, file.string());
}

Status ViewMemory::save(const fs::path& file) const {
  std::error_code fault;
  fs::create_directories(file.parent_path(), fault);
  if (fault) {
    return Error{ErrorKind::refused, "cannot make the folder: " + fault.message(),
                 file.parent_path().string()};
  }
  const std::string bytes = text();
  return writeFileWhole(file, std::as_bytes(std::span(bytes)), true, Sync::later);
}

}  // namespace rocinante
