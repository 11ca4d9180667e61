#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/model/fault_list.h"
#include "core/model/mesh_file.h"

namespace rocinante {

/// Reads a Wavefront material file: Kd Ks Ke Ns d Tr map_Kd (with -s and -o). Materials are added
/// to `materials` in the file's order; one whose name is there already is left out with a fault.
/// Other known keywords are passed over. A texture is looked for as it is named, with slashes for
/// backslashes, by its bare name beside the file, and in ../materials/textures; one that is not
/// found is a fault, and the material stays without.
void readMtl(std::string_view text, const std::filesystem::path& path, const ResolveFile& resolve,
             FaultList& faults, std::vector<Material>& materials);

/// `options.resolve`, or one that finds only what lies in the folder `beside` or below it.
ResolveFile resolverOf(const MeshReadOptions& options);

}  // namespace rocinante
