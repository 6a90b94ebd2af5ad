// What the driver says of a shader or a program.
#pragma once
#include <glad/gl.h>

#include <algorithm>
#include <string>

namespace nullscope::gl {

// get, get_log: glGetShaderiv and glGetShaderInfoLog, or those of programs.
template <class Length, class Log>
std::string log_of(GLuint id, Length get, Log get_log) {
    GLint length = 0;
    get(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    get_log(id, length, nullptr, log.data());
    return log.c_str();
}

}  // namespace nullscope::gl
