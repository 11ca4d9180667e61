#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/model/cell.h"
#include "core/model/cell_files.h"
#include "core/model/mesh_store.h"
#include "core/model/toml_table.h"

namespace rocinante {

/// The names of a cell's tables, over all its files. A file outranks what it includes; else the
/// first table of a name stands.
class CellNames {
 public:
  explicit CellNames(const CellFiles& files) : files_(files) {}

  /// The table's `name` (or `name`, which then stands for it) when it is the table's to have; empty
  /// when another has it, with a fault.
  std::optional<std::string> take(TomlTable& table);
  std::optional<std::string> take(TomlTable& table, const std::string& name);

 private:
  struct Owner {
    std::string file;
    Place place;
  };
  const CellFiles& files_;
  std::map<std::pair<std::string, std::string>, Owner> owners_;  // by kind of table, and name
};

/// The models of a cell: of its `[[model]]` tables, and of the files that its devices name.
class CellModels {
 public:
  /// `main_folder` is that of the cell itself.
  CellModels(std::filesystem::path main_folder, CellNames& names, MeshStore& meshes)
      : main_folder_(std::move(main_folder)), names_(names), meshes_(meshes) {}

  /// Reads one `[[model]]` of a file in `folder`.
  void readModel(TomlTable table, const std::filesystem::path& folder);
  /// The model that a device means by `name`, said at the table's `model` in a file in `folder`: a
  /// [[model]], or a file, which is then read. A fault when there is none. Returns its key.
  std::string use(const std::string& name, const TomlTable& table,
                  const std::filesystem::path& folder);

  /// Keys as Cell::models has them.
  std::map<std::string, std::shared_ptr<const Model>> named() const;

 private:
  std::shared_ptr<const Model> readModelFile(const std::string& name,
                                             const std::filesystem::path& folder, Place place,
                                             FaultList& faults);
  std::shared_ptr<const Model> readTreeFile(const std::string& name,
                                            const std::filesystem::path& folder, Place place,
                                            FaultList& faults);

  std::filesystem::path main_folder_;
  CellNames& names_;
  MeshStore& meshes_;
  std::map<std::string, std::shared_ptr<const Model>> written_;  // [[model]]; null: unusable
  std::map<std::string, std::shared_ptr<const Model>> used_;     // files as devices name them
  std::map<std::filesystem::path, std::shared_ptr<const Model>> files_;
};

/// Reads the devices of a cell's files, then checks what they name.
class DeviceReader {
 public:
  DeviceReader(Cell& cell, CellModels& models, CellNames& names)
      : cell_(cell), models_(models), names_(names) {}

  void read(TomlTable& root, const std::filesystem::path& folder);
  /// When all files were read: fills Cell::models.
  void finish();

 private:
  Cell& cell_;
  CellModels& models_;
  CellNames& names_;
  std::vector<std::pair<TomlTable, std::string>> carried_;  // tables that say `on`, and the device
};

/// Reads the layers of a cell's files, before their devices; then checks what they hold.
class LayerReader {
 public:
  LayerReader(Cell& cell, CellNames& names) : cell_(cell), names_(names) {}

  void read(TomlTable& root);
  /// When devices and sources of all files were read: leaves out what there is not.
  void finish();

 private:
  struct Holding {
    TomlTable table;
    std::size_t layer = 0;            // into Cell::layers
    std::vector<const TomlNode*> at;  // by member
  };
  void readMembers(TomlTable& table, CellLayer& layer, std::vector<const TomlNode*>& at);
  bool isThere(const TomlTable& table, Place place, const LayerMember& member) const;

  Cell& cell_;
  CellNames& names_;
  std::vector<Holding> holdings_;
  std::size_t members_ = 0;  // of all layers
};

/// Layers need no [[layer]]; where a cell has some, another name at the table's `key` is likely a
/// slip.
void checkLayer(const TomlTable& table, std::string_view key, const Cell& cell,
                const std::string& layer);
/// "did you mean ...?" of a device that the cell has not, while more faults are listed.
std::string deviceHint(const TomlTable& table, const Cell& cell, std::string_view name);

/// Reads the other sections of one file of a cell into `cell`, and checks what they name. Of
/// [scene] what is given stands over what was read before.
void readCameras(TomlTable& root, CellNames& names, Cell& cell);
/// When the cameras of all files were read.
void readInsets(TomlTable& root, Cell& cell);
/// Before [scene].
void readLights(TomlTable& root, CellNames& names, Cell& cell);
/// When all files were read: the key light is the first that there is.
void finishLights(Cell& cell);
void readSources(TomlTable& root, CellNames& names, Cell& cell);
/// The keys of SourceLimits of a `[[source]]`.
SourceLimits readSourceLimits(TomlTable& table);
/// `[rules]`.
void readRules(TomlTable& root, Cell& cell);
void readScene(TomlTable& root, Cell& cell);

}  // namespace rocinante
