#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/fault_list.h"
#include "core/document/toml_node.h"
#include "core/foreign/decode/declaration.h"
#include "core/foreign/decode/descriptor_files.h"

namespace rocinante::decode {

/// The `[[decoder]]` tables of a document, checked; faults go to the list, and their decoders are
/// left incomplete. The descriptors that they name are read into `files`.
std::vector<Decoder> decodersIn(const TomlNode& document, DescriptorFiles& files,
                                FaultList& faults);

/// A checked file of decoders (docs/decoders.md). A plain value; what decodes with it borrows it.
struct DecoderSet {
  std::string file;  ///< for messages
  std::string text;  ///< of the file, as it was read
  std::vector<Decoder> decoders;
  std::deque<DescriptorFiles::File> descriptors;  ///< in the order of first mention
  /// SHA-256 of the text and, behind it, of the SHA-256s of the descriptors, all in lower-case
  /// hexadecimal: channel metadata `decoder`
  /// (docs/log-format.md, "Decoded packets").
  std::string hash;
};

/// Reads a file of decoders. not_found, unreadable, or bad_argument with the first fault and
/// FILE:LINE:COLUMN.
Result<std::shared_ptr<const DecoderSet>> readDecoders(const std::filesystem::path& file);
/// The same of a text; `file` is used in messages, and descriptors lie beside it.
Result<std::shared_ptr<const DecoderSet>> parseDecoders(std::string_view text,
                                                        const std::string& file);

}  // namespace rocinante::decode
