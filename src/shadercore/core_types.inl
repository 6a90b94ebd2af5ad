// GLSL types and functions for shaders/*.glsl compiled as C++: included inside a namespace where Real is float or double.
using vec2 = glm::vec<2, Real, glm::defaultp>;
using vec3 = glm::vec<3, Real, glm::defaultp>;
using vec4 = glm::vec<4, Real, glm::defaultp>;
using glm::abs;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::floor;
using glm::inversesqrt;
using glm::log2;
using glm::max;
using glm::min;
using glm::normalize;
using glm::sin;
using glm::sqrt;
