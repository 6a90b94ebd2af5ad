// One combination of effects of the shader core, after its text (coretexts/main.cpp).
RayPixel trace_one(const CoreInput& input, double x, double y) {
    std::array<vec4, kFrameVectors> members;
    std::ranges::transform(vectors_of(input.frame), members.begin(),
                           [](const FrameVector& v) { return vec4(v.x, v.y, v.z, v.w); });
    frame = std::bit_cast<FrameData>(members);
    texels = {input.strip, input.ends, input.orbit, input.delay};
    const PixelData data = pixel_data(vec2(static_cast<Real>(x), static_cast<Real>(y)));
    RayPixel pixel;
    pixel.fate = static_cast<Fate>(static_cast<int>(data.fate));
    pixel.sky = {data.sky.x, data.sky.y, data.sky.z};
    pixel.g = data.g;
    pixel.delay = input.delay.data != nullptr || !input.lensing ? data.delay : 0.0;
    pixel.angle = data.angle;
    pixel.order = static_cast<int>(std::floor(pixel.angle / M_PI));
    pixel.hit = static_cast<int>(data.hit);
    pixel.steps = static_cast<int>(data.steps);
    pixel.u = data.place.x;
    pixel.v = data.place.y;
    pixel.w = data.place.z;
    return pixel;
}
