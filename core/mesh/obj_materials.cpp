#include "core/mesh/obj_materials.h"

#include <algorithm>
#include <string_view>

#include "core/base/atomic_file.h"
#include "core/mesh/mtl_reader.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLargestMtlBytes = std::uint64_t{64} << 20U;

/// Words; those with blanks are in quotes.
std::vector<std::string> fileNames(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const bool quoted = text.front() == '"' && text.find('"', 1) != std::string_view::npos;
    const std::size_t begin = quoted ? 1 : 0;
    const std::size_t end =
        std::min(quoted ? text.find('"', 1) : text.find_first_of(" \t"), text.size());
    if (end > begin) names.emplace_back(text.substr(begin, end - begin));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return names;
}

}  // namespace

std::uint32_t ObjMaterials::number(const std::string& name, int line) {
  if (name.empty()) {
    if (!unnamed_) unnamed_ = addGrey({});
    return *unnamed_;
  }
  const auto known = numbers_.find(name);
  if (known != numbers_.end()) return known->second;
  const std::uint32_t number = addGrey(name);
  numbers_.emplace(name, number);
  undefined_.emplace(number, line);
  return number;
}

std::uint32_t ObjMaterials::addGrey(const std::string& name) {
  const auto number = static_cast<std::uint32_t>(materials_.size());
  materials_.emplace_back().name = name;
  greys_.insert(number);
  return number;
}

void ObjMaterials::readLibraries(const std::string& names, int line) {
  const fs::path beside = path_.parent_path();
  // One name with blanks, as some exporters write it, or several names.
  if (const fs::path whole = find(names, beside); !whole.empty()) return readLibrary(whole, line);
  for (const std::string& name : fileNames(names)) {
    const fs::path file = find(name, beside);
    if (!file.empty()) {
      readLibrary(file, line);
    } else {
      faults_.warning("obj.missing-mtllib", {line},
                      "the material file " + quotedPathInFault(name) + " is not found");
    }
  }
}

fs::path ObjMaterials::find(const std::string& name, const fs::path& beside) const {
  if (name.empty()) return {};
  if (fs::path found = resolve_(name, beside).path; !found.empty()) return found;
  std::string slashes = name;
  std::ranges::replace(slashes, '\\', '/');
  if (slashes != name) {
    if (fs::path found = resolve_(slashes, beside).path; !found.empty()) return found;
  }
  // Written on another machine: absolute, perhaps with backslashes.
  const std::string bare = name.substr(name.find_last_of("/\\") + 1);
  return bare.empty() || bare == name ? fs::path{} : resolve_(bare, beside).path;
}

void ObjMaterials::readLibrary(const fs::path& file, int line) {
  if (!libraries_.insert(file).second) return;
  const Result<std::string> text = readFile(file, kLargestMtlBytes);
  if (!text) {
    return faults_.warning("obj.missing-mtllib", {line},
                           "the material file cannot be read: " + text.error().text());
  }
  any_library_ = true;
  const std::size_t before = defined_.size();
  FaultList faults(faults_.all(), file.string());
  readMtl(*text, file, resolve_, faults, defined_);
  for (std::size_t i = before; i < defined_.size(); ++i) {
    const auto next = static_cast<std::uint32_t>(materials_.size());
    const auto [known, is_new] = numbers_.emplace(defined_[i].name, next);
    if (is_new) {
      materials_.push_back(defined_[i]);
    } else {
      // Used before its library was named.
      materials_[known->second] = defined_[i];
      greys_.erase(known->second);
      undefined_.erase(known->second);
    }
  }
}

std::vector<Material> ObjMaterials::takeAll(bool are_points_colored) {
  if (any_library_) {
    for (const auto& [number, line] : undefined_) {
      faults_.warning("obj.unknown-material", {line},
                      "no material file defines " + quotedInFault(materials_[number].name));
    }
  }
  for (const std::uint32_t grey : greys_) {
    if (are_points_colored) materials_[grey].diffuse = glm::vec4(1.0F);
  }
  return std::move(materials_);
}

}  // namespace rocinante
