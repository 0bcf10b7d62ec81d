#include "viz/page/page_texts.h"

// The assembler puts the bytes in: a compiler would take seconds over a literal of a megabyte.
#define AMBLE_TEXT(name, file)                                                   \
  asm(".section .rodata\n"                                                       \
      ".global amble_" #name "_begin\n.global amble_" #name                      \
      "_end\n"                                                                   \
      "amble_" #name "_begin:\n.incbin \"" AMBLE_WEB "/" file "\"\namble_" #name \
      "_end:\n"                                                                  \
      ".byte 0\n.previous\n");                                                   \
  extern "C" const char amble_##name##_begin[];                                  \
  extern "C" const char amble_##name##_end[];

AMBLE_TEXT(page_frame, "page.html")
AMBLE_TEXT(page_style, "page.css")
AMBLE_TEXT(page_script, "page.js")

namespace amble {

std::string_view pageFrame() { return {amble_page_frame_begin, amble_page_frame_end}; }
std::string_view pageStyle() { return {amble_page_style_begin, amble_page_style_end}; }
std::string_view pageScript() { return {amble_page_script_begin, amble_page_script_end}; }

}  // namespace amble
