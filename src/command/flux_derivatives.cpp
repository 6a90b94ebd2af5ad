#include "command/flux_derivatives.h"

#include <fmt/format.h>

#include <cstdio>

#include "gradient/picture_flux.h"
#include "gradient/picture_matter.h"

namespace nullscope::cli {

namespace {

template <class Light, class Rule>
Result<FluxTable> table_of(const Scene& scene, const std::vector<std::string>& keys, double error) {
    TRY(light, Light::make(scene, keys));
    Rule rule;
    rule.tolerance = error;
    TRY(found, flux_gradient(**light, rule, [](double left) {
            fmt::print(stderr, "flux with derivatives: within {:.1g} of themselves\n", left);
        }));
    FluxTable table;
    table.rows.push_back({"flux", found->flux, 1, found->flux_error});
    for (std::size_t i = 0; i < found->by.size(); ++i)
        table.rows.push_back(
            {"d_" + (*light)->keys()[i].name, found->by[i], found->by[i] / found->flux, found->by_error[i]});
    if (!(found->error <= error))
        table.notes.push_back(
            fmt::format("within {:.2g}, not within the {:g} that was asked for", found->error, error));
    return table;
}

}  // namespace

Result<FluxTable> flux_derivatives(const Scene& scene, const std::vector<std::string>& keys, double error) {
    TRY(table, scene.medium && !scene.disc ? table_of<PictureMatter, MatterFluxRule>(scene, keys, error)
                                           : table_of<PictureLight, FluxRule>(scene, keys, error));
    if (scene.disc && scene.disc->material.texture == TextureKind::kGas)
        table->notes.emplace_back("disc.texture = \"gas\" counts as its mean");
    if (scene.sky.kind != SkyKind::kBlack) table->notes.emplace_back("the sky's light does not count");
    return std::move(*table);
}

std::string flux_csv(const FluxTable& table) {
    std::string text = "key,value,relative,error\n";
    for (const FluxTable::Row& row : table.rows)
        text += fmt::format("{},{:.9g},{:.9g},{:.2g}\n", row.name, row.value, row.relative, row.error);
    return text;
}

}  // namespace nullscope::cli
