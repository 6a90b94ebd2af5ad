// The sky at the other end of a wormhole, a cube map of the size of the celestial sphere's.
vec3 other_side(Trace trace, float level) { return textureLod(other_side_texture, trace.sky, level).rgb; }
