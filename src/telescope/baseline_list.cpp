#include "telescope/baseline_list.h"

#include <fmt/format.h>

#include <cmath>

#include "telescope/csv_table.h"

namespace nullscope {

Result<BaselineList> read_baselines(std::string_view text, const std::string& file, std::optional<double> frequency) {
    constexpr double kMost =
        1e15;  // wavelengths: a turn of phase has three digits left in a picture of 100 microarcseconds
    TRY(table, CsvTable::read(text, file,
                              {{"u", -kMost, kMost},
                               {"v", -kMost, kMost},
                               {"time_h", -1e6, 1e6, false},
                               {"frequency_ghz", 1e-3, 1e6, false}},
                              kMostBaselines));
    BaselineList list;
    for (const TableLine& line : table->lines()) {
        TRY(u, table->number(line, "u"));
        TRY(v, table->number(line, "v"));
        list.baselines.push_back({*u, *v});
        list.lines.push_back(line.number);
        if (table->has("time_h")) {
            TRY(time, table->number(line, "time_h"));
            list.time_h.push_back(*time);
        }
        if (!table->has("frequency_ghz")) continue;
        TRY(of_line, table->number(line, "frequency_ghz"));
        constexpr double kSame = 1e-6;  // relative
        if (frequency && !(std::fabs(*of_line / *frequency - 1) <= kSame))
            return table->fault(line.number, "frequency_ghz", fmt::format("{} is not the light's", *of_line),
                                fmt::format("{}", *frequency));
        list.frequency_ghz.push_back(*of_line);
    }
    return list;
}

}  // namespace nullscope
