#include "compare/page_template.h"

// The files as they are, put into the program by the assembler.
#define VOROPROBE_EMBED(name, path)                                                                          \
    __asm__(".section .rodata\n"                                                                             \
            ".global " #name "_begin\n" #name "_begin:\n"                                                    \
            ".incbin \"" path "\"\n"                                                                         \
            ".global " #name "_end\n" #name "_end:\n"                                                        \
            ".byte 0\n"                                                                                      \
            ".previous\n");                                                                                  \
    extern "C" const char name##_begin[]; /* NOLINT(readability-identifier-naming) */                        \
    extern "C" const char name##_end[]    /* NOLINT(readability-identifier-naming) */

VOROPROBE_EMBED(voroprobe_page, VOROPROBE_REPORT_FOLDER "/page.html");
VOROPROBE_EMBED(voroprobe_index, VOROPROBE_REPORT_FOLDER "/index.html");

namespace voroprobe
{

std::string_view page_template()
{
    return {voroprobe_page_begin, static_cast<std::size_t>(voroprobe_page_end - voroprobe_page_begin)};
}

std::string_view index_template()
{
    return {voroprobe_index_begin, static_cast<std::size_t>(voroprobe_index_end - voroprobe_index_begin)};
}

} // namespace voroprobe
