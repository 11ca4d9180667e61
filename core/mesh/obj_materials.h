#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// The materials of an OBJ file: those of the libraries that it names, before or behind their use,
/// and a grey one for each name that none of them defines.
class ObjMaterials {
 public:
  /// `path` is the OBJ file's; it and `faults` are borrowed.
  ObjMaterials(const std::filesystem::path& path, ResolveFile resolve, FaultList& faults)
      : path_(path), resolve_(std::move(resolve)), faults_(faults) {}

  /// Number in the list of a name that `line` uses; the empty one is that of faces that name none.
  std::uint32_t number(const std::string& name, int line);
  /// What follows `mtllib`.
  void readLibraries(const std::string& names, int line);
  /// Ends the reading: adds a fault for each name that is not defined, if the file has libraries,
  /// since exporters without materials still write usemtl. Where points have colours, greys are
  /// white, so that they do not darken those.
  std::vector<Material> takeAll(bool are_points_colored);

 private:
  std::uint32_t addGrey(const std::string& name);
  std::filesystem::path find(const std::string& name, const std::filesystem::path& beside) const;
  void readLibrary(const std::filesystem::path& file, int line);

  const std::filesystem::path& path_;
  const ResolveFile resolve_;
  FaultList& faults_;
  std::vector<Material> materials_;
  std::vector<Material> defined_;  ///< by libraries
  std::map<std::string, std::uint32_t> numbers_;
  std::map<std::uint32_t, int> undefined_;  ///< to the lines that first use them
  std::optional<std::uint32_t> unnamed_;
  std::set<std::uint32_t> greys_;
  std::set<std::filesystem::path> libraries_;
  bool any_library_ = false;  ///< one could be read
};

}  // namespace rocinante
