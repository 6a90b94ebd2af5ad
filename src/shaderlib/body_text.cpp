#include "shaderlib/body_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "plan/body_kind.h"
#include "plan/moving.h"
#include "scene/bodies.h"
#include "scene/named_surface.h"
#include "shaderlib/glow_text.h"
#include "shaderlib/march_statements.h"
#include "shaderlib/medium_text.h"
#include "shaderlib/pattern_text.h"
#include "shaderlib/shader_source.h"

namespace nullscope {
namespace {

// How a body's shape is known to the shader.
struct ShapeText {
    std::string name;  // of its functions: NAME_value, NAME_room, NAME_normal, NAME_middle, NAME_size
    std::string file;  // that defines them
    std::string formula{};
    bool moves = false, marched = true, round = false, turns = false;
    auto operator<=>(const ShapeText&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

struct ShapeOf {
    ShapeText operator()(const SphereSpec& s) const {
        if (s.amplitude > 0.0) return {"pulse", "object/pulse.glsl", "", true};
        return {"sphere",          mino ? "object/still_sphere.glsl" : "planar/sphere.glsl", "", false, mino, true,
                s.spin_rate != 0.0};
    }
    ShapeText operator()(const BallSpec& b) const {
        if (b.moves()) return {"moving_ball", "object/moving_ball.glsl", "", true, true, true};
        return {"ball", "object/ball.glsl", "", false, true, true};
    }
    ShapeText operator()(const SurfaceSpec& s) const {
        return {"surface", "object/surface.glsl", surface_shape(s), surface_moves(s)};
    }
    template <class Shape>
    ShapeText operator()(const Shape&) const {  // of a kind that has one file
        return {std::string(kind), fmt::format("object/{}.glsl", kind)};
    }
    std::string_view kind;
    bool mino;
};

// Bodies that share all their text.
struct Group {
    ShapeText shape;
    bool far;
    TextureKind texture;
    BodyMapping mapping;
    std::string formula;
    int image;
    bool glows;
    std::string name{};            // of its light
    std::size_t from = 0, to = 0;  // in the shader's order
    bool is_list() const { return to - from > 1; }
    auto key() const { return std::tie(shape.marched, shape, far, texture, mapping, formula, image, glows); }
};

Group group_of(const Body& body, const std::vector<ImageSource>& images, bool mino) {
    const Material& material = body.material;
    const bool image = material.texture == TextureKind::kImage;
    return {std::visit(ShapeOf{kind_of(body).key, mino}, body.shape),
            body.far,
            material.texture,
            material.mapping,
            material.texture == TextureKind::kFormula ? material.formula : "",
            image ? static_cast<int>(std::find(images.begin(), images.end(), material.source()) - images.begin()) : -1,
            material.temperature_K.has_value()};
}

// In the shader's order.
std::vector<Group> groups_of(const Scene& scene, bool mino) {
    const auto images = body_images(scene);
    std::vector<Group> groups;
    std::size_t next = 0;
    for (const std::size_t i : shader_bodies(scene)) {
        Group one = group_of(scene.bodies[i], images, mino);
        if (groups.empty() || groups.back().key() != one.key()) {
            one.from = next;
            groups.push_back(std::move(one));
        }
        groups.back().to = ++next;
    }
    std::vector<std::string> formulas;  // each is a text of its own
    for (Group& group : groups) {
        if (!group.shape.formula.empty()) {
            const auto known = std::find(formulas.begin(), formulas.end(), group.shape.formula);
            if (const auto number = known - formulas.begin(); number > 0)
                group.shape.name += fmt::format("_{}", number + 1);
            if (known == formulas.end()) formulas.push_back(group.shape.formula);
        }
        const auto same = std::count_if(groups.data(), &group,
                                        [&](const Group& other) { return other.shape.name == group.shape.name; });
        group.name = same == 0 ? group.shape.name : fmt::format("{}_group_{}", group.shape.name, same + 1);
    }
    return groups;
}

// The template of shaders/object/surface.glsl for each formula.
std::string surfaces_text(const std::vector<Group>& groups) {
    std::string text;
    const ShapeText* before = nullptr;
    for (const Group& group : groups) {
        const ShapeText& shape = group.shape;
        if (shape.formula.empty() || (before != nullptr && *before == shape)) continue;
        before = &shape;
        std::string one = (shape.moves ? "#define BODY_MOVES\n" : "") + std::string(shader_file(shape.file));
        one = replaced(std::move(one), "BODY_STATEMENTS\n",
                       statements(shape.formula, {"x", "y", "z", "t"}, "    float value = 1.0;\n"));
        text += replaced(std::move(one), "BODY", shape.name);
    }
    return text;
}

// What defines the functions of their shapes.
std::string includes_of(const std::vector<Group>& groups) {
    std::string text;
    for (const Group& group : groups)
        text += include_line(group.shape.formula.empty() ? group.shape.file : "generated/surfaces");
    return text;
}

std::string light_text(const Group& group, const Material& material) {
    constexpr const char* kMappings[] = {"MAPPING_EQUIRECTANGULAR", "MAPPING_BAND", "MAPPING_CAPS", "MAPPING_CUBE"};
    const char* mapping =
        group.shape.name == "cylinder" ? "MAPPING_PLANE" : kMappings[static_cast<int>(material.mapping)];
    std::string text = pattern_text(group.name, material, mapping, true, group.image) +
                       std::string(shader_file("object/body_light.glsl"));
    if (group.shape.turns)
        text = include_line("object/sphere_turn.glsl") +
               replaced(std::move(text), "objects[5 * i + 1]", "sphere_map(objects[5 * i + 1], place)");
    text = replaced(std::move(text), "KIND", group.shape.name);
    return replaced(std::move(text), "BODY", group.name);
}

bool is_ball(const Group& group) { return group.shape.name == "ball" || group.shape.name == "moving_ball"; }

// Whether a body's value is another thing than its distance.
bool has_distance(const Group& group) { return !group.shape.formula.empty(); }

// Through a wormhole: a body's value on its own side; on the other, from where the way to it leads through the throat, that of the throat
// and the way to there.
std::string by_side(const Group& group) {
    const char* off = group.far ? "place.side >= 0.0" : "place.side <= 0.0";
    const auto function = [&](std::string_view name, std::string_view beyond, const char* here) {
        return fmt::format(
            "float {0}_{1}_by_side(int i, RayPlace place) {{\n    bool off = {2};\n    float way = off ? place.r : "
            "0.0;\n"
            "    {3}place.at = vec3(0.0);\n    return {4}_{5}(i, place) + way;\n}}\n",
            group.name, name, off, here, group.shape.name, beyond);
    };
    const std::string room = fmt::format("if (!off) return {}_room(i, place);\n    ", group.shape.name);
    std::string text = function("value", "value", "if (off) ");
    if (has_distance(group)) {
        text += function("distance", "distance", "if (off) ");
        text += fmt::format("float {}_steepness_by_side(int i, RayPlace place) {{ return {}_steepness(i, place); }}\n",
                            group.name, group.shape.name);
    }
    return text + function("room", has_distance(group) ? "room" : "value", room.c_str());
}

// A statement for body i of each of a group, or of those in a set too: tested at the end, as software drivers run all of a loop once more.
std::string for_each(const Group& group, const std::string& statement, const char* set = nullptr) {
    if (!group.is_list()) return replaced(statement, "(i,", fmt::format("({},", group.from));
    if (set == nullptr)
        return fmt::format("    for (int i = {}; i < {}; ++i) {{\n{}    }}\n", group.from, group.to, statement);
    return fmt::format(
        "    {{\n    int i = bit_from({0}, {2});\n    bool more = i < {1};\n    do {{\n    i = min(i, {1} - 1);\n    "
        "if (more) {{\n{3}    "
        "}}\n    i = bit_from(i + 1, {2});\n    more = i < {1};\n    }} while (more);\n    }}\n",
        group.from, group.to, set, statement);
}

// "1 + i" where a statement is for one body.
std::string object_statement(const Group& group, const std::string& value) {
    const bool one = group.to - group.from == 1;
    return fmt::format("    if ({0} < value) {{\n        value = {0};\n        object = {1};\n    }}\n", value,
                       one ? fmt::format("{}", kFirstBody + group.from) : fmt::format("{} + i", kFirstBody));
}

// The statements of march_list: those whose room may be shorter than the way by a bound of it, and of these those whose is.
struct ListTexts {
    std::string close{}, near{};
};

void add_to_lists(ListTexts& lists, const Group& group, const std::string& room, const std::string& least) {
    if (!group.is_list()) return;
    const bool bound = is_ball(group);
    if (bound) lists.close += for_each(group, list_statement(least, "bodies_close"), "bodies_shown");
    lists.near += for_each(group, list_statement(room, "bodies_near"), bound ? "bodies_close" : "bodies_shown");
}

// Are all that are marched to round, and of one size?
bool round_alike(const std::vector<Group>& groups, const Scene& scene) {
    const std::vector<std::size_t> order = shader_bodies(scene);
    std::set<double> sizes;
    for (const Group& group : groups) {
        if (!group.shape.marched) continue;
        if (!group.shape.round) return false;
        for (std::size_t k = group.from; k < group.to; ++k) {
            const Body& body = scene.bodies[order[k]];
            sizes.insert(kind_of(body).extent(body).thinnest);
        }
    }
    return sizes.size() == 1;
}

constexpr int kMostSteps = 512;  // of a march: what many bodies ask for is bounded

std::string march_text(const std::vector<Group>& groups, const Scene& scene, const EffectSet& effects) {
    const bool sides = effects.contains(Effect::kSides), mino = light_path_kind(effects) == LightPathKind::kMino;
    const bool lists = !sides && std::ranges::any_of(groups, &Group::is_list);
    const char* near = lists ? "bodies_near" : nullptr;
    std::string ask, nearest, object, clear, helpers = includes_of(groups);
    ListTexts list;
    if (has_tiles(effects) || lists) helpers += include_line("core/bits.glsl");
    if (lists) helpers += include_line("object/lists.glsl");
    std::size_t marched = 0, alone = 0;
    bool skims = false;  // there is a body whose room is a way along the ray, not a distance
    for (const Group& group : groups) {
        if (!group.shape.marched) {
            helpers += "float sphere_away(int i, RayPlace place) { return place.r - body_form(i).x; }\n";
            clear += for_each(group, clear_statement("sphere_away(i, place)"));
            continue;
        }
        marched += group.to - group.from;
        alone = group.shape.name == "ball" ? group.from : std::size_t(-1);
        skims = skims || group.shape.name == "cylinder" || group.shape.name == "sphere";
        if (sides) helpers += by_side(group);
        const std::string name = sides ? group.name : group.shape.name, suffix = sides ? "_by_side" : "";
        const auto here = [&](const char* what) { return fmt::format("{}_{}{}(i, place)", name, what, suffix); };
        const std::string far = here(has_distance(group) ? "distance" : "value");
        ask += for_each(group,
                        fmt::format("    value = min(value, {});\n    room = min(room, {});\n", here("value"),
                                    here(!sides && is_ball(group) ? "stride" : "room")),
                        near);
        nearest +=
            for_each(group,
                     fmt::format("    next = {0};\n    if (abs(next) < abs(nearest.x)) nearest = vec2(next, {1});\n",
                                 far, has_distance(group) ? here("steepness") : "1.0"),
                     near);
        add_to_lists(list, group, here("room"), here("least"));
        const char* away = has_distance(group)                 ? "clear"
                           : group.shape.name == "moving_ball" ? "away"
                           : group.shape.moves                 ? "room"
                                                               : "value";
        clear += for_each(group, clear_statement(here(away)), near);
        object += for_each(group, object_statement(group, far), lists ? "bodies_shown" : nullptr);
    }
    if (marched == 0) return "";
    const bool ball_alone = marched == 1 && alone != std::size_t(-1);
    const std::string stop =
        mino ? ""
             : (ball_alone ? include_line("planar/ball_beside.glsl") : "") +
                   "float march_stop(Trace trace, vec3 tangent, float phi) { return " +
                   (ball_alone ? fmt::format("ball_beside({}, trace, tangent) ? 1.0e-9 : ", alone) : "") +
                   "max(phi, 1.0e-9); }\n";
    // Steps of a surface are equal: those that cross its bounding sphere, twice for bent ways. Past many bodies a ray takes some for each.
    int across = 0;
    for (const Body& body : scene.bodies)
        if (const auto* surface = std::get_if<SurfaceSpec>(&body.shape)) across = std::max(across, 2 * surface->steps);
    const int steps = std::min((sides ? 256 : 128) + 8 * (static_cast<int>(marched) - 1), kMostSteps) + across;
    // Between two samples no body is met, and of its distance a fifth is left, unless the step is the shortest: on a step of 0.8 of the room
    // it changes by no more. But it may cover a part of the pixel.
    const std::string graze = !skims       ? "length < max(1.001 * frame.march.y, 4.0 * pixel)"
                              : across > 0 ? "true"
                                           : "length < 1.001 * frame.march.y || value < 5.0 * pixel";
    // A surface may be thinner than the first probe is long.
    return fmt::format("#define MARCH_MOST_STEPS {}\n#define MARCH_PROBES {}\n", steps, across > 0 ? 3 : 1) + helpers +
           stop + "vec2 march_ask(RayPlace place) {\n    float value = 1.0e30;\n    float room = 1.0e30;\n" + ask +
           "    return vec2(value, room);\n}\n" +
           (across > 0 ? "vec2 march_nearest(RayPlace place, float value) {\n    vec2 nearest = vec2(1.0e30, 1.0);\n"
                         "    float next = 0.0;\n" +
                             nearest + "    return nearest;\n}\n"
                       : "vec2 march_nearest(RayPlace place, float value) { return vec2(value, 1.0); }\n") +
           (lists ? "void march_list(RayPlace place, float way) {\n    uvec2 bodies_close = uvec2(0u, 0u);\n" +
                        list.close + "    bodies_near = uvec2(0u, 0u);\n" + list.near + "}\n"
                  : "") +
           (groups.front().shape.marched ? "" : "#define TILES_HAVE_SPHERE\n") +
           (has_tiles(effects) ? "vec2 march_clear(RayPlace place, float near, inout uvec2 bodies) {\n    vec2 away "
                                 "= vec2(1.0e30);\n    float next = 0.0;\n" +
                                     clear + "    return away;\n}\n"
                               : "") +
           "bool march_grazes(float length, float value, float pixel) { return " + graze +
           "; }\n"
           "int march_object(RayPlace place) {\n    float value = 1.0e30;\n    int object = 0;\n" +
           object + "    return object;\n}\nfloat march_round(float thinnest) { return " +
           (round_alike(groups, scene) ? "thinnest" : "1.0e30") + "; }\n";
}

std::string hit_text(const std::vector<Group>& groups) {
    // The one still sphere is first.
    const bool sphere = !groups.front().shape.marched, march = groups.back().shape.marched;
    const std::string text =
        (sphere ? include_line(groups.front().shape.file) : "") + (march ? include_line("planar/march.glsl") : "") +
        "SolidHit solid_hit(Trace trace, float blur) {\n    vec3 tangent = place_tangent(trace);\n    SolidHit hit = ";
    const std::string placed = "    if (hit.object != 0) hit.place = place_seen(trace, tangent, hit.phi);\n";
    const char* end = "    return hit;\n}\n";
    if (sphere && !march) return text + "sphere_hit(0, trace, tangent, blur);\n" + placed + end;
    if (!sphere) return text + "march_hit(trace, tangent, march_stop(trace, tangent, trace.phi_end), blur);\n" + end;
    // What lies before the sphere; a body's blurred edge before it hides the sphere's own.
    return text +
           "sphere_hit(0, trace, tangent, blur);\n"
           "    bool whole = hit.covered >= 1.0;\n"
           "    SolidHit other = march_hit(trace, tangent, march_stop(trace, tangent, whole ? hit.phi : "
           "trace.phi_end), whole ? "
           "0.0 : blur);\n" +
           placed + "    if (other.object != 0 && (hit.object == 0 || other.phi < hit.phi)) hit = other;\n" + end;
}

// Of those that have a temperature.
GlowText glows_text(const std::vector<Group>& groups, const Scene& scene) {
    std::vector<GlowGroup> glowing;
    for (const Group& g : groups)
        if (g.glows)
            glowing.push_back({g.name, g.shape.name, g.shape.moves || g.shape.turns,
                               g.shape.name == "sphere" && has_caps(scene), g.from, g.to});
    GlowText text = glow_text(scene, glowing);
    if (!glowing.empty()) text.shift = include_line("object/solid_hit.glsl") + includes_of(groups) + text.shift;
    return text;
}

std::string lights_text(const std::vector<Group>& groups, const Scene& scene, const std::string& glow) {
    const std::vector<std::size_t> order = shader_bodies(scene);
    std::string text = includes_of(groups), choice;
    std::set<int> images;  // a file may be on bodies of several groups
    for (const Group& group : groups) {
        if (group.texture == TextureKind::kImage && images.insert(group.image).second)
            text += fmt::format("uniform sampler2D body_image_{};\n", group.image);
        text += light_text(group, scene.bodies[order[group.from]].material);
        choice += fmt::format("    if (i < {}) return {}_{}(i, trace, hit.place);\n", group.to, group.name,
                              group.glows ? "glow" : "light");
    }
    return text + glow + "vec3 solid_light(Trace trace, SolidHit hit) {\n    int i = hit.object - BODIES_FROM;\n" +
           choice + "    return vec3(0.0);\n}\n";
}

std::string objects_text(const std::vector<Group>& groups, const Scene& scene) {
    const std::size_t bodies = groups.empty() ? 0 : groups.back().to, spots = scene.disc ? scene.spots.size() : 0;
    if (bodies + spots == 0) return "";
    std::string text = fmt::format("#define OBJECT_VECTORS {}\n#define BODIES_FROM {}\n", caps_to(scene), kFirstBody);
    text += turn_defines(scene);
    if (spots > 0) text += fmt::format("#define SPOT_FROM {}\n#define SPOT_COUNT {}\n", 5 * bodies, spots);
    for (const Group& group : groups)
        if (group.shape.name == "moving_ball")
            return text +
                   fmt::format("#define BALL_PATH_FIRST {}\n#define BALL_PATH_AHEAD {}\n", group.from, kBallPathAhead);
    return text;
}

}  // namespace

std::vector<ImageSource> body_images(const Scene& scene) {
    std::vector<ImageSource> files;
    for (const Body& body : scene.bodies)
        if (body.material.texture == TextureKind::kImage &&
            std::find(files.begin(), files.end(), body.material.source()) == files.end())
            files.push_back(body.material.source());
    return files;
}

std::vector<std::size_t> shader_bodies(const Scene& scene) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const auto* sphere = std::get_if<SphereSpec>(&scene.bodies[i].shape);
        if (sphere == nullptr || sphere->amplitude > 0.0 || &scene.bodies[i] == seen_sphere(scene)) order.push_back(i);
    }
    const auto images = body_images(scene);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return group_of(scene.bodies[a], images, false).key() < group_of(scene.bodies[b], images, false).key();
    });
    return order;
}

BodyText body_text(const Scene& scene, const EffectSet& effects) {
    const bool mino = light_path_kind(effects) == LightPathKind::kMino;
    const auto groups = groups_of(scene, mino);
    BodyText text;
    text.materials = materials_of(scene);
    text.medium = medium_text(scene), text.law = medium_law_text(scene);
    text.law_by_place = scene.medium && scene.medium->by_place();
    text.objects = objects_text(groups, scene);
    if (groups.empty()) return text;
    text.surfaces = surfaces_text(groups), text.march = march_text(groups, scene, effects);
    if (!mino) text.hit = hit_text(groups);
    const GlowText glow = glows_text(groups, scene);
    text.shift = glow.shift, text.light = lights_text(groups, scene, glow.light);
    return text;
}

}  // namespace nullscope
