#pragma once

#include <string>

#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// A line over the picture about what is published or watched.
struct OthersBanner {
  std::string what;  ///< empty: none
  std::string hint;
  bool is_fault = false;
};
OthersBanner othersBanner(const ViewModel& model);

/// The viewpoints of others, and what they see of this window. Nothing outside a live session
/// unless something is published.
void drawOthers(ViewModel& model);

}  // namespace rocinante
