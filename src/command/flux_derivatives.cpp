#include "command/flux_derivatives.h"

#include <fmt/format.h>

#include <cstdio>

#include "gradient/picture_flux.h"
#include "gradient/picture_matter.h"

namespace nullscope::cli {

namespace {

void tell(double left) { fmt::print(stderr, "flux with derivatives: within {:.1g} of themselves\n", left); }

FluxTable table_of(const FluxGradient& found, const std::vector<Parameter>& keys) {
    FluxTable table;
    table.rows.push_back({"flux", found.flux, 1, found.flux_error});
    for (std::size_t i = 0; i < found.by.size(); ++i)
        table.rows.push_back({"d_" + keys[i].name, found.by[i], found.by[i] / found.flux, found.by_error[i]});
    return table;
}

void tell_of_sky(const Scene& scene, FluxTable& table) {
    if (scene.sky.kind != SkyKind::kBlack) table.notes.emplace_back("the sky's light does not count");
}

Result<FluxTable> of_matter(const Scene& scene, const std::vector<std::string>& keys, double error) {
    TRY(light, PictureMatter::make(scene, keys));
    MatterFluxRule rule;
    rule.tolerance = error;
    TRY(found, flux_gradient(**light, rule, tell));
    FluxTable table = table_of(*found, (*light)->keys());
    tell_of_sky(scene, table);
    return table;
}

}  // namespace

Result<FluxTable> flux_derivatives(const Scene& scene, const std::vector<std::string>& keys, double error) {
    if (scene.medium && !scene.disc) return of_matter(scene, keys, error);
    TRY(light, PictureLight::make(scene, keys));
    FluxRule rule;
    rule.tolerance = error;
    TRY(found, flux_gradient(**light, rule, tell));
    FluxTable table = table_of(*found, (*light)->keys());
    if (scene.disc->material.texture == TextureKind::kGas)
        table.notes.emplace_back("disc.texture = \"gas\" counts as its mean");
    tell_of_sky(scene, table);
    return table;
}

std::string flux_csv(const FluxTable& table) {
    std::string text = "key,value,relative,error\n";
    for (const FluxTable::Row& row : table.rows)
        text += fmt::format("{},{:.9g},{:.9g},{:.2g}\n", row.name, row.value, row.relative, row.error);
    return text;
}

}  // namespace nullscope::cli
