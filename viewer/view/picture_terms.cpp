#include "viewer/view/picture_terms.h"

#include <fmt/format.h>

#include <utility>

#include "viewer/view/inset_layout.h"

namespace rocinante {

std::vector<std::string> pictureWords(const PictureTerms& terms, StyleOptions options) {
  // By name, so that a new term does not compile until it is said.
  const auto& [width, height, scale, samples, hide, show, style, insets, panel] = terms;
  std::vector<std::string> words{"--size", fmt::format("{}x{}", width, height)};
  const auto add = [&words](std::string option, std::string value) {
    words.push_back(std::move(option));
    words.push_back(std::move(value));
  };
  if (scale != 1) add("--scale", fmt::format("{}", scale));
  add("--samples", fmt::format("{}", samples));
  for (const std::string& path : hide) add("--hide", path);
  for (const std::string& path : show) add("--show", path);
  if (insets && insets->empty()) words.emplace_back("--no-insets");
  for (const CellInset& inset : insets ? *insets : std::vector<CellInset>()) {
    add("--inset", insetText(inset));
  }
  if (panel) words.emplace_back("--overlay");
  for (const auto& [key, value] : styleWords(style)) {
    const std::string word = key + "=" + value;
    if (options == StyleOptions::each) {
      words.push_back("--" + word);
    } else {
      add("--style", word);
    }
  }
  return words;
}

Result<std::optional<std::vector<CellInset>>> parseInsets(const std::vector<std::string>& words,
                                                          bool none) {
  std::optional<std::vector<CellInset>> insets;
  if (none || !words.empty()) insets.emplace();
  for (const std::string& text : words) {
    auto inset = parseInset(text);
    if (!inset) return inset.error();
    insets->push_back(std::move(*inset));
  }
  return insets;
}

}  // namespace rocinante
