// One combination of effects of the shader core, after its text (coretexts/main.cpp).
static_assert(sizeof(FrameData) == kFrameVectors * 4 * sizeof(Real));

RayPixel trace_one(const CoreInput& input, double x, double y) {
    for (std::size_t i = 0; i < input.frame.size(); ++i)
        reinterpret_cast<Real*>(&frame)[i] = static_cast<Real>(input.frame[i]);
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
    pixel.steps = steps_of(data);
    pixel.u = data.place.x;
    pixel.v = data.place.y;
    pixel.w = data.place.z;
    return pixel;
}
