#include "core/base/json_parse.h"

#include <string>

namespace rocinante {

Status checkJsonSize(std::string_view text, const JsonLimits& limits) {
  const auto refuse = [](const std::string& what) {
    return Error{ErrorKind::unsupported, "its JSON " + what, {}};
  };
  if (text.size() > limits.bytes) {
    return refuse("is larger than " + std::to_string(limits.bytes) + " bytes");
  }
  int depth = 0;
  std::size_t values = 1;
  for (std::size_t at = 0; at < text.size(); ++at) {
    switch (text[at]) {
      case '"':
        for (++at; at < text.size() && text[at] != '"'; ++at) {
          if (text[at] == '\\') ++at;
        }
        break;
      case '[':
      case '{':
        ++values;
        if (++depth > limits.depth) {
          return refuse("is nested deeper than " + std::to_string(limits.depth));
        }
        break;
      case ']':
      case '}':
        --depth;
        break;
      case ',':
        ++values;
        break;
      default:
        continue;
    }
    if (values > limits.values) {
      return refuse("has more than " + std::to_string(limits.values) + " values");
    }
  }
  return {};
}

}  // namespace rocinante
