// Tables of stations, and of baselines.
#include <cmath>

#include "fuzz.h"
#include "telescope/baseline_list.h"
#include "telescope/stations.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const auto stations = read_stations(fuzz::text_of(data, size), "stations.csv");
    if (!stations) fuzz::must_be_a_good_error(stations.error());
    if (stations)
        for (const Station& station : *stations)
            fuzz::must(!station.name.empty() && station.sefd_jy > 0 && std::isfinite(station.place[0]),
                       "it is a station");
    const auto list = read_baselines(fuzz::text_of(data, size), "baselines.csv", 230.0);
    if (!list) fuzz::must_be_a_good_error(list.error());
    if (list)
        for (const Baseline& baseline : list->baselines)
            fuzz::must(std::isfinite(baseline.u) && std::isfinite(baseline.v), "it is a baseline");
    return 0;
}
