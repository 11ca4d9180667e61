#pragma once

#include <span>
#include <string_view>

#include "core/base/bytes.h"

namespace rocinante {

/// A message of a schema in one line of words, as a .proto file has it without its punctuation:
/// fields `[repeated|optional] TYPE NAME=NUMBER` and enums `NAME VALUE=NUMBER...`, each separated
/// by "; ". TYPE is double, string, bool, bytes or fixed32; an enum of this message; Timestamp or
/// Duration of google.protobuf; or a message of the same package.
struct ProtoMessage {
  std::string_view name;
  std::string_view fields;
  std::string_view enums;
};

/// A serialised google.protobuf.FileDescriptorSet, the form that MCAP has for schemas of encoding
/// "protobuf": the message `root` of `package` with everything that it refers to, one file for each
/// message (PACKAGE/NAME.proto), every file after those that it needs.
Bytes fileDescriptorSet(std::string_view package, std::span<const ProtoMessage> messages,
                        std::string_view root);

}  // namespace rocinante
