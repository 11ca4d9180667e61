#pragma once

#include <array>
#include <compare>
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

/// A mesh that a file names: what MeshStore::load will be asked for.
struct MeshWanted {
  std::string name;
  std::filesystem::path beside;  ///< the folder of the file that names it
  double unit_m = 1.0;
  UpAxis up = UpAxis::z;
};

/// A shape by its kind and sizes in metres: sides of a box; a radius, thrice, of a sphere; radius,
/// radius and length of the others.
struct ShapeSize {
  enum class Kind : std::uint8_t { box, sphere, cylinder, capsule };
  Kind kind = Kind::box;
  std::array<double, 3> size{};
  auto operator<=>(const ShapeSize&) const = default;
};

/// The meshes of one cell, each read once and shared. Keeps count of the files that were read.
class MeshStore {
 public:
  /// `search` is borrowed. With `geometry` false names are looked up but no mesh is opened.
  MeshStore(const FileSearch& search, bool geometry) : search_(search), geometry_(geometry) {}

  /// What readAhead reads with, and whom it tells.
  void readWith(ParallelFor parallel, TellLoadProgress tell);

  const FileSearch& search() const { return search_; }

  /// Reads meshes that are going to be asked for, several at once. Changes nothing but the time
  /// that load() takes: faults, files and lookups are told when, and in the order in which, the
  /// meshes are asked for.
  void readAhead(const std::vector<MeshWanted>& wanted);

  /// The mesh that `name`, said at `place` of a file in folder `beside`, means; null with a fault
  /// in `faults` when there is none, null without one when no geometry is wanted.
  std::shared_ptr<const Mesh> load(const std::string& name, const std::filesystem::path& beside,
                                   double unit_m, UpAxis up, Place place, FaultList& faults);

  /// A texture by name; empty with a warning when it is not found.
  std::filesystem::path texture(const std::string& name, const std::filesystem::path& beside,
                                Place place, FaultList& faults);

  /// A shape that is made, not read; those of one size share a mesh. Past the first 1,000 sizes of
  /// a kind it is one of size 1, and `scale` becomes what makes it as large; a capsule, which no
  /// scale makes of another, is then a fault and null.
  std::shared_ptr<const Mesh> shape(const ShapeSize& wanted, Vec3& scale, Place place,
                                    FaultList& faults);

  void addFile(const std::filesystem::path& path) { files_.insert(path); }
  const std::set<std::filesystem::path>& files() const { return files_; }

 private:
  using Key = std::tuple<std::filesystem::path, double, UpAxis>;
  struct Loaded {
    std::shared_ptr<const Mesh> mesh;
    std::string problem;
    bool told = false;  ///< what follows has been passed on
    ModelFaults faults;
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
};

}  // namespace rocinante
