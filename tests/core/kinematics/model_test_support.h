#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/kinematics/model.h"
#include "core/kinematics/urdf_reader.h"
#include "core/mesh/mesh_store.h"
#include "core/report/finding.h"
#include "core/search/file_search.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {

/// The faults as a program lists them, one per line, without the folder `within`.
inline std::string printed(const Findings& faults, const std::filesystem::path& within = {}) {
  std::string text;
  for (const Finding& fault : faults) text += fault.print() + "\n";
  const std::string folder = within.string() + "/";
  for (std::size_t at; !within.empty() && (at = text.find(folder)) != std::string::npos;) {
    text.erase(at, folder.size());
  }
  return text;
}

/// What a test reads a model into: a folder that is its search root.
struct ReadModel {
  ReadModel() { static_cast<void>(search.addRoot(folder.path()).ok()); }
  std::string faultText() const { return printed(faults, folder.path()); }

  TemporaryFolder folder;
  FileSearch search;
  Findings faults;
  std::optional<Model> model;
};

/// A URDF read from text named robot.urdf.
struct ReadUrdf : ReadModel {
  explicit ReadUrdf(std::string_view text) {
    MeshStore meshes(search, true);
    model = readUrdf(bytesOf(text), folder / "robot.urdf", meshes, faults);
  }
};

}  // namespace rocinante::test
