#include "core/foreign/protobuf/message_cost.h"

#include <google/protobuf/message.h>

namespace rocinante::protobuf {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

constexpr int kDeepest = 64;
constexpr std::size_t kMaxObjectBytes = std::size_t{64} << 20U;

bool takeVarint(std::string_view& bytes, std::uint64_t& value) {
  value = 0;
  for (unsigned i = 0; i < 10 && i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    value |= static_cast<std::uint64_t>(byte & 0x7FU) << (7 * i);
    if (byte < 0x80) {
      bytes.remove_prefix(i + 1);
      return true;
    }
  }
  return false;
}

}  // namespace

MessageCost::Answer MessageCost::of(const Descriptor& type, std::string_view bytes) {
  bytes_ = 0;
  bool any_known = bytes.empty();
  const Answer answer = walk(type, bytes, 0, 0, any_known);
  return answer == Answer::fits && !any_known ? Answer::unknown : answer;
}

bool MessageCost::add(const Descriptor& type) {
  auto [found, is_new] = sizes_.try_emplace(&type, 0);
  if (is_new) {
    const auto size = factory_.GetPrototype(&type)->SpaceUsedLong();
    found->second = static_cast<std::size_t>(size);
  }
  bytes_ += found->second + sizeof(void*);
  return bytes_ <= kMaxObjectBytes;
}

MessageCost::Answer MessageCost::walk(const Descriptor& type, std::string_view& bytes, int depth,
                                      std::uint32_t group, bool& any_known) {
  if (depth > kDeepest) return Answer::too_deep;
  if (!add(type)) return Answer::too_large;
  while (!bytes.empty()) {
    std::uint64_t tag = 0;
    std::uint64_t length = 0;
    if (!takeVarint(bytes, tag) || tag > UINT32_MAX) return Answer::malformed;
    const auto number = static_cast<std::uint32_t>(tag >> 3U);
    if (number == 0) return Answer::malformed;
    const FieldDescriptor* const field = type.FindFieldByNumber(static_cast<int>(number));
    if (field != nullptr) any_known = true;
    const bool is_message =
        field != nullptr && field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    switch (tag & 7U) {
      case 0:
        if (!takeVarint(bytes, length)) return Answer::malformed;
        break;
      case 1:
        if (bytes.size() < 8) return Answer::malformed;
        bytes.remove_prefix(8);
        break;
      case 2: {
        if (!takeVarint(bytes, length) || length > bytes.size()) return Answer::malformed;
        std::string_view inner = bytes.substr(0, static_cast<std::size_t>(length));
        bytes.remove_prefix(inner.size());
        if (!is_message) break;
        bool any_inner = false;
        const Answer answer = walk(*field->message_type(), inner, depth + 1, 0, any_inner);
        if (answer != Answer::fits) return answer;
        break;
      }
      case 3: {
        // Of an unknown group the type itself stands for the contents: it costs, and ends, alike.
        bool any_inner = false;
        const Answer answer =
            walk(is_message ? *field->message_type() : type, bytes, depth + 1, number, any_inner);
        if (answer != Answer::fits) return answer;
        break;
      }
      case 4:
        return number == group ? Answer::fits : Answer::malformed;
      case 5:
        if (bytes.size() < 4) return Answer::malformed;
        bytes.remove_prefix(4);
        break;
      default:
        return Answer::malformed;
    }
  }
  return group == 0 ? Answer::fits : Answer::malformed;
}

}  // namespace rocinante::protobuf
