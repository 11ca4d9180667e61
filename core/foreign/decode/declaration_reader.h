#pragma once

#include "core/document/fault_list.h"
#include "core/document/toml_node.h"
#include "core/foreign/decode/declaration.h"
#include "core/foreign/decode/descriptor_files.h"

namespace rocinante::decode {

/// The `[[decoder]]` tables of a document, checked; faults go to the list, and their decoders are
/// left incomplete. The descriptors that they name are read into `files`.
std::vector<Decoder> decodersIn(const TomlNode& document, DescriptorFiles& files,
                                FaultList& faults);

}  // namespace rocinante::decode
