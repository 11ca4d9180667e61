#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/document/fault_list.h"
#include "core/mesh/mesh_file.h"

namespace rocinante {

/// Reads a Wavefront material file: Kd Ks Ke Ns d Tr map_Kd (with -s, -o and -clamp), in capitals
/// or not. Materials are added to `materials` in the file's order; a duplicate name is left out
/// with a fault. Other statements and options are left out in `faults`. A texture that textureFile
/// does not find is a fault, and the material has no texture.
void readMtl(std::string_view text, const std::filesystem::path& path, const ResolveFile& resolve,
             FaultList& faults, std::vector<Material>& materials);

/// The image that a material names: as named, with slashes for backslashes, by its bare name in the
/// folder `beside`, and in ../materials/textures from there.
FoundFile textureFile(const ResolveFile& resolve, std::string name,
                      const std::filesystem::path& beside);

/// Gives `material` the image `name`. If it is not found, the material keeps the name, and a
/// warning of `rule` at `place` says why.
void useTexture(const ResolveFile& resolve, const std::string& name,
                const std::filesystem::path& beside, std::string_view rule, Place place,
                FaultList& faults, Material& material);

/// `options.resolve`, or one that finds only files in the folder `beside` or below it.
ResolveFile resolverOf(const MeshReadOptions& options);

}  // namespace rocinante
