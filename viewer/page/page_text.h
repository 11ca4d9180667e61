#pragma once

#include <string_view>

namespace rocinante {

// The files page.html, page.css, page.js, page_*.js and served.js beside this one, built in
// (cmake/embed_text.cmake).
extern const std::string_view kPageHtml, kPageStyle, kPageScript, kServedScript;
extern const std::string_view kPageParts, kPageCalls, kPagePanels, kPagePlots, kPagePointers;

}  // namespace rocinante
