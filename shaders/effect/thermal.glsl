// What the heat of the disc looks like from here, linear light.
vec3 thermal_light(DiscFlow flow) { return seen_black_body(frame.disc_heat.z + flow.heat, flow.g, frame.disc_heat.w); }
