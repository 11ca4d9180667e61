#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/model/cell.h"
#include "core/model/mesh_store.h"
#include "core/model/toml_table.h"

namespace rocinante {

/// Most bytes of a cell file; more is refused.
inline constexpr std::size_t kMostCellBytes = std::size_t{4} << 20;

/// The models of a cell: of its `[[model]]` tables, and of the files that its devices name.
class CellModels {
 public:
  CellModels(std::filesystem::path folder, MeshStore& meshes)
      : folder_(std::move(folder)), meshes_(meshes) {}

  /// Reads one `[[model]]`.
  void readModel(TomlTable table);
  /// The model that a device means by `name`, said at the table's `model`: a [[model]], or a file,
  /// which is then read. A fault when there is none.
  void use(const std::string& name, const TomlTable& table);

  /// Keys as Cell::models has them.
  std::map<std::string, std::shared_ptr<const Model>> named() const;

 private:
  std::shared_ptr<const Model> readUrdfFile(const std::string& name, Place place,
                                            FaultList& faults);

  std::filesystem::path folder_;
  MeshStore& meshes_;
  std::map<std::string, std::shared_ptr<const Model>> written_;  // [[model]]; null: unusable
  std::map<std::string, std::shared_ptr<const Model>> used_;     // files as devices name them
  std::map<std::filesystem::path, std::shared_ptr<const Model>> files_;
};

/// Reads the sections of a cell other than its models into `cell`, and checks what they name.
void readDevices(TomlTable& root, Cell& cell, CellModels& models);
void readCameras(TomlTable& root, Cell& cell);
void readLayers(TomlTable& root, Cell& cell);
void readSources(TomlTable& root, Cell& cell);
void readScene(TomlTable& root, Cell& cell);

}  // namespace rocinante
