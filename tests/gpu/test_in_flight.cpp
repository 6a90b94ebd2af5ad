// Pictures whose bytes are read while the next one is drawn are the pictures that are read at once.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "scenefile/scene_file.h"
#include "support/gpu_session.h"

namespace {

using namespace nullscope;

Scene thumbnail_of(const std::string& name) {
    Scene scene = *load_scene(name);
    scene.camera.width = 96, scene.camera.height = 54;
    return scene;
}

TEST_CASE("in flight: a picture is as it was when it was drawn, whatever was drawn since") {
    for (const char* kind : test::kContextKinds) {
        auto session = test::open_gpu(kind);
        if (!session) continue;
        CAPTURE(kind);
        Renderer& renderer = *session->renderer;
        std::vector<Image<unsigned char>> at_once;
        std::vector<PictureRead> coming;
        for (const char* name : {"first-light", "kerr", "flat"}) {
            REQUIRE(renderer.prepare(thumbnail_of(name)));
            at_once.push_back(renderer.picture8());
            coming.push_back(renderer.begin_picture8());
        }
        for (std::size_t i = 0; i < coming.size(); ++i) {
            CHECK(coming[i].width == 96);
            CHECK(coming[i].height == 54);
            CHECK(coming[i].take().data == at_once[i].data);
        }
        CHECK(at_once[0].data != at_once[1].data);
    }
}

}  // namespace
