// Where rays stay in planes azimuths are the matter's own.
vec3 azimuth_turned(vec3 at, float turn) { return at; }
float azimuth_plus(float phi, float turn) { return phi; }
