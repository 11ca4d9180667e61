#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"
#include "core/search/file_search.h"

namespace rocinante {

/// A mesh that a file names; MeshStore::load will be called for it.
struct MeshWanted {
  std::string name;
  std::filesystem::path beside;  ///< the folder of the file that names it
  double unit_m = 1.0;
  UpAxis up = UpAxis::z;
};

/// The meshes of one cell, each read once and shared. Keeps count of the files that were read.
class MeshStore {
 public:
  /// `search` is borrowed. With `geometry` false names are looked up but no mesh is opened.
  MeshStore(const FileSearch& search, bool geometry) : search_(search), geometry_(geometry) {}

  /// Threads and progress callback for readAhead.
  void readWith(ParallelFor parallel, TellLoadProgress tell);

  const FileSearch& search() const { return search_; }

  /// Reads meshes that load() will ask for, several at once. Only makes load() faster: faults,
  /// files and lookups are still reported by load(), in its order.
  void readAhead(const std::vector<MeshWanted>& wanted);

  /// The mesh `name`, named at `place` of a file in folder `beside`. Null with a fault in `faults`
  /// when it cannot be read; null without a fault when geometry is off.
  std::shared_ptr<const Mesh> load(const std::string& name, const std::filesystem::path& beside,
                                   double unit_m, UpAxis up, Place place, FaultList& faults);

  /// A texture by name; empty with a warning when it is not found.
  std::filesystem::path texture(const std::string& name, const std::filesystem::path& beside,
                                Place place, FaultList& faults);

  /// A generated shape; equal sizes share a mesh. After the first 1,000 sizes of a kind the mesh
  /// has size 1 and `scale` is set to match; a capsule, which cannot be scaled to another, is then
  /// a fault and null.
  std::shared_ptr<const Mesh> shape(const ShapeSize& wanted, Vec3& scale, Place place,
                                    FaultList& faults);

  void addFile(const std::filesystem::path& path) { files_.insert(path); }
  const std::set<std::filesystem::path>& files() const { return files_; }

 private:
  using Key = std::tuple<std::filesystem::path, double, UpAxis>;
  struct Loaded {
    std::shared_ptr<const Mesh> mesh;
    Error problem{};           ///< without a mesh
    bool is_reported = false;  ///< the results below have been passed on
    Findings faults;
    std::vector<FileLookup> lookups;
  };
  Loaded read(const Key& key, const FoundFile& found) const;
  FoundFile find(const std::string& name, const std::filesystem::path& beside, Severity severity,
                 std::string_view rule, std::string_view kind, Place place,
                 FaultList& faults) const;

  const FileSearch& search_;
  bool geometry_;
  ParallelFor parallel_;
  TellLoadProgress tell_;
  LoadProgress progress_;
  std::map<Key, Loaded> meshes_;
  std::map<ShapeSize, std::shared_ptr<const Mesh>> shapes_;
  std::map<ShapeSize::Kind, std::size_t> shape_counts_;
  std::set<std::filesystem::path> files_;
  mutable std::set<std::string> hints_;  ///< told once: a hundred files may have one cause
};

}  // namespace rocinante
