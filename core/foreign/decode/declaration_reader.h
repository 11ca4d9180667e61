#pragma once

#include "core/document/fault_list.h"
#include "core/document/toml_node.h"
#include "core/foreign/decode/declaration.h"

namespace rocinante::decode {

/// The `[[decoder]]` tables of a document, checked; faults go to the list, and their decoders are
/// left incomplete.
std::vector<Decoder> decodersIn(const TomlNode& document, FaultList& faults);

}  // namespace rocinante::decode
