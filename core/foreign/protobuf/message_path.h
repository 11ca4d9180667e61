#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/foreign/protobuf/protobuf_module.h"

namespace rocinante::protobuf {

/// Names every value of a message, in the order of its fields, until `found` answers 0. Maps and
/// what lies in unknown groups are left out.
void listValues(const google::protobuf::Message& message, RocinanteProtobufFound found, void* to);

/// A way through a message to one value: "a.b[2].c".
struct MessagePath {
  struct Step {
    const google::protobuf::FieldDescriptor* field;
    int index;  ///< below 0: not a repeated field
  };
  std::vector<Step> steps;
};

/// Finds the steps; false, with one sentence, when the path leads to no value.
bool findPath(const google::protobuf::Descriptor& type, std::string_view path, MessagePath& found,
              std::string& error);

/// The value, missing where the message does not have it. `scratch` may hold its text.
RocinanteProtobufValue valueAt(const google::protobuf::Message& message, const MessagePath& path,
                               std::string& scratch);
RocinanteProtobufValue valueOf(const google::protobuf::Message& message,
                               const MessagePath::Step& step, std::string& scratch);

}  // namespace rocinante::protobuf
