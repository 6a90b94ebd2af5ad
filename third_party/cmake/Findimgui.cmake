# Dear ImGui from the distribution (libimgui-dev), with its GLFW and OpenGL3 backends: target imgui::imgui.
find_package(PkgConfig REQUIRED)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET GLOBAL imgui)
if(NOT TARGET imgui::imgui)
  add_library(imgui::imgui ALIAS PkgConfig::imgui)
endif()
