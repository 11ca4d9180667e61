#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>

#include "core/model/fault_list.h"
#include "core/model/file_search.h"
#include "core/model/mesh_file.h"

namespace rocinante {

/// The meshes of one cell, each read once and shared. Keeps count of the files that were read.
class MeshStore {
 public:
  /// `search` is borrowed. With `geometry` false names are looked up but no mesh is opened.
  MeshStore(const FileSearch& search, bool geometry) : search_(search), geometry_(geometry) {}

  const FileSearch& search() const { return search_; }

  /// The mesh that `name`, said at `place` of a file in folder `beside`, means; null with a fault
  /// in `faults` when there is none, null without one when no geometry is wanted.
  std::shared_ptr<const Mesh> load(const std::string& name, const std::filesystem::path& beside,
                                   double unit_m, UpAxis up, Place place, FaultList& faults);

  /// A texture by name; empty with a warning when it is not found.
  std::filesystem::path texture(const std::string& name, const std::filesystem::path& beside,
                                Place place, FaultList& faults);

  /// A shape that is made, not read; `key` tells it from others.
  std::shared_ptr<const Mesh> shape(const std::string& key, const std::function<Mesh()>& make);

  void addFile(const std::filesystem::path& path) { files_.insert(path); }
  const std::set<std::filesystem::path>& files() const { return files_; }

 private:
  struct Loaded {
    std::shared_ptr<const Mesh> mesh;
    std::string problem;
  };
  std::filesystem::path find(const std::string& name, const std::filesystem::path& beside,
                             Severity severity, std::string_view rule, std::string_view kind,
                             Place place, FaultList& faults) const;

  const FileSearch& search_;
  bool geometry_;
  std::map<std::tuple<std::filesystem::path, double, UpAxis>, Loaded> meshes_;
  std::map<std::string, std::shared_ptr<const Mesh>> shapes_;
  std::set<std::filesystem::path> files_;
};

}  // namespace rocinante
