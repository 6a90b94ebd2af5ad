// Matter at a place, as formulas or a file have it.
struct MediumMatter {
    float density;
    float temperature;   // K
    float field;         // G
    vec3 field_way;      // its direction where the matter rests
    vec3 velocity;       // four-velocity's along e_r, e_theta, e_phi of the observer of no angular momentum
};
