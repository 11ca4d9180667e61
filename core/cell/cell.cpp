#include "core/cell/cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/cell/cell_files.h"
#include "core/cell/cell_layers.h"
#include "core/cell/cell_materials.h"
#include "core/cell/cell_models.h"
#include "core/cell/cell_names.h"
#include "core/cell/cell_sections.h"
#include "core/cell/inline_model.h"
#include "core/cell/rule_reader.h"
#include "core/document/fault_list.h"
#include "core/kinematics/sdf_reader.h"
#include "core/kinematics/urdf_reader.h"
#include "core/mesh/mesh_store.h"
#include "core/report/account.h"
#include "core/search/file_search.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::string endingOf(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return ending;
}

FileSearch searchFor(const CellOptions& options) {
  FileSearch search;
  search.noteIn(options.lookups);
  search.noteFactsIn(options.facts);
  if (options.answers) search.answerFrom(options.answers);
  return search;
}

// Packages named by the user: added before those of the cell, which they override.
Status addPackages(const CellOptions& options, FileSearch& search) {
  for (const PackageFolder& package : options.packages) {
    if (Status added = search.addPackage(package); !added.ok()) return added;
  }
  return Status{};
}

// Roots named by the user.
Status addRoots(const CellOptions& options, FileSearch& search) {
  for (const fs::path& root : options.search) {
    if (Status added = search.addRoot(root); !added.ok()) return added;
  }
  if (options.search_environment) search.addEnvironmentRoots();
  return Status{};
}

// The first error as one that ends the loading.
Error firstErrorOf(const Findings& faults, const fs::path& path) {
  const Finding* const fault = firstError(faults);
  if (fault == nullptr) {
    return {ErrorKind::damaged, "nothing in the file can be used", path.string()};
  }
  return {ErrorKind::damaged,
          fault->hint.empty() ? fault->text : fmt::format("{}; {}", fault->text, fault->hint),
          fault->place()};
}

/// The first error; where the file is a mesh with nothing to draw, with the finding that tells why.
Error errorOfModel(const Findings& faults, const fs::path& path) {
  Error error = firstErrorOf(faults, path);
  const Finding* const fault = firstError(faults);
  if (fault == nullptr || fault->rule != "model.unusable-mesh") return error;
  // Textures and materials that are missing take no triangle along.
  const auto cause = std::ranges::find_if(faults, [](const Finding& one) {
    return one.severity == Severity::warning && one.rule.find(".missing-") == std::string::npos;
  });
  if (cause == faults.end()) return error;
  error.what += "; " + sentenceOf(*cause);
  error.where = cause->place();
  return error;
}

Status refuseFaulty(const Cell& cell, const fs::path& path, const CellOptions& options) {
  if (!options.strict) return Status{};
  const std::size_t errors = countOf(cell.faults, Severity::error);
  if (errors == 0) return Status{};
  Error first = firstErrorOf(cell.faults, path);
  if (errors > 1) first.what += fmt::format("; {} errors in all", errors);
  return first;
}

// The cell's faults first, then those of each file in the order of reading; each from top to
// bottom.
void sortFaults(Cell& cell) {
  std::map<std::string, std::size_t> order{{cell.file, 0}};
  for (const Finding& fault : cell.faults) order.emplace(fault.file, order.size());
  std::stable_sort(cell.faults.begin(), cell.faults.end(), [&](const Finding& a, const Finding& b) {
    return std::tuple(order[a.file], a.line, a.column) <
           std::tuple(order[b.file], b.line, b.column);
  });
}

Result<Cell> loadModelFile(const fs::path& path, const CellOptions& options) {
  FileSearch search = searchFor(options);
  if (Status added = addPackages(options, search); !added.ok()) return added.error();
  if (Status added = search.addRoot(folderOf(path)); !added.ok()) return added.error();
  if (Status added = addRoots(options, search); !added.ok()) return added.error();
  search.setPackagesAbove(folderOf(path));
  MeshStore meshes(search, options.geometry);
  meshes.readWith(options.parallel, options.progress);
  Cell cell;
  cell.file = path.string();
  CellDevice device;
  device.name = path.stem().string();
  device.model = path.filename().string();

  std::shared_ptr<const Model> model;
  if (endingOf(path) == ".urdf") {
    const auto bytes = readWholeFile(path, kMaxUrdfBytes);
    if (!bytes.ok()) return bytes.error();
    meshes.addFile(path);
    if (auto read = readUrdf(*bytes, path, meshes, cell.faults)) {
      model = std::make_shared<const Model>(std::move(*read));
    }
  } else if (endingOf(path) == ".sdf") {
    const auto bytes = readWholeFile(path, kMaxSdfBytes);
    if (!bytes.ok()) return bytes.error();
    meshes.addFile(path);
    if (auto read = readSdf(*bytes, path, meshes, cell.faults)) {
      model = std::make_shared<const Model>(std::move(*read));
    }
  } else {
    FaultList faults(cell.faults, path.string());
    auto mesh = meshes.load(path.filename().string(), folderOf(path), 1.0, UpAxis::z, {}, faults);
    if (mesh || !options.geometry) {
      if (!statesUnit(path)) {
        faults.note("cell.assumed-unit", {}, "the file is taken as metres with z up",
                    "a cell with a [[model]] can say otherwise");
      }
      model = std::make_shared<const Model>(rigidModel(device.name, path.string(), mesh));
    }
  }
  if (!model) return errorOfModel(cell.faults, path);
  cell.models[device.model] = model;
  cell.models[device.name] = model;
  cell.device_by_name.emplace(device.name, 0);
  cell.devices.push_back(std::move(device));
  cell.files.assign(meshes.files().begin(), meshes.files().end());
  sortFaults(cell);
  if (Status sound = refuseFaulty(cell, path, options); !sound.ok()) return sound.error();
  return cell;
}

}  // namespace

const Model* Cell::modelOf(const CellDevice& device) const {
  if (device.dressed) return device.dressed.get();
  const auto found = models.find(device.model);
  return found == models.end() ? nullptr : found->second.get();
}

const CellDevice* Cell::findDevice(std::string_view name) const {
  if (!device_by_name.empty()) {
    const auto found = device_by_name.find(name);
    return found == device_by_name.end() ? nullptr : &devices[found->second];
  }
  for (const CellDevice& device : devices) {
    if (device.name == name) return &device;
  }
  return nullptr;
}

const CellCamera* Cell::findCamera(std::string_view name) const {
  for (const CellCamera& camera : cameras) {
    if (camera.name == name) return &camera;
  }
  return nullptr;
}

std::string Cell::shown(std::string text) const {
  if (files_below.empty()) return text;
  for (std::size_t at = 0; (at = text.find(files_below, at)) != std::string::npos;) {
    text.replace(at, files_below.size(), files_shown_as);
    at += files_shown_as.size();
  }
  return text;
}

Result<Cell> readCell(ByteView bytes, const fs::path& path, const CellOptions& options) {
  Cell cell;
  cell.file = path.string();
  FileSearch search = searchFor(options);
  if (Status added = addPackages(options, search); !added.ok()) return added.error();
  CellFiles files(search, cell.faults, !options.answers);
  if (Status read = files.readMain(bytes, path); !read.ok()) return read.error();
  if (Status added = addRoots(options, search); !added.ok()) return added.error();
  files.readIncluded();

  MeshStore meshes(search, options.geometry);
  meshes.readWith(options.parallel, options.progress);
  CellNames names(files);
  CellModels models(files.inOrder().front()->folder, names, meshes);
  LayerReader layers(cell, names);
  DeviceReader devices(cell, models, names);
  for (const CellFile* file : files.inOrder()) {
    meshes.addFile(file->path);
    meshes.readAhead(meshesOfInlineModels(file->document, file->folder));
  }
  for (const CellFile* file : files.inOrder()) {
    for (TomlTable& table : file->root->tables("model", "[[model]]")) {
      models.readModel(table, file->folder);
    }
    layers.read(*file->root);
  }
  for (const CellFile* file : files.inOrder()) devices.read(*file->root, file->folder);
  devices.finish();
  for (const CellFile* file : files.inOrder()) {
    readCameras(*file->root, names, cell);
    readSources(*file->root, names, cell);
    readLights(*file->root, names, cell);
  }
  layers.finish();
  for (const CellFile* file : files.inOrder()) {
    readInsets(*file->root, cell);
    readClearances(*file->root, file->folder, names, meshes, cell);
    readSignals(*file->root, cell);
  }
  CellMaterials materials;
  // Later files override earlier ones.
  for (auto at = files.inOrder().rbegin(); at != files.inOrder().rend(); ++at) {
    const CellFile& file = **at;
    readRules(*file.root, cell);
    readScene(*file.root, cell);
    readDecodersName(file, search, cell);
    materials.read(*file.root, file.folder, meshes);
  }
  finishLights(cell);
  addDecoderFiles(cell, meshes);
  if (options.geometry) materials.apply(cell);
  files.finish();
  cell.files.assign(meshes.files().begin(), meshes.files().end());
  sortFaults(cell);
  if (Status sound = refuseFaulty(cell, path, options); !sound.ok()) return sound.error();
  return cell;
}

Result<Cell> loadCell(const fs::path& path, const CellOptions& options) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return Error{ErrorKind::not_found, "there is no such cell", path.string()};
  }
  if (!fs::is_regular_file(status)) {
    return Error{ErrorKind::bad_argument, "a cell is a file, and this is not one", path.string()};
  }
  const std::string ending = endingOf(path);
  if (ending == ".toml") {
    const auto bytes = readWholeFile(path, kMaxCellBytes);
    if (!bytes.ok()) return bytes.error();
    return readCell(*bytes, path, options);
  }
  if (ending == ".urdf" || ending == ".sdf" || isMeshFile(path))
    return loadModelFile(path, options);
  if (ending == ".xacro") {
    return Error{ErrorKind::unsupported,
                 "a xacro template is not read; expand it first: xacro model.xacro > model.urdf",
                 path.string()};
  }
  return Error{ErrorKind::bad_argument,
               "a cell ends in .cell.toml, .urdf, .sdf, .obj, .stl, .dae, .gltf or .glb",
               path.string()};
}

}  // namespace rocinante
