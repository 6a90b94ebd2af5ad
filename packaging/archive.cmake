# Makes OUT/nullscope-VERSION-linux-MACHINE.tar.gz of what is built in BUILD: the programs with the libraries that other distributions may
# lack, to be unpacked anywhere. Needs patchelf.
#
#     cmake -DBUILD=build/release -DOUT=out -P packaging/archive.cmake
#
# Not in it, because the OpenGL driver brings its own and a process can have but one of each: the C and C++ libraries (those of the
# system that built it, or newer, are needed), zlib, zstd, expat, X11 and Wayland, OpenGL, and FreeType.
cmake_minimum_required(VERSION 3.25)
set(system "^(ld-linux|lib(c|m|dl|rt|pthread|resolv|stdc\\+\\+|gcc_s|z|zstd|expat|freetype|X.*|xcb.*|wayland.*|GL.*|EGL.*|OpenGL|drm.*|bsd|md|ffi))[.-]")

file(REAL_PATH ${BUILD} BUILD BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
file(REAL_PATH ${OUT} OUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
file(STRINGS ${BUILD}/CMakeCache.txt version REGEX "^CMAKE_PROJECT_VERSION:")
string(REGEX REPLACE ".*=" "" version ${version})
cmake_host_system_information(RESULT machine QUERY OS_PLATFORM)
set(name nullscope-${version}-linux-${machine})
set(root ${BUILD}/archive/${name})
file(REMOVE_RECURSE ${root})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${root} --strip OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${root}/share/lintian ${root}/share/doc/nullscope/changelog.Debian.gz)

file(GLOB programs ${root}/bin/*)
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${programs} RESOLVED_DEPENDENCIES_VAR libraries PRE_EXCLUDE_REGEXES ${system})
file(MAKE_DIRECTORY ${root}/lib/nullscope)
set(notes "")
foreach(library IN LISTS libraries)
  get_filename_component(soname ${library} NAME)
  get_filename_component(file ${library} REALPATH)
  file(COPY_FILE ${file} ${root}/lib/nullscope/${soname})
  execute_process(COMMAND dpkg-query --search ${file} OUTPUT_VARIABLE package ERROR_QUIET)
  string(REGEX REPLACE ":.*" "" package "${package}")
  if(package STREQUAL "")   # dpkg may know it without /usr
    string(REGEX REPLACE "^/usr" "" file ${file})
    execute_process(COMMAND dpkg-query --search ${file} OUTPUT_VARIABLE package COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX REPLACE ":.*" "" package "${package}")
  endif()
  execute_process(COMMAND dpkg-query --show "--showformat=\${Version}" ${package} OUTPUT_VARIABLE of COMMAND_ERROR_IS_FATAL ANY)
  string(APPEND notes "${soname}: ${package} ${of}\n")
  file(INSTALL /usr/share/doc/${package}/copyright DESTINATION ${root}/share/doc/nullscope/libraries RENAME ${package} MESSAGE_NEVER FOLLOW_SYMLINK_CHAIN)
endforeach()
file(WRITE ${root}/share/doc/nullscope/libraries/README "Libraries in lib/nullscope, from these packages of Debian; their licences are beside this file.\n\n${notes}")
file(GLOB copies ${root}/lib/nullscope/*)
execute_process(COMMAND chmod 755 ${copies} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND patchelf --set-rpath "$ORIGIN/../lib/nullscope" ${programs} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND patchelf --set-rpath "$ORIGIN" ${copies} COMMAND_ERROR_IS_FATAL ANY)

file(MAKE_DIRECTORY ${OUT})
execute_process(COMMAND tar --sort=name --owner=0 --group=0 --numeric-owner -czf ${OUT}/${name}.tar.gz ${name}
                WORKING_DIRECTORY ${BUILD}/archive COMMAND_ERROR_IS_FATAL ANY)
message("${OUT}/${name}.tar.gz")
