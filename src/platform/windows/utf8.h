// Narrow text is UTF-8 in the whole program.
#pragma once

namespace nullscope::platform {

// Words of the command line, the environment and names for the C library are it by the program's manifest; this is for std::filesystem::path,
// which takes narrow text by mbrtowc(): msvcrt's knows no UTF-8, and takes each byte for a character of Latin-1. The call does nothing, but a
// program with it is linked to the mbrtowc(), wcrtomb() and MB_CUR_MAX beside it in place of msvcrt's.
void use_utf8();

}  // namespace nullscope::platform
