// What the heat of the disc looks like from here, linear light.
vec3 thermal_light(DiscMatter matter) { return seen_black_body(frame.disc_heat.z + matter.heat, matter.g, frame.disc_heat.w); }
