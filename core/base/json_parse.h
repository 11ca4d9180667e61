#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

#include "core/base/result.h"

namespace rocinante {

/// How much JSON of strangers may have. A value takes up to about 100 bytes of memory.
struct JsonLimits {
  std::size_t bytes = std::size_t{256} << 20U;
  std::size_t values = std::size_t{4} << 20U;
  int depth = 64;
};
/// Of a message of a few fields. Also bounds the time of nlohmann::ordered_json, which grows with
/// the square of an object's keys.
inline constexpr JsonLimits kSmallJson{64U << 10U, 1024, 16};

/// unsupported, as a sentence about the text and without a place, when it exceeds the limits:
/// before anything is built of it. Does not judge whether it is JSON.
Status checkJsonSize(std::string_view text, const JsonLimits& limits = {});

/// Every JSON that a stranger may have written is parsed here. `Tree`: nlohmann::json or
/// ordered_json, whose parsers are compiled once, in json_parse.cpp. damaged when it is not JSON;
/// unsupported as checkJsonSize().
template <class Tree>
Result<Tree> parseJson(std::string_view text, const JsonLimits& limits = {});
/// The same where what is wrong does not matter: a discarded value.
template <class Tree>
Tree parseJsonOrDiscard(std::string_view text, const JsonLimits& limits = {}) {
  Result<Tree> tree = parseJson<Tree>(text, limits);
  return tree.ok() ? std::move(*tree) : Tree(Tree::value_t::discarded);
}

}  // namespace rocinante
