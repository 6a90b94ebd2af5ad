// One combination of effects of the shader core, after its text (coretexts/main.cpp).
vec4 as_vec4(const FrameVector& v) { return vec4(v.x, v.y, v.z, v.w); }

void begin(const CoreInput& input) {
    std::array<vec4, kFrameVectors> members;
    std::ranges::transform(vectors_of(input.frame), members.begin(), as_vec4);
    frame = std::bit_cast<FrameData>(members);
    texels = {input.strip, input.ends, input.orbit, input.delay};
}

RayPixel pixel_of(const CoreInput& input, const PixelData& data) {
    RayPixel pixel;
    pixel.fate = static_cast<Fate>(static_cast<int>(data.fate));
    pixel.sky = {data.sky.x, data.sky.y, data.sky.z};
    pixel.g = data.g;
    const bool timed = input.spin ? input.spin_delay : input.delay.data != nullptr || !input.lensing;
    pixel.delay = timed ? data.delay : 0.0;
    pixel.angle = data.angle;
    pixel.order = static_cast<int>(std::floor(pixel.angle / M_PI));
    pixel.hit = static_cast<int>(data.hit);
    pixel.steps = static_cast<int>(data.steps);
    pixel.u = data.place.x;
    pixel.v = data.place.y;
    pixel.w = data.place.z;
    return pixel;
}

RayPixel trace_one(const CoreInput& input, double x, double y) {
    begin(input);
    return pixel_of(input, pixel_data(vec2(static_cast<Real>(x), static_cast<Real>(y))));
}

void trace_list(const CoreInput& input, const ListedCrossings& asked, std::span<const RayNumbers> rays, ListedRay* found) {
    begin(input);
    listed_first = asked.first, listed_most = asked.most;
    const FrameData every_ray = frame;
    for (const RayNumbers& ray : rays) {
        frame = every_ray;
        const ListedData data = listed_data(as_vec4(ray.start), as_vec4(ray.radial), as_vec4(ray.meridian), as_vec4(ray.ray));
        ListedRay& answer = *found++;
        answer.end = pixel_of(input, data.end);
        answer.count = data.count, answer.more = data.more, answer.at = data.at;
        const vec4 all[] = {data.crossing_0, data.crossing_1, data.crossing_2, data.crossing_3};
        for (std::size_t k = 0; k < answer.crossings.size(); ++k) answer.crossings[k] = {all[k].x, all[k].y, all[k].z};
    }
}
