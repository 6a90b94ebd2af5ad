# stb from the distribution (libstb-dev): target stb::stb.
find_package(PkgConfig REQUIRED)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET GLOBAL stb)
if(NOT TARGET stb::stb)
  add_library(stb::stb ALIAS PkgConfig::stb)
endif()
