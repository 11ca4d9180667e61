#include "core/log/log_profile.h"

#include <fmt/format.h>

namespace rocinante::profile {

std::string otherFormatText(std::string_view format) {
  return fmt::format(
      "rocinante.session says format \"{}\", and this program reads format {}: the contents "
      "may mean something else; use the program that wrote it or a later one",
      format.substr(0, 40), kFormat);
}

}  // namespace rocinante::profile
