// Places in a sky's texture: the faces of a cube are its layers, in the order and orientation of OpenGL's cube maps (3.3 core, table 3.19), each
// with a border of what lies beside it (src/sky/packed_sky.h). Software drivers sample these faster than a seamless cube map.
#define SKY_FACE_HALF (0.5 * 32.0 / 34.0) // of a layer's width, half a face: a border is 1/32 of the face

struct SkyFace {
    bool on_x;
    bool on_y;       // else on z
    float facing;    // -1 or 1
    float layer;
};

SkyFace sky_face(vec3 direction) {
    vec3 size = abs(direction);
    SkyFace face;
    face.on_x = size.x >= max(size.y, size.z);
    face.on_y = !face.on_x && size.y >= size.z;
    face.facing = (face.on_x ? direction.x : face.on_y ? direction.y : direction.z) < 0.0 ? -1.0 : 1.0;
    face.layer = (face.on_x ? 0.0 : face.on_y ? 2.0 : 4.0) + (0.5 - 0.5 * face.facing);
    return face;
}

// Of a direction on that face, or next to it: what textureLod takes.
vec3 sky_face_place(SkyFace face, vec3 at) {
    float major = abs(face.on_x ? at.x : face.on_y ? at.y : at.z);
    vec2 place = face.on_x ? vec2(-face.facing * at.z, -at.y) : face.on_y ? vec2(at.x, face.facing * at.z) : vec2(face.facing * at.x, -at.y);
    return vec3(place * (SKY_FACE_HALF / major) + 0.5, face.layer);
}
