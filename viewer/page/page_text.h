#pragma once

#include <string_view>

namespace rocinante {

// The files page.html, page.css and page.js beside this one, built in (cmake/embed_text.cmake).
extern const std::string_view kPageHtml, kPageStyle, kPageScript;

}  // namespace rocinante
