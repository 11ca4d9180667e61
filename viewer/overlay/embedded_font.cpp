#include "viewer/overlay/embedded_font.h"

// ROCINANTE_FONT_FILE is set by CMakeLists.txt. The assembler embeds the file: a C++ array would
// take seconds to compile.
#ifdef __wasm__
asm(".section .rodata.rocinante_font,\"\",@\n"
    ".globl rocinante_font_begin\n"
    ".type rocinante_font_begin,@object\n"
    "rocinante_font_begin:\n"
    ".incbin \"" ROCINANTE_FONT_FILE
    "\"\n"
    ".Lrocinante_font_last:\n"
    ".size rocinante_font_begin, .Lrocinante_font_last-rocinante_font_begin\n"
    ".globl rocinante_font_end\n"
    ".type rocinante_font_end,@object\n"
    "rocinante_font_end:\n"
    ".int8 0\n"
    ".size rocinante_font_end, 1\n");
#else
asm(".section .rodata\n"
    ".balign 16\n"
    ".global rocinante_font_begin\n"
    "rocinante_font_begin:\n"
    ".incbin \"" ROCINANTE_FONT_FILE
    "\"\n"
    ".global rocinante_font_end\n"
    "rocinante_font_end:\n"
    ".byte 0\n"
    ".previous\n");
#endif

extern "C" {
// Hidden, so that their distance is a link-time constant in a shared library too.
extern const std::byte rocinante_font_begin[] __attribute__((visibility("hidden")));
extern const std::byte rocinante_font_end[] __attribute__((visibility("hidden")));
}

namespace rocinante {

ByteView embeddedFont() { return ByteView(rocinante_font_begin, rocinante_font_end); }

}  // namespace rocinante
