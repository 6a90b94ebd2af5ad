// Functions of OpenGL ES 3.0, which the page gives (page/webgl.js).
#pragma once
#include <GLES3/gl3.h>

#define GL_PROGRAM_POINT_SIZE 0x8642  // WebGL: always on
