#include "golden/why/file_change.h"

#include <string_view>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

/// The kind of a file of a cell, by its extension.
std::string_view roleOf(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".mtl") return "materials";
  if (ending == ".toml") return "cell";
  if (ending == ".urdf" || ending == ".sdf") return "kinematics";
  for (const char* picture :
       {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".tga", ".bmp", ".hdr"}) {
    if (ending == picture) return "texture";
  }
  for (const char* mesh : {".obj", ".stl", ".dae", ".gltf", ".glb", ".ply", ".bin"}) {
    if (ending == mesh) return "mesh";
  }
  return "file";
}

}  // namespace

FileHashes hashesOf(const CellBundle& bundle) {
  FileHashes hashes;
  for (const auto& file : bundle.manifest.files) hashes[file.name] = file.sha256;
  return hashes;
}

bool isToldText(const std::string& name) {
  const std::string_view role = roleOf(name);
  return role == "cell" || role == "kinematics" || role == "materials";
}

FileTexts toldTexts(const CellBundle& bundle) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 20U;
  FileTexts texts;
  for (std::size_t i = 0; i < bundle.contents.size(); ++i) {
    const auto& file = bundle.manifest.files[i];
    const Bytes& content = bundle.contents[i];
    if (!isToldText(file.name) || content.size() > kMaxBytes || !isUtf8(content)) continue;
    texts[file.sha256] = textOf(content);
  }
  return texts;
}

std::vector<std::string> fileChanges(const FileHashes& golden, const FileHashes& frame) {
  FileHashes all = golden;
  all.insert(frame.begin(), frame.end());
  std::vector<std::string> lines;
  for (const auto& [file, ignored] : all) {
    const auto before = golden.find(file);
    const auto now = frame.find(file);
    const std::string role(roleOf(file));
    // The manifest's text is untrusted.
    const std::string name = plainText(file);
    if (before == golden.end()) {
      lines.push_back(name + ": the " + role + " is new");
    } else if (now == frame.end()) {
      lines.push_back(name + ": the " + role + " is no longer part of the cell");
    } else if (before->second != now->second) {
      lines.push_back(name + ": the " + role + (role.ends_with('s') ? " have" : " has") +
                      " changed");
    }
  }
  return lines;
}

}  // namespace rocinante
