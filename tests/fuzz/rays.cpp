// Ray lists (CSV), for a metric with a horizon and one without.
#include <algorithm>
#include <cmath>

#include "cli/ray_csv.h"
#include "fuzz.h"
#include "spacetime/registry.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    static const auto hole = make_spacetime("schwarzschild", {}), flat = make_spacetime("minkowski", {});
    for (const auto* spacetime : {&hole, &flat}) {
        const auto table = cli::parse_rays(fuzz::text_of(data, size), "rays.csv", ***spacetime);
        if (!table) {
            fuzz::must_be_a_good_error(table.error());
            fuzz::must(table.error().message().starts_with("rays.csv:"), "the file is named");
            continue;
        }
        for (const RayQuery& query : table->queries) {
            if (query.orbit)
                fuzz::must(query.orbit->q > 0 && query.orbit->zeta0 > 0, "an orbit within its ranges");
            else
                fuzz::must(query.r > 0 && std::fabs(length(query.n) - 1) < 1e-12, "a place and a unit direction");
        }
        const std::string text = cli::rays_text(*table, {}, {table->rows.size(), std::nullopt}, 1, {});
        const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
        fuzz::must(lines == table->rows.size() + 1, "a line out for every ray in");
    }
    return 0;
}
