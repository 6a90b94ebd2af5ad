// The test vectors: CSV with '#' comment lines and one header line.
#pragma once
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/csv.h"

namespace nullscope {

using VectorRow = std::map<std::string, std::string>;

inline std::vector<VectorRow> load_vectors(const std::filesystem::path& path) {
    std::vector<VectorRow> rows;
    std::vector<std::string> names;
    const auto text = read_text(path);
    if (!text) return rows;
    for (CsvLines csv(*text); csv.next();) {
        const auto cells = *csv_fields(csv.line);
        if (!names.empty()) rows.emplace_back();
        for (std::size_t i = 0; i < cells.size() && !names.empty(); ++i) rows.back()[names[i]] = cells[i];
        if (names.empty()) names = cells;
    }
    return rows;
}

inline double number(const VectorRow& row, const std::string& name) {
    const auto found = row.find(name);
    return found == row.end() || found->second.empty() ? std::nan("") : std::strtod(found->second.c_str(), nullptr);
}

}  // namespace nullscope
