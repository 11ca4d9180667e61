#pragma once

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <filesystem>
#include <string>

#include "core/base/bytes.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// Gives assimp only the scene's own file, which is in memory, and what `resolve` finds beside it.
class SceneFiles : public Assimp::IOSystem {
 public:
  /// `name` is what assimp calls the file; `bytes`, `path` and `resolve` are borrowed.
  SceneFiles(std::string name, ByteView bytes, const std::filesystem::path& path,
             const ResolveFile& resolve)
      : name_(std::move(name)), bytes_(bytes), path_(path), resolve_(resolve) {}

  bool Exists(const char* name) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

  /// The last file that was asked for but refused; empty when none was.
  const std::string& refused() const { return refused_; }

 private:
  std::string name_;
  ByteView bytes_;
  const std::filesystem::path& path_;
  const ResolveFile& resolve_;
  std::string refused_;
};

}  // namespace rocinante
