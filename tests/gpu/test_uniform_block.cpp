// The driver's layout of the uniform block is that of the C++ struct.
#include <glad/gl.h>

#include "scene/bodies.h"
#include "scenefile/scene_file.h"
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
    scene.picture.samples = has(4) ? 2 : 1;
    if (has(2) && has(3) && !has(0)) scene.disc->material.texture = TextureKind::kGrid;  // in flat space both again
    if (has(3) && has(8) && !has(0)) scene.sky.kind = SkyKind::kChecker;
    if (has(4)) add_body<SphereSpec>(scene).material.texture = TextureKind::kChecker;
    if (has(5)) add_body<CylinderSpec>(scene).material.texture = TextureKind::kNoise;
    if (has(6)) add_body<BallSpec>(scene).material.texture = TextureKind::kImage;
    if (has(7)) add<SurfaceSpec>(scene);
    if (has(5) && has(6)) scene.bodies.back().material.temperature_K = 5000.0;
    if (has(2) && has(8)) scene.disc->flow = DiscFlowKind::kKepler, scene.spots.emplace_back();
    if (has(6) && has(8)) first_shape<BallSpec>(scene)->motion = BallMotion::kOrbit;
    return scene;
}
constexpr unsigned kEverything = 511;

// Byte offsets of the members of a uniform block, in the order of `members`; -1 for one that the compiler dropped.
std::vector<int> uniform_offsets(const gl::Program& program, const std::vector<std::string>& members) {
    std::vector<int> offsets(members.size(), -1);
    for (std::size_t i = 0; i < members.size(); ++i) {
        const char* name = members[i].c_str();
        GLuint index = GL_INVALID_INDEX;
        glGetUniformIndices(program.id(), 1, &name, &index);
        if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_OFFSET, &offsets[i]);
    }
    return offsets;
}

std::vector<int> driver_offsets(const Scene& scene, const EffectSet& effects, const std::vector<std::string>& members) {
    const ShaderSource source = shader_source(Stage::kPicture, effects, Output::kDisplay, {}, scene.spacetime.metric,
                                              body_text(scene, effects));
    return uniform_offsets(gl::make_program(source.vertex, source.fragment), members);
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
        scene.disc->material.texture = TextureKind::kGrid;
        for (const Effect effect : effect_set(required_effects(scene)).list()) effects.insert(effect);
        for (const Effect one :
             {Effect::kRingRates, Effect::kDiscGas, Effect::kZoom, projection_effect(Projection::kFisheye),
              Effect::kWarp, Effect::kDither, Effect::kPolarisation, Effect::kPolariser})
            effects.insert(one);
        const std::vector<int> driver = driver_offsets(scene, effects, members);
        for (std::size_t i = 0; i < members.size(); ++i) {
            CAPTURE(members[i]);
            // The last of the block, which no shader has together with those of plane orbits about one centre: see the next test.
            if (members[i].starts_with("frame.spin_") || members[i].starts_with("frame.ring_") ||
                members[i] == "frame.throat" || members[i].starts_with("frame.medium_"))
                CHECK(i + 31 >= members.size());
            else
                CHECK(driver[i] == static_cast<int>(16 * i));
        }
    });
}

TEST_CASE("uniform block: without an effect its members are gone and the others close up, for every combination" *
          test::costly()) {
    const auto members = frame_members();
    on_one_context([&](GpuSession&) {
        for (unsigned bits = 0; bits <= kEverything;
             bits += by_depth(67u, 11u, 1u)) {  // odd steps: every bit in both states
            CAPTURE(bits);
            Scene scene = scene_of(bits);
            if (bits % 7 == 0) scene.spacetime.metric = "kerr";
            if (bits % 7 == 1) {  // without what is not there in a wormhole
                scene.spacetime.metric = "ellis";
                scene.disc.reset(), remove_bodies<SphereSpec>(scene);
                if (first_shape<BallSpec>(scene)) first_shape<BallSpec>(scene)->motion = BallMotion::kStill;
            }
            if (bits % 7 >= 2 && bits % 7 <= 4) scene.medium.emplace().kind = static_cast<MediumKind>(bits % 7 - 2);
            std::vector<int> expected(members.size(), -1);
            int next = 0;
            const EffectSet effects = effect_set(required_effects(scene));
            for (const int member : block_members(effects)) expected[static_cast<std::size_t>(member)] = 16 * next++;
            CHECK(driver_offsets(scene, effects, members) == expected);
        }
    });
}

TEST_CASE("uniform block: handed on by the vertex shader it makes the same picture, bit by bit" * test::costly()) {
    on_one_context([&](GpuSession&) {
        for (const char* name : {"sky-only", "first-light", "earth", "kerr"})
            for (const Tiles tiles : {Tiles::kNone, Tiles::kTraced}) {
                CAPTURE(name);
                Scene scene = *load_scene(name);
                scene.picture.refine = tiles == Tiles::kNone;  // its pixels are drawn as points
                scene.camera.width = 163, scene.camera.height = 91;
                Image<float> pictures[2];
                for (const bool flat : {false, true}) {
                    Renderer renderer;
                    renderer.flatten_frame(flat);
                    renderer.limit_tiles(tiles);
                    REQUIRE(renderer.prepare(scene));
                    pictures[flat] = renderer.picture();
                }
                CHECK(pictures[0].data == pictures[1].data);
            }
    });
}

}  // namespace
