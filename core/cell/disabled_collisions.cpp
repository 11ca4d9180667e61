#include "core/cell/disabled_collisions.h"

#include <set>

#include "core/base/pattern.h"
#include "core/kinematics/srdf_reader.h"
#include "core/kinematics/urdf_reader.h"
#include "core/search/file_search.h"

namespace rocinante {
namespace {

/// A pattern of this text alone.
std::string literally(const std::string& text) {
  std::string pattern;
  for (const char byte : text) {
    if (byte == '*' || byte == '?' || byte == '[' || byte == '\\') pattern += '\\';
    pattern += byte;
  }
  return pattern;
}

/// Whether the pattern of `self` names the device or a link of it.
bool concerns(const std::string& self, const CellDevice& device, const Model& model) {
  if (self.starts_with("layer/") || patternMatches(self, device.name)) return true;
  for (const Link& link : model.links) {
    if (patternMatches(self, device.name + "/" + link.name)) return true;
  }
  return false;
}

std::vector<DisabledCollision> pairsIn(const std::filesystem::path& file, Findings& faults) {
  const auto bytes = readWholeFile(file, kMaxUrdfBytes);
  if (bytes.ok()) return readSrdf(*bytes, file, faults);
  FaultList list(faults, file.string());
  list.error("cell.missing-file", {}, "the SRDF file cannot be read: " + bytes.error().text());
  return {};
}

/// A file is read once, for all the devices of one model.
class SrdfFiles {
 public:
  SrdfFiles(Cell& cell, const std::function<void(const std::filesystem::path&)>& used)
      : cell_(cell), used_(used) {}

  const std::vector<DisabledCollision>& pairs(const std::filesystem::path& file) {
    const auto [found, is_new] = read_.try_emplace(file);
    if (is_new) {
      used_(file);
      found->second = pairsIn(file, cell_.faults);
    }
    return found->second;
  }

 private:
  Cell& cell_;
  const std::function<void(const std::filesystem::path&)>& used_;
  std::map<std::filesystem::path, std::vector<DisabledCollision>> read_;
};

}  // namespace

std::optional<std::filesystem::path> srdfOnDisk(const std::filesystem::path& srdf) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(srdf, ignored)) return std::nullopt;
  return srdf;
}

void exceptDisabledCollisions(Cell& cell, CellClearance& clearance,
                              const std::filesystem::path& named, const FindBeside& beside,
                              const std::function<void(const std::filesystem::path&)>& used) {
  SrdfFiles files(cell, used);
  std::set<ClearancePatterns> known;
  const auto add = [&](const CellDevice& device, const Model& model,
                       const std::vector<DisabledCollision>& pairs) {
    const std::string below = literally(device.name) + "/";
    for (const auto& [first, second] : pairs) {
      if (!model.findLink(first) || !model.findLink(second)) continue;
      ClearancePatterns patterns{below + literally(first), below + literally(second)};
      if (known.insert(patterns).second) clearance.except.push_back(std::move(patterns));
    }
  };
  for (const CellDevice& device : cell.devices) {
    const Model* const model = cell.modelOf(device);
    if (model == nullptr || !concerns(clearance.between.first, device, *model)) continue;
    if (!named.empty()) add(device, *model, files.pairs(named));
    std::filesystem::path file(model->file);
    if (file.extension() != ".urdf") continue;
    if (const auto found = beside(file.replace_extension(".srdf"))) {
      add(device, *model, files.pairs(*found));
    }
  }
}

}  // namespace rocinante
