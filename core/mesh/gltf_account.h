#pragma once

#include <vector>

#include "core/document/fault_list.h"
#include "core/mesh/gltf_document.h"

namespace rocinante {

/// Names everything of a checked document that readGltf() does not use, known or not: each
/// property, attribute, extension, primitive, scene and node. `is_drawn` is by node. Not named is
/// what glTF defines as ignorable: extras, and who made the file.
void nameWhatGltfLeavesOut(const GltfDocument& document, const std::vector<bool>& is_drawn,
                           FaultList& faults);

}  // namespace rocinante
