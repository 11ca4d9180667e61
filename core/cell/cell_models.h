#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "core/cell/cell_names.h"
#include "core/document/toml_table.h"
#include "core/kinematics/model.h"
#include "core/mesh/mesh_store.h"

namespace rocinante {

/// The models of a cell: of its `[[model]]` tables, and of the files that its devices name.
class CellModels {
 public:
  /// `main_folder` is that of the cell itself.
  CellModels(std::filesystem::path main_folder, CellNames& names, MeshStore& meshes)
      : main_folder_(std::move(main_folder)), names_(names), meshes_(meshes) {}

  /// Reads one `[[model]]` of a file in `folder`.
  void readModel(TomlTable table, const std::filesystem::path& folder);
  /// The model that a device names with `name`, at the table's `model` in a file in `folder`: a
  /// [[model]], or a file, which is then read. A fault when neither exists. Returns its key.
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

}  // namespace rocinante
