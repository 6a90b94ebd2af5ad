// Which way a ray in a plane went, for effect/edge.glsl, where nothing is on it: one.
float open_way(bool escapes) { return 0.0; }
