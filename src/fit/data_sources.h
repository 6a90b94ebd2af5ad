// Data as people have them: a picture, or a table as `nullscope` writes it; and the subject that they are of.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "fit/scene_painter.h"
#include "fit/subject.h"
#include "telescope/csv_table.h"

namespace nullscope::fit {

struct DataSources {
    std::string data;                      // a file; a table's ends in .csv. Of what is below: how errors call it
    std::optional<std::string> table{};    // the text of a table, which is in no file
    std::optional<PictureData> picture{};  // a picture, likewise
    std::string sigma{}, mask{};           // as PictureSources; of tables in the place of their column noise
    bool free_flux = false;
    std::optional<int> samples{};  // rays along each side of a pixel; nothing: as many as it takes
};

// Tables are told apart by their columns: g_from of a line's profile, time or time_s of a light curve, else visibilities.
// Errors (bad input): those of the files; file, line and column of the first fault; a scene that cannot predict them.
Result<Subject> open_subject(const SceneFamily& family, const SessionSource& sessions, const DataSources& sources);

// A table that was read, and what is in the place of its column noise.
struct TableSource {
    std::string name, text, sigma;
    bool free_flux = false;
    bool has(std::string_view column) const;  // in its header
};
// Of observed.value, so many numbers a line: the column's, else one for all, by the words. of_what: "amplitude". Errors (bad input): both, none.
Status set_table_sigma(const CsvTable& table, const std::string& column, const TableSource& source,
                       const std::string& of_what, std::size_t numbers_a_line, Observed& observed);
std::string table_words(const std::string& count, const TableSource& source);

}  // namespace nullscope::fit
