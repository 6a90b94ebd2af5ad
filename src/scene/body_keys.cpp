#include "scene/body_keys.h"

#include <array>
#include <vector>

namespace nullscope {
namespace {

constexpr KeyRange kAnyAngle{-3600.0, 3600.0, false, false};
constexpr KeyRange kLength{0.0, 1e6, true, false};
constexpr KeyRange kPlace{-1e6, 1e6, false, false};
constexpr KeyRange kBrightness{0.0, 1e6, false, false};
constexpr KeyRange kColour{0.0, 1000.0, false, false};
constexpr KeyRange kSteps{16.0, 256.0, false, false};
constexpr KeyRange kCount{1.0, 1000.0, false, false};
constexpr KeyRange kBand{0.0, 90.0, true, false};
constexpr KeyRange kFraction{0.0, 1.0, false, false};
constexpr KeyRange kSwing{0.0, 0.5, false, false};
constexpr KeyRange kNone{};

// The keys that every body has. Body: the member of Scene.
template <auto Body>
std::array<SceneKey, 10> look_keys(std::string_view section) {
    return {{
        {section, "texture", KeyType::kChoice, "", "plain", kNone, "plain checker grid stripes noise formula image",
         "What covers it: one colour, a pattern of two colours, or an image.",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.texture = static_cast<TextureKind>(v.choice); }},
        {section, "image", KeyType::kImage, "", "", kNone, "", "The image; needs texture = \"image\".",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.image = v.path; }},
        {section, "formula", KeyType::kFormula, "", "", kNone, "u v x y z",
         "How much of the first colour, from 0 to 1; needs texture = \"formula\".",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.formula = v.text; }},
        {section, "colour", KeyType::kColour, "", "[1, 0.72, 0.42]", kColour, "",
         "First colour, linear red, green and blue; images are multiplied by it (by default by 1).",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.colour = v.vector; }},
        {section, "second_colour", KeyType::kColour, "", "[0.12, 0.05, 0.03]", kColour, "",
         "Second colour: of the other cells, of the ground between lines, of where the formula is 0.",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.second_colour = v.vector; }},
        {section, "columns", KeyType::kWhole, "", "24", kCount, "",
         "Cells of the pattern over u; of noise, grains over the radius.",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.columns = v.width; }},
        {section, "rows", KeyType::kWhole, "", "12", kCount, "", "Cells of the pattern over v; stripes are rows.",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.rows = v.width; }},
        {section, "rotation", KeyType::kNumber, "deg", "0", kAnyAngle, "", "Turn of the texture about the polar axis.",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.rotation = v.number; }},
        {section, "limb", KeyType::kNumber, "", "0", kFraction, "",
         "Darkening of what is seen at a slant: light times 1 - limb (1 - cosine), in flat coordinates.",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.limb = v.number; }},
        {section, "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Factor on its light.",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.brightness = v.number; }},
    }};
}

// Of bodies that are covered by direction from their middle.
template <auto Body>
std::array<SceneKey, 2> mapping_keys(std::string_view section) {
    return {{
        {section, "mapping", KeyType::kChoice, "", "equirectangular", kNone, "equirectangular band caps cube",
         "How the texture's square covers directions.",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.mapping = static_cast<BodyMapping>(v.choice); }},
        {section, "band_latitude", KeyType::kNumber, "deg", "60", kBand, "",
         "Latitude where the band ends and the second colour begins; needs mapping = \"band\".",
         [](Scene& s, const KeyValue& v) { (s.*Body)->look.band_latitude = v.number; }},
    }};
}

template <auto Part>
BodyLook& look_of(Scene& scene) {
    if constexpr (requires { (scene.*Part).look; })
        return (scene.*Part).look;
    else
        return (scene.*Part)->look;
}

// Of what is not solid and may have a texture, with its two colours.
template <auto Part>
std::array<SceneKey, 5> coat_keys(std::string_view section, std::string_view first, std::string_view second) {
    return {{
        {section, "formula", KeyType::kFormula, "", "", kNone, "u v x y z",
         "How much of the first colour, from 0 to 1; needs \"formula\".",
         [](Scene& s, const KeyValue& v) { look_of<Part>(s).formula = v.text; }},
        {section, "colour", KeyType::kColour, "", first, kColour, "",
         "First colour of a texture that is no image, linear red, green and blue.",
         [](Scene& s, const KeyValue& v) { look_of<Part>(s).colour = v.vector; }},
        {section, "second_colour", KeyType::kColour, "", second, kColour, "",
         "Second colour: of the other cells, of the ground between lines, of where the formula is 0.",
         [](Scene& s, const KeyValue& v) { look_of<Part>(s).second_colour = v.vector; }},
        {section, "columns", KeyType::kWhole, "", "24", kCount, "",
         "Cells of the pattern round about; of noise, grains over the radius.",
         [](Scene& s, const KeyValue& v) { look_of<Part>(s).columns = v.width; }},
        {section, "rows", KeyType::kWhole, "", "12", kCount, "",
         "Cells of the pattern from top to bottom, or rim to rim; stripes are rows.",
         [](Scene& s, const KeyValue& v) { look_of<Part>(s).rows = v.width; }},
    }};
}

// Of bodies that may stand on either side of a wormhole's throat.
template <auto Body>
SceneKey side_key(std::string_view section) {
    return {section,
            "side",
            KeyType::kChoice,
            "",
            "near",
            kNone,
            "near far",
            "Of a wormhole's throat: near is l > 0, far is l < 0.",
            [](Scene& s, const KeyValue& v) { (s.*Body)->far = v.choice == 1; }};
}

const SceneKey kDiscTexture[] = {
    {"disc", "texture", KeyType::kChoice, "", "image", kNone, "plain checker grid stripes noise formula image",
     "What covers it: an image, one colour, or a pattern of two colours in azimuth and radius.",
     [](Scene& s, const KeyValue& v) { s.disc->look.texture = static_cast<TextureKind>(v.choice); }},
};

const SceneKey kForms[] = {
    {"sphere", "radius", KeyType::kNumber, "r_s", "3", kLength, "", "Radius, outside the horizon; below camera.r.",
     [](Scene& s, const KeyValue& v) { s.sphere->radius = v.number; }},
    {"sphere", "swing", KeyType::kNumber, "", "0", kSwing, "",
     "Pulsation: its radius is radius times 1 + swing sin(2 pi t/period).",
     [](Scene& s, const KeyValue& v) { s.sphere->swing = v.number; }},
    {"sphere", "period", KeyType::kNumber, "r_s/c", "40", kLength, "", "Of the pulsation; needs swing.",
     [](Scene& s, const KeyValue& v) { s.sphere->period = v.number; }},
    {"cylinder", "inner", KeyType::kNumber, "r_s", "3", kLength, "", "Inner radius; below outer.",
     [](Scene& s, const KeyValue& v) { s.cylinder->inner = v.number; }},
    {"cylinder", "outer", KeyType::kNumber, "r_s", "8", kLength, "", "Outer radius.",
     [](Scene& s, const KeyValue& v) { s.cylinder->outer = v.number; }},
    {"cylinder", "height", KeyType::kNumber, "r_s", "0.5", kLength, "",
     "Half of its thickness: it lies at |z| <= height.",
     [](Scene& s, const KeyValue& v) { s.cylinder->height = v.number; }},
    {"ball", "position", KeyType::kPoint, "r_s", "[-12, 0, 0]", kPlace, "", "Its middle: x, y, z.",
     [](Scene& s, const KeyValue& v) { s.ball->position = v.vector; }},
    {"ball", "radius", KeyType::kNumber, "r_s", "2", kLength, "",
     "Radius; neither the centre nor the camera lies within.",
     [](Scene& s, const KeyValue& v) { s.ball->radius = v.number; }},
    {"ball", "motion", KeyType::kChoice, "", "still", kNone, "still orbit geodesic path",
     "How its middle moves: on a circular geodesic through position, eastward; in free fall from there; along formulas "
     "of t.",
     [](Scene& s, const KeyValue& v) { s.ball->motion = static_cast<BallMotion>(v.choice); }},
    {"ball", "velocity", KeyType::kVelocity, "c", "[0, 0, 0]", kNone, "",
     "At position and t = 0, along (e_r, e_theta, e_phi) of one at rest there; needs motion = \"geodesic\".",
     [](Scene& s, const KeyValue& v) { s.ball->velocity = v.vector; }},
    {"ball", "x", KeyType::kFormula, "", "", kNone, "t", "Of its middle at time t; needs motion = \"path\".",
     [](Scene& s, const KeyValue& v) { s.ball->x = v.text; }},
    {"ball", "y", KeyType::kFormula, "", "", kNone, "t", "As x.",
     [](Scene& s, const KeyValue& v) { s.ball->y = v.text; }},
    {"ball", "z", KeyType::kFormula, "", "", kNone, "t", "As x.",
     [](Scene& s, const KeyValue& v) { s.ball->z = v.text; }},
    {"surface", "kind", KeyType::kChoice, "", "formula", kNone,
     "formula torus ellipsoid cube octahedron heart gyroid clebsch",
     "What solid: the formula's, or one that is known by name.",
     [](Scene& s, const KeyValue& v) { s.surface->kind = static_cast<SurfaceKind>(v.choice); }},
    {"surface", "size", KeyType::kNumber, "r_s", "6", kLength, "",
     "The length that is 1 in a named surface; needs a kind with a name.",
     [](Scene& s, const KeyValue& v) { s.surface->size = v.number; }},
    {"surface", "shape", KeyType::kFormula, "", "(length(x, y) - 6)^2 + z^2 - 2", kNone, "x y z t",
     "f(x, y, z, t), below 0 inside of the solid; outside of it at the camera; t is time. Needs kind = \"formula\".",
     [](Scene& s, const KeyValue& v) { s.surface->shape = v.text; }},
    {"surface", "bound", KeyType::kNumber, "r_s", "10", kLength, "",
     "Radius about the centre beyond which there is nothing of it.",
     [](Scene& s, const KeyValue& v) { s.surface->bound = v.number; }},
    {"surface", "steps", KeyType::kWhole, "", "64", kSteps, "",
     "Steps across the bounding sphere; what is thinner than one may be missed.",
     [](Scene& s, const KeyValue& v) { s.surface->steps = v.width; }},
};

template <class Rows>
void append(std::vector<SceneKey>& keys, const Rows& rows) {
    keys.insert(keys.end(), std::begin(rows), std::end(rows));
}

}  // namespace

void append_body_keys(std::vector<SceneKey>& keys) {
    append(keys, coat_keys<&Scene::sky>("sky", "[0.5, 0.75, 1]", "[0.01, 0.015, 0.03]"));
    append(keys, kDiscTexture);
    append(keys, coat_keys<&Scene::disc>("disc", "[1, 0.72, 0.42]", "[0.12, 0.05, 0.03]"));
    append(keys, kForms);
    append(keys, std::array{side_key<&Scene::cylinder>("cylinder"), side_key<&Scene::ball>("ball"),
                            side_key<&Scene::surface>("surface")});
    append(keys, look_keys<&Scene::sphere>("sphere"));
    append(keys, mapping_keys<&Scene::sphere>("sphere"));
    append(keys, look_keys<&Scene::cylinder>("cylinder"));
    append(keys, look_keys<&Scene::ball>("ball"));
    append(keys, mapping_keys<&Scene::ball>("ball"));
    append(keys, look_keys<&Scene::surface>("surface"));
    append(keys, mapping_keys<&Scene::surface>("surface"));
}

}  // namespace nullscope
