#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/dynamic_message.h>

#include <cstdint>
#include <string_view>
#include <unordered_map>

namespace rocinante::protobuf {

/// Walks a message's bytes before libprotobuf makes objects of them: two bytes can stand for a
/// message of any size. One thread.
class MessageCost {
 public:
  enum class Answer : std::uint8_t { fits, malformed, too_deep, too_large, unknown };

  explicit MessageCost(google::protobuf::DynamicMessageFactory& factory) : factory_(factory) {}

  /// `unknown`: there are fields, and the type has none of them.
  Answer of(const google::protobuf::Descriptor& type, std::string_view bytes);

 private:
  Answer walk(const google::protobuf::Descriptor& type, std::string_view& bytes, int depth,
              std::uint32_t group, bool& any_known);
  bool add(const google::protobuf::Descriptor& type);

  google::protobuf::DynamicMessageFactory& factory_;
  std::unordered_map<const google::protobuf::Descriptor*, std::size_t> sizes_;
  std::size_t bytes_ = 0;  ///< of the objects so far
};

}  // namespace rocinante::protobuf
