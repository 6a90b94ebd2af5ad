// The driver's layout of the uniform block is that of the C++ struct.
#include "shadercore/frame_data.h"
#include "shaderlib/shader_source.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;
using namespace nullscope::test;

// Members of FrameData as the text declares them.
std::vector<std::string> frame_members() {
    std::vector<std::string> members;
    const std::string text(shader_file("shared/frame_block.glsl"));
    for (std::size_t at = text.find("    vec4 "); at != std::string::npos; at = text.find("    vec4 ", at + 1)) {
        const std::size_t name = at + 9;
        members.push_back("frame." + text.substr(name, text.find(';', name) - name));
    }
    return members;
}

// What a scene has in it, one bit each.
Scene scene_of(unsigned bits) {
    const auto has = [&](unsigned bit) { return (bits >> bit & 1u) != 0; };
    Scene scene;
    scene.spacetime.metric = has(0) ? "schwarzschild" : "minkowski";
    if (has(1)) scene.camera.velocity = {0, 0, 0.5};
    if (has(2)) scene.disc.emplace().opacity = 0.5;
    if (has(2) && has(0)) {  // not in flat space: both kinds of disc
        scene.disc->emission = DiscEmission::kThermal;
        scene.disc->image = "emissivity.png";
    }
    scene.sky.kind = !has(3) ? SkyKind::kBlack : has(0) ? SkyKind::kPoints : SkyKind::kStars;
    if (has(1) && has(3)) scene.sky.temperature_K = 5000.0;
    scene.picture.bloom = has(7) ? 0.1 : 0.0;
    if (has(2) && has(3) && !has(0)) scene.disc->look.texture = TextureKind::kGrid;  // in flat space both again
    if (has(3) && has(8) && !has(0)) scene.sky.kind = SkyKind::kChecker;
    if (has(4)) scene.sphere.emplace().look.texture = TextureKind::kChecker;
    if (has(5)) scene.cylinder.emplace().look.texture = TextureKind::kNoise;
    if (has(6)) scene.ball.emplace().look.texture = TextureKind::kImage;
    if (has(7)) scene.surface.emplace();
    if (has(2) && has(8)) scene.disc->flow = DiscFlowKind::kKepler, scene.spot.emplace();
    if (has(6) && has(8)) scene.ball->motion = BallMotion::kOrbit;
    return scene;
}
constexpr unsigned kEverything = 511;

std::vector<int> driver_offsets(const Scene& scene, const EffectSet& effects, const std::vector<std::string>& members) {
    const ShaderSource source = shader_source(Stage::kPicture, effects, Output::kDisplay, {}, scene.spacetime.metric,
                                              body_text(scene, effects));
    return gl::uniform_offsets(gl::make_program(source.vertex, source.fragment), members);
}

TEST_CASE("uniform block: the driver's offsets are those of the C++ struct") {
    const auto members = frame_members();
    REQUIRE(members.size() == kFrameVectors);
    REQUIRE(members.front() == "frame.image");
    on_every_context([&](GpuSession&) {
        // No scene has both a disc's image and a texture of it, or two kinds of sky; a block can.
        Scene scene = scene_of(kEverything);
        EffectSet effects = effect_set(required_effects(scene));
        scene.sky.kind = SkyKind::kChecker;
        scene.disc->look.texture = TextureKind::kGrid;
        for (const Effect effect : effect_set(required_effects(scene)).list()) effects.insert(effect);
        const std::vector<int> driver = driver_offsets(scene, effects, members);
        for (std::size_t i = 0; i < members.size(); ++i) {
            CAPTURE(members[i]);
            // The last of the block, which no shader has together with those of plane orbits about one centre: see the next test.
            if (members[i].starts_with("frame.spin_") || members[i] == "frame.throat")
                CHECK(i + 7 >= members.size());
            else
                CHECK(driver[i] == static_cast<int>(16 * i));
        }
    });
}

TEST_CASE("uniform block: without an effect its members are gone and the others close up, for every combination") {
    const auto members = frame_members();
    on_every_context([&](GpuSession&) {
        for (unsigned bits = 0; bits <= kEverything;
             bits += by_depth(67u, 11u, 1u)) {  // odd steps: every bit in both states
            CAPTURE(bits);
            Scene scene = scene_of(bits);
            if (bits % 7 == 0) scene.spacetime.metric = "kerr";
            if (bits % 7 == 1) {  // without what is not there in a wormhole
                scene.spacetime.metric = "ellis";
                scene.disc.reset(), scene.sphere.reset();
                if (scene.ball) scene.ball->motion = BallMotion::kStill;
            }
            std::vector<int> expected(members.size(), -1);
            int next = 0;
            const EffectSet effects = effect_set(required_effects(scene));
            for (const int member : block_members(effects)) expected[static_cast<std::size_t>(member)] = 16 * next++;
            CHECK(driver_offsets(scene, effects, members) == expected);
        }
    });
}

}  // namespace
