#pragma once

namespace rocinante::test {

/// A layout with everything that one can have, as it is written.
inline constexpr char kLayoutText[] =
    R"(# A layout of rocinante view: --layout, or the command `layout`.
format = 1
theme = "light"
camera = "over"
plots = ["arm.turn", "signal - state", "arm:x over d/dt arm.turn", "arm/hand:y over arm/hand:x"]
plots_height = 240.0
plots_hidden = true
insets = ["over:bottom-left:160x120px"]

[[panel]]
name = "device"
right = 10.0
top = 20.5

[[panel]]
name = "left"
width = 320.0
collapsed = true
)";

}  // namespace rocinante::test
