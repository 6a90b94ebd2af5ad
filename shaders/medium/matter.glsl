// The contract of matter along rays. Each model has a file that defines
//     MediumMatter medium_matter(MediumPlace place)
//     float medium_free(float r, float cosine)      how far matter is at least, r_s; not above 0 within it
//     #define MEDIUM_WEDGE                          if there is none where |cosine| is larger: rays that stay in a plane go there at once
// and each emission law one that defines
//     MediumLight medium_light(MediumPlace place, MediumMatter matter)
// Their numbers have names (generated/medium_matter).
struct MediumMatter {
    float density;       // electrons a cm^3, or over that of emissivity or opacity ...
    float over;          // ... and to be divided by this
    float inside;        // part of the sample that lies in it
    float temperature;   // K
    float heat;          // log2 of that
    float field;         // G
    vec3 field_way;      // its direction where the matter rests
    vec3 velocity;       // four-velocity's along e_r, e_theta, e_phi of the observer of no angular momentum
    float g;             // camera frequency over that in the matter
    float shortest;      // length of the march that is short enough here, r_s: the least of it, where matter is opaque,
    float longest;       //   and the most
};

// A sample of cold matter at rest, as long as it may be.
MediumMatter medium_nothing_there(float longest) {
    return MediumMatter(0.0, 1.0, 1.0, 0.0, 0.0, 0.0, vec3(0.0), vec3(0.0), 1.0, longest, longest);
}

MediumMatter medium_heated(MediumMatter matter) {
    matter.heat = log2(clamp(matter.temperature, 1.0, 1.0e12));
    return matter;
}
