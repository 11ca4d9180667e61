#include "core/net/interfaces.h"

#include <net/if.h>

#include <memory>

namespace rocinante {

std::string interfaceNames() {
  const std::unique_ptr<struct if_nameindex, void (*)(struct if_nameindex*)> list(
      ::if_nameindex(), ::if_freenameindex);
  constexpr std::size_t kShown = 16;
  std::string names;
  std::size_t count = 0;
  for (const struct if_nameindex* each = list.get(); each != nullptr && each->if_index != 0;
       ++each, ++count) {
    if (count == kShown) return names + " ...";
    if (count > 0) names += ", ";
    names += each->if_name;
  }
  return count == 0 ? "none" : names;
}

}  // namespace rocinante
