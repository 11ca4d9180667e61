#include "viewer/ui/panels/panel_parts.h"

#include <algorithm>
#include <cctype>

namespace rocinante {

bool containsWord(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  return word.empty() ||
         std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

}  // namespace rocinante
