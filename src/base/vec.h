// Vec3 and Mat3 in double for the host: cameras, tetrads, the reference. (The shader core has its own types.)
#pragma once
#include <cmath>

namespace nullscope {

struct Vec3 {
    double x = 0, y = 0, z = 0;
    friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
    friend Vec3 operator*(Vec3 a, double s) { return s * a; }
    friend Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
    friend bool operator==(const Vec3&, const Vec3&) = default;  // every digit
};

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::hypot(a.x, a.y, a.z); }
inline Vec3 normalized(Vec3 a) { return a / length(a); }
// Angle between two directions, exact for small and for straight angles. [0, pi]
inline double angle_between(Vec3 a, Vec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

// Columns are the images of the three axes: Mat3{a, b, c} * v = v.x a + v.y b + v.z c.
struct Mat3 {
    Vec3 a{1, 0, 0}, b{0, 1, 0}, c{0, 0, 1};
    friend Vec3 operator*(const Mat3& m, Vec3 v) { return v.x * m.a + v.y * m.b + v.z * m.c; }
    friend Mat3 operator*(const Mat3& m, const Mat3& n) { return {m * n.a, m * n.b, m * n.c}; }
};
inline Mat3 transposed(const Mat3& m) { return {{m.a.x, m.b.x, m.c.x}, {m.a.y, m.b.y, m.c.y}, {m.a.z, m.b.z, m.c.z}}; }

}  // namespace nullscope
