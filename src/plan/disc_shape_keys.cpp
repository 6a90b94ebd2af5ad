#include "plan/disc_shape_keys.h"

namespace nullscope {
namespace {

template <std::vector<double> DiscWarp::*list>
constexpr KeyMember kWarpList = {[](const Scene& s) {
                                     const auto& numbers = s.disc->warp.*list;
                                     return KeyValue{.numbers = numbers, .there = !numbers.empty()};
                                 },
                                 [](Scene& s, const KeyValue& v) { s.disc->warp.*list = v.numbers; }};

SceneKey warp_key(std::string_view key, std::string_view unit, KeyRange range, std::string_view help, KeyMember member,
                  bool any_order) {
    SceneKey row{"disc", key, KeyType::kNumbers, unit, "", range, "", help, member};
    row.any_order = any_order;
    return row;
}

}  // namespace

std::vector<SceneKey> disc_shape_keys() {
    return {warp_key("warp_radii", "r_s", closed(1e-6, 1e6),
                     "Radii of a warped disc's rows: at each of them warp_tilts and warp_nodes say in which plane its "
                     "ring lies.",
                     kWarpList<&DiscWarp::radii>, false),
            warp_key("warp_tilts", "deg", closed(0.0, 170.0),
                     "Tilt of the ring at each of warp_radii, from the plane of tilt and node.",
                     kWarpList<&DiscWarp::tilts_deg>, true),
            warp_key("warp_nodes", "deg", kAnyAngle,
                     "Azimuth of the ascending node of the ring at each of warp_radii, in the plane of tilt and node.",
                     kWarpList<&DiscWarp::nodes_deg>, true),
            warp_key("rings", "r_s", closed(1e-6, 1e6),
                     "Radii where the disc's rings begin and end, in pairs; between them are gaps.",
                     kWarpList<&DiscWarp::rings>, false)};
}

}  // namespace nullscope
