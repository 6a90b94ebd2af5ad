// What covers a body, the disc or the sky: the numbers of its texture.
struct Material {
    vec4 map;      // cosine and sine of the rotation, columns, rows
    vec4 colour;   // the first colour, limb
    vec4 second;   // the second colour, latitude of the band
    float size;    // r_s: the length that grains are counted over
};
