#include <fmt/format.h>

#include <algorithm>

#include "core/cell/cell_sections.h"
#include "core/cell/disabled_collisions.h"
#include "core/document/fault_list.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxClearances = 256, kMaxExceptions = 256;
constexpr double kMaxLeast_m = 1000;

bool isPattern(std::string_view text) {
  return text.find_first_of("*?[\\") != std::string_view::npos;
}

bool isKnown(const Cell& cell, const std::string& device) {
  return cell.findDevice(device) != nullptr ||
         std::ranges::any_of(cell.sources, [&](const CellSource& source) {
           return source.ghost_of.contains(device);
         });
}

/// A session adds only devices that the cell has as `optional`: any other name judges nothing.
void checkName(const TomlTable& table, Place place, const Cell& cell, const std::string& text) {
  if (isPattern(text) || text.starts_with("layer/")) return;
  const std::size_t slash = text.find('/');
  const std::string device = text.substr(0, slash);
  if (!isKnown(cell, device)) {
    table.faults().error(
        "cell.unknown-device", place,
        fmt::format("[[clearance]] names {}, which the cell does not have", quotedInFault(device)),
        deviceHint(table, cell, device));
    return;
  }
  const CellDevice* const known = cell.findDevice(device);
  const Model* const model = known == nullptr ? nullptr : cell.modelOf(*known);
  if (slash == std::string::npos || model == nullptr || model->findLink(text.substr(slash + 1))) {
    return;
  }
  table.faults().error("cell.unknown-link", place,
                       fmt::format("device {} has no link {}", quotedInFault(device),
                                   quotedInFault(text.substr(slash + 1))));
}

/// Two patterns; empty, with a fault, when the value is something else.
std::optional<ClearancePatterns> readPair(const TomlTable& table, const TomlNode& node,
                                          std::string_view key, const Cell& cell) {
  const bool is_pair = node.kind == TomlNode::Kind::array && node.items.size() == 2 &&
                       std::ranges::all_of(node.items, [](const TomlNode& item) {
                         return item.kind == TomlNode::Kind::text && !item.text.empty();
                       });
  if (!is_pair) {
    table.faults().error("cell.wrong-kind", node.place,
                         fmt::format("`{}` needs two names or patterns", key),
                         "DEVICE, DEVICE/LINK or layer/NAME");
    return std::nullopt;
  }
  for (const TomlNode& item : node.items) checkName(table, item.place, cell, item.text);
  return ClearancePatterns{node.items[0].text, node.items[1].text};
}

bool readSides(TomlTable& table, const Cell& cell, CellClearance& clearance) {
  const TomlNode* const between = table.node("between");
  const auto self = table.text("self");
  if ((between != nullptr) == table.has("self")) {
    table.error("cell.missing-key", "between", "[[clearance]] needs either `between` or `self`",
                "between = [\"arm\", \"gantry\"], or self = \"arm\"");
    return false;
  }
  if (between != nullptr) {
    const auto pair = readPair(table, *between, "between", cell);
    if (pair) clearance.between = *pair;
    return pair.has_value();
  }
  if (!self) return false;
  if (self->empty()) {
    table.error("cell.empty", "self", "`self` is empty");
    return false;
  }
  checkName(table, table.place("self"), cell, *self);
  clearance.between = {*self, *self};
  clearance.is_self = true;
  return true;
}

void readExceptions(TomlTable& table, const Cell& cell, CellClearance& clearance) {
  const TomlNode* const given = table.node("except");
  if (given == nullptr) return;
  if (given->kind != TomlNode::Kind::array) {
    table.error("cell.wrong-kind", "except", "`except` is not an array",
                "a list of pairs: [[\"arm/hand\", \"box*\"]]");
    return;
  }
  for (const TomlNode& item : given->items) {
    if (clearance.except.size() == kMaxExceptions) {
      table.faults().error(
          "cell.too-many", item.place,
          fmt::format("a [[clearance]] has more than {} exceptions", kMaxExceptions));
      return;
    }
    if (auto pair = readPair(table, item, "except", cell)) {
      clearance.except.push_back(std::move(*pair));
    }
  }
}

/// What SRDF files disable, as exceptions: of the file named by `srdf`, and of those beside URDF
/// files.
void readDisabledCollisions(TomlTable& table, const std::filesystem::path& folder, MeshStore& files,
                            Cell& cell, CellClearance& clearance) {
  const auto srdf = table.text("srdf");
  if (!clearance.is_self) {
    if (srdf) table.error("cell.missing-key", "srdf", "`srdf` needs `self`", "self = \"arm\"");
    return;
  }
  std::filesystem::path named;
  if (srdf) {
    const FoundFile found = files.search().find(*srdf, folder);
    if (found.path.empty()) {
      table.error("cell.missing-file", "srdf",
                  fmt::format("{} is not used: {}", quotedPathInFault(*srdf), found.problem()),
                  found.hint());
    }
    named = found.path;
  }
  const auto beside = [&](const std::filesystem::path& file) {
    std::optional<std::filesystem::path> there;
    const std::string name = file.filename().string();
    // Looked for first, so that only what is there is noted as a file of the cell.
    if (!files.search().look(name, file.parent_path()).path.empty()) {
      there = files.search().find(name, file.parent_path()).path;
    }
    return there;
  };
  exceptDisabledCollisions(cell, clearance, named, beside,
                           [&](const std::filesystem::path& used) { files.addFile(used); });
}

}  // namespace

void readClearances(TomlTable& root, const std::filesystem::path& folder, CellNames& names,
                    MeshStore& files, Cell& cell) {
  for (TomlTable& table : root.tables("clearance", "[[clearance]]")) {
    CellClearance clearance;
    const bool has_sides = readSides(table, cell, clearance);
    std::string name = clearance.is_self
                           ? clearance.between.first + " with itself"
                           : clearance.between.first + " to " + clearance.between.second;
    bool is_new = true;
    if (const auto given = table.text("name")) {
      name = *given;
      if (name.empty()) table.error("cell.empty", "name", "`name` is empty");
      is_new = !name.empty() && names.take(table, name).has_value();
    }
    const auto least = table.number("min_m");
    if (!least) {
      if (!table.has("min_m")) {
        table.error("cell.missing-key", "min_m", "[[clearance]] lacks `min_m`",
                    "the least distance in metres; 0: only touching is a finding");
      }
    } else if (!(*least >= 0 && *least <= kMaxLeast_m)) {
      table.error("cell.bad-number", "min_m", fmt::format("`min_m` must be 0 to {}", kMaxLeast_m));
    }
    readExceptions(table, cell, clearance);
    readDisabledCollisions(table, folder, files, cell, clearance);
    table.finish();
    if (!has_sides || !is_new || !least || !(*least >= 0 && *least <= kMaxLeast_m)) continue;
    if (cell.clearances.size() == kMaxClearances) {
      table.faults().error("cell.too-many", table.place(),
                           fmt::format("the cell has more than {} clearances", kMaxClearances));
      return;
    }
    clearance.name = std::move(name);
    clearance.min_m = *least;
    cell.clearances.push_back(std::move(clearance));
  }
}

}  // namespace rocinante
