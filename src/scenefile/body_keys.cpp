#include "scenefile/body_keys.h"

#include <iterator>
#include <vector>

#include "plan/body_kind.h"

namespace nullscope {
namespace {

constexpr KeyRange kColour = closed(0.0, 1000.0);
constexpr KeyRange kCount = closed(1.0, 1000.0);

// Whose material it is, and the words of its messages.
template <class Shape>
struct OfBody {
    static auto& material(auto& s) { return last_of<Shape>(s).material; }
    static TextureKind texture(const Scene& s) { return material(s).texture; }
    static constexpr std::string_view kFormula = "texture = \"formula\"",
                                      kColumns = "texture = \"checker\", \"grid\" or \"noise\"",
                                      kRows = "texture = \"checker\", \"grid\" or \"stripes\"";
};
struct OfDisc : OfBody<void> {
    static auto& material(auto& s) { return s.disc->material; }
    static TextureKind texture(const Scene& s) { return s.disc->material.texture; }
    static bool coloured(const Scene& s) { return texture(s) != TextureKind::kImage; }
    static constexpr std::string_view kColour = "a texture that is no image", kTwoColours = "a texture of two colours";
};
struct OfSky {
    static auto& material(auto& s) { return s.sky.material; }
    static TextureKind texture(const Scene& s) { return sky_material(s.sky).texture; }
    static bool coloured(const Scene& s) { return is_procedural(s.sky.kind); }
    static constexpr std::string_view kFormula = "kind = \"formula\"",
                                      kColumns = "kind = \"checker\", \"grid\" or \"noise\"",
                                      kRows = "kind = \"checker\", \"grid\" or \"stripes\"",
                                      kColour = "kind = \"plain\" or a pattern", kTwoColours = "a kind of two colours";
};

template <class Of, TextureKind... kinds>
bool texture_is(const Scene& s) {
    return ((Of::texture(s) == kinds) || ...);
}

// A row of what is of a formula, or of a pattern's cells.
template <class Of>
SceneKey formula_key(std::string_view section, std::string_view help) {
    SceneKey key{section, "formula", KeyType::kFormula, "", "", kNoRange, "u v x y z", help};
    key.member = [](auto& s) { return &Of::material(s).formula; };
    key.meant = texture_is<Of, TextureKind::kFormula>, key.with = Of::kFormula, key.needed = true;
    return key;
}
template <class Of>
SceneKey columns_key(std::string_view section, std::string_view help) {
    SceneKey key{section, "columns", KeyType::kWhole, "", "24", kCount, "", help};
    key.member = [](auto& s) { return &Of::material(s).columns; };
    key.meant = texture_is<Of, TextureKind::kChecker, TextureKind::kGrid, TextureKind::kNoise>, key.with = Of::kColumns;
    return key;
}
template <class Of>
SceneKey rows_key(std::string_view section, std::string_view help) {
    SceneKey key{section, "rows", KeyType::kWhole, "", "12", kCount, "", help};
    key.member = [](auto& s) { return &Of::material(s).rows; };
    key.meant = texture_is<Of, TextureKind::kChecker, TextureKind::kGrid, TextureKind::kStripes>, key.with = Of::kRows;
    return key;
}

template <class Of, double Material::*kAngle>
SceneKey sun_key(std::string_view section, std::string_view name, KeyRange range, std::string_view help) {
    SceneKey key{section, name, KeyType::kNumber, "deg", "0", range, "", help};
    key.member = [](auto& s) { return &(Of::material(s).*kAngle); };
    key.meant = [](const Scene& s) { return Of::material(s).night < 1.0; }, key.with = "night below 1";
    return key;
}

// The keys that every body has.
template <class Shape>
std::vector<SceneKey> material_keys(std::string_view section) {
    using Of = OfBody<Shape>;
    return {
        {section, "name", KeyType::kText, "", "", kNoRange, "",
         "Name in ray data; by default the section, numbered from the second body of its kind on.",
         [](auto& s) { return &last_of<Shape>(s).name; }},
        {section, "texture", KeyType::kChoice, "", "plain", kNoRange, "plain checker grid stripes noise formula image",
         "Surface texture: one colour, a pattern of two colours, or an image.",
         [](auto& s) { return &Of::material(s).texture; }},
        {section, "image", KeyType::kFile, "", "", kNoRange, "", "The image; needs texture = \"image\".",
         [](auto& s) { return &Of::material(s).image; }, texture_is<Of, TextureKind::kImage>, "texture = \"image\"",
         true},
        {section, "image_layer", KeyType::kText, "", "", kNoRange, "",
         "Which picture of an EXR with several: its layer or part.",
         [](auto& s) { return &Of::material(s).image_layer; }, texture_is<Of, TextureKind::kImage>,
         "texture = \"image\""},
        formula_key<Of>(section, "Share of the first colour, from 0 to 1; needs texture = \"formula\"."),
        {section, "colour", KeyType::kColour, "", "[1, 0.72, 0.42]", kColour, "",
         "First colour, linear red, green and blue; images and what has a temperature are multiplied by it (by default "
         "by 1).",
         [](auto& s) { return &Of::material(s).colour; }},
        {section, "second_colour", KeyType::kColour, "", "[0.12, 0.05, 0.03]", kColour, "",
         "Second colour: the other cells, the background between lines, where the formula is 0.",
         [](auto& s) { return &Of::material(s).second_colour; }},
        columns_key<Of>(section, "Cells of the pattern along u; for noise, grains per radius."),
        rows_key<Of>(section, "Cells of the pattern along v; for stripes, their number."),
        {section, "rotation", KeyType::kNumber, "deg", "0", kAnyAngle, "",
         "Rotation of the texture about the polar axis.", [](auto& s) { return &Of::material(s).rotation; }},
        {section, "limb", KeyType::kNumber, "", "0", closed(0.0, 1.0), "",
         "Limb darkening: light times 1 - limb (1 - cosine), in flat coordinates.",
         [](auto& s) { return &Of::material(s).limb; }},
        {section, "brightness", KeyType::kNumber, "", "1", kBrightness, "", "Multiplies its light.",
         [](auto& s) { return &Of::material(s).brightness; }},
        {section, "night", KeyType::kNumber, "", "1", closed(0.0, 1.0), "",
         "Light of the night side over that of the subsolar point of a distant sun; Lambert's law in between. 1: "
         "self-luminous.",
         [](auto& s) { return &Of::material(s).night; }},
        {section, "temperature", KeyType::kNumber, "K", "", closed(1e3, 1e9), "",
         "If set, it shines as a black body of this temperature, of brightness 1 in its own frame, times colours; with "
         "texture = \"image\" the image shines, as light of this temperature. The redshift factor g acts on it: "
         "gravity, "
         "its motion and the camera's.",
         [](auto& s) { return &Of::material(s).temperature_K; }},
        sun_key<Of, &Material::sun_longitude>(section, "sun_longitude", kAnyAngle,
                                              "Longitude of that sun's direction; needs night below 1."),
        sun_key<Of, &Material::sun_latitude>(
            section, "sun_latitude", closed(-90.0, 90.0),
            "Latitude of that sun's direction, from the equatorial plane; needs night below 1."),
    };
}

// Of bodies that are covered by direction from their middle.
template <class Shape>
std::vector<SceneKey> mapping_keys(std::string_view section) {
    using Of = OfBody<Shape>;
    return {
        {section, "mapping", KeyType::kChoice, "", "equirectangular", kNoRange, "equirectangular band caps cube",
         "How the texture is mapped onto the sphere of directions.", [](auto& s) { return &Of::material(s).mapping; }},
        {section, "band_latitude", KeyType::kNumber, "deg", "60", KeyRange{0.0, 90.0, true, false}, "",
         "Latitude where the band ends and the second colour begins; needs mapping = \"band\".",
         [](auto& s) { return &Of::material(s).band_latitude; },
         [](const Scene& s) { return Of::material(s).mapping == BodyMapping::kBand; }, "mapping = \"band\""},
    };
}

// Of bodies that may stand on either side of a wormhole's throat.
template <class Shape>
SceneKey side_key(std::string_view section) {
    SceneKey key{section, "side", KeyType::kChoice, "", "near", kNoRange, "near far"};
    key.help = "Side of a wormhole's throat: near is l > 0, far is l < 0.";
    key.member = [](auto& s) { return &last_of<Shape>(s).far; };
    return key;
}

// Of what is not solid and may have a texture, with its two colours.
template <class Of>
std::vector<SceneKey> pattern_keys(std::string_view section, std::string_view first, std::string_view second) {
    return {
        formula_key<Of>(section, "Share of the first colour, from 0 to 1; needs \"formula\"."),
        {section, "colour", KeyType::kColour, "", first, kColour, "",
         "First colour of textures other than images, linear red, green and blue.",
         [](auto& s) { return &Of::material(s).colour; }, Of::coloured, Of::kColour},
        {section, "second_colour", KeyType::kColour, "", second, kColour, "",
         "Second colour: the other cells, the background between lines, where the formula is 0.",
         [](auto& s) { return &Of::material(s).second_colour; },
         [](const Scene& s) { return Of::coloured(s) && !texture_is<Of, TextureKind::kPlain, TextureKind::kGas>(s); },
         Of::kTwoColours},
        columns_key<Of>(section, "Cells of the pattern around the axis; for noise, grains per radius."),
        rows_key<Of>(section,
                     "Cells of the pattern from top to bottom, or from rim to rim; for stripes, their number."),
    };
}

template <class Rows>
void append(std::vector<SceneKey>& keys, const Rows& rows) {
    keys.insert(keys.end(), std::begin(rows), std::end(rows));
}

template <class Shape>
void append_kind(std::vector<SceneKey>& keys, const BodyKind& kind) {
    append(keys, kind.keys());
    if (kind.has_side) keys.push_back(side_key<Shape>(kind.key));
    append(keys, material_keys<Shape>(kind.key));
    if (kind.has_mapping) append(keys, mapping_keys<Shape>(kind.key));
}

}  // namespace

void append_body_keys(std::vector<SceneKey>& keys) {
    append(keys, pattern_keys<OfSky>("sky", "[0.5, 0.75, 1]", "[0.01, 0.015, 0.03]"));
    append(keys, pattern_keys<OfDisc>("disc", "[1, 0.72, 0.42]", "[0.12, 0.05, 0.03]"));
    for_each_kind([&]<class Shape>(const BodyKind& kind) { append_kind<Shape>(keys, kind); });
}

}  // namespace nullscope
