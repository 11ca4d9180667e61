#include "core/base/count_text.h"

namespace rocinante {

std::string countText(std::uint64_t number, std::string_view one) {
  std::string text = std::to_string(number) + " " + std::string(one);
  return number == 1 ? text : text + "s";
}

}  // namespace rocinante
