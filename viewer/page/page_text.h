#pragma once

#include <string_view>

namespace rocinante {

// The files page.html, family.css, page.css, page.js, page_*.js and served.js beside this one,
// built in (cmake/embed_text.cmake). family.css is that of the report of goldens, too.
extern const std::string_view kPageHtml, kPageFamily, kPageStyle, kPageScript, kServedScript;
extern const std::string_view kPageParts, kPageCalls, kPagePanels, kPagePlots, kPagePointers;

}  // namespace rocinante
