// Files embedded in the program, which then needs no files where it runs.
#pragma once

#include <string_view>

/// Defines `NAME`, a std::string_view of the bytes of the file at `path`, a literal. The text is
/// not copied. At namespace scope, once a program for each name.
#define TOILE_EMBED(name, path)                    \
  asm(".section .rodata\n"                         \
      ".global " #name "_bytes\n" #name            \
      "_bytes:\n"                                  \
      ".incbin \"" path                            \
      "\"\n"                                       \
      ".global " #name "_end\n" #name              \
      "_end:\n"                                    \
      ".byte 0\n"                                  \
      ".text\n");                                  \
  extern "C" const char name##_bytes[];            \
  extern "C" const char name##_end[];              \
  static const std::string_view name(name##_bytes, \
                                     static_cast<std::size_t>(name##_end - name##_bytes))
