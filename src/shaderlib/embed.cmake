# Writes OUTPUT, a C++ file that holds every file of shaders/ (DIRECTORY) as text. Comments, which no shader is compiled with, are left out: a third of the page's
# copy. Lines keep their numbers.
file(GLOB_RECURSE files RELATIVE ${DIRECTORY} ${DIRECTORY}/*.glsl ${DIRECTORY}/*.frag ${DIRECTORY}/*.vert ${DIRECTORY}/*.comp)
set(text "#include \"shaderlib/embedded.h\"\n\n#include <array>\n\nusing namespace std::string_view_literals;\n\nnamespace nullscope {\n\n")
list(LENGTH files count)
string(APPEND text "std::span<const EmbeddedShader> embedded_shaders() {\n    static constexpr std::array<EmbeddedShader, ${count}> files = {{\n")
# Their length is the literal's: counting characters is work that compilers limit.
foreach(file ${files})
  file(READ ${DIRECTORY}/${file} content)
  string(REGEX REPLACE "[ \t]*//[^\n]*" "" content "${content}")
  string(APPEND text "{\"${file}\", R\"glsl(${content})glsl\"sv},\n")
endforeach()
string(APPEND text "    }};\n    return files;\n}\n\n}  // namespace nullscope\n")
file(WRITE ${OUTPUT} "${text}")
