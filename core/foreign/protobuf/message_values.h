#pragma once

#include <google/protobuf/message.h>

#include "core/foreign/protobuf/protobuf_module.h"

namespace rocinante::protobuf {

/// Names every value of a message, in the order of its fields, until `found` answers 0. Maps and
/// what lies in unknown groups are left out.
void listValues(const google::protobuf::Message& message, RocinanteProtobufFound found, void* to);

}  // namespace rocinante::protobuf
