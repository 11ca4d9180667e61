#include "core/base/json_parse.h"

#include <nlohmann/json.hpp>
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

template <class Tree>
Result<Tree> parseJson(std::string_view text, const JsonLimits& limits) {
  if (Status fits = checkJsonSize(text, limits); !fits) return fits.error();
  Tree tree = Tree::parse(text, nullptr, /*allow_exceptions=*/false);
  if (tree.is_discarded()) return Error{ErrorKind::damaged, "it is not JSON", {}};
  return tree;
}
template Result<nlohmann::json> parseJson(std::string_view, const JsonLimits&);
template Result<nlohmann::ordered_json> parseJson(std::string_view, const JsonLimits&);

}  // namespace rocinante
