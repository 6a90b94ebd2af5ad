// The test vectors: CSV with '#' comment lines and one header line.
#pragma once
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace nullscope {

using VectorRow = std::map<std::string, std::string>;

inline std::vector<VectorRow> load_vectors(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::vector<VectorRow> rows;
    std::vector<std::string> names;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::vector<std::string> cells;
        std::istringstream fields(line);
        for (std::string cell; std::getline(fields, cell, ',');) cells.push_back(cell);
        if (names.empty()) {
            names = cells;
            continue;
        }
        VectorRow row;
        for (std::size_t i = 0; i < cells.size(); ++i) row[names[i]] = cells[i];
        rows.push_back(row);
    }
    return rows;
}

inline double number(const VectorRow& row, const std::string& name) {
    const auto found = row.find(name);
    return found == row.end() || found->second.empty() ? std::nan("") : std::strtod(found->second.c_str(), nullptr);
}

}  // namespace nullscope
