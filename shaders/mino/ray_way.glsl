// Which way a ray about a rotating hole went, for effect/edge.glsl. An image of the disc thinner than a pixel may lie between two rays: one
// crosses the plane outside of the disc, the other inside of it or is captured before. So what counts is how often an escaping ray crosses
// inside of the inner rim, and how often a captured one outside of the outer rim.
float spin_way(bool escapes, float within, float beyond) { return escapes ? 2.0 + mod(within, 2.0) : mod(beyond, 2.0); }

// Where there is no disc.
float open_way(bool escapes) { return spin_way(escapes, 0.0, 0.0); }
