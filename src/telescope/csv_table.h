// Tables of named columns, as other people write them.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace nullscope {

struct TableColumn {
    std::string_view name;
    double least, most;  // of its numbers; of texts both are 0
    bool needed = true;
};

struct TableLine {
    int number = 0;                   // in the file, from 1
    std::vector<std::string> fields;  // as many as the header has
};

inline constexpr std::size_t kLargestTable = std::size_t{64} << 20;  // bytes

// A header and the lines below it. Errors: one line, "FILE:LINE: COLUMN: what is wrong; allowed: ..." for the first fault.
class CsvTable {
public:
    // Errors: no header, a column that is unknown, missing or there twice, a line with another number of fields, more lines than `most`.
    static Result<CsvTable> read(std::string_view text, const std::string& file, std::vector<TableColumn> columns,
                                 std::size_t most);

    const std::vector<TableLine>& lines() const { return lines_; }
    bool has(std::string_view column) const;
    bool given(const TableLine& line, std::string_view column) const;  // has() it, and the field is not empty
    const std::string& text(const TableLine& line, std::string_view column) const;  // of a column that it has
    Result<double> number(const TableLine& line, std::string_view column) const;    // within its range
    Error fault(int line, std::string_view column, std::string_view what, std::string_view allowed) const;

private:
    Status read_header(int line, std::string_view text);
    const TableColumn& known(std::string_view column) const;
    std::string file_;
    std::vector<TableColumn> columns_;
    std::vector<std::string> header_;
    std::vector<TableLine> lines_;
};

}  // namespace nullscope
