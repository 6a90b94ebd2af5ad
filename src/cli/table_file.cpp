#include "cli/table_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <type_traits>
#include <variant>

#include "base/atomic_file.h"
#include "command/svg.h"
#include "scenefile/picture_scene.h"
#include "version/version.h"

namespace nullscope::cli {
namespace {

// Every digit of it; of a flag nothing.
std::string words_of_target(const OptionTarget& target) {
    return std::visit(
        [](const auto* value) -> std::string {
            using Value = std::remove_cvref_t<decltype(*value)>;
            if constexpr (std::is_same_v<Value, bool>)
                return "";
            else if constexpr (requires { value->begin(); } && !std::is_same_v<Value, std::string>)
                return fmt::format(" {}", fmt::join(*value, " "));
            else if constexpr (requires { value->has_value(); })
                return *value ? fmt::format(" {}", **value) : "";
            else
                return fmt::format(" {}", *value);
        },
        target);
}

Result<std::map<std::string, std::string>> origin_words(const TableOrigin& origin) {
    if (!origin.of_scene)
        return std::map<std::string, std::string>{{kOptionsWord, origin.options}, {"nullscope.version", kVersionText}};
    PictureOrigin made{origin.scene, origin.scene_name.empty() ? SceneFolders{} : scene_folders(origin.scene_name)};
    made.options = origin.options, made.renderer = origin.renderer, made.version = kVersionText;
    made.times = origin.times;
    return picture_words(made);
}

}  // namespace

std::string GivenWords::words() const {
    std::string out;
    for (const auto& option : command_->options()) {
        if (!option->names.starts_with("--") || option->names == "--context" || option->names == "--device" ||
            !has(option->names))
            continue;
        out += (out.empty() ? "" : " ") + option->names + words_of_target(option->target);
    }
    return out;
}

Status write_table(const std::string& csv_file, const std::string& csv, const std::string& svg_file, std::string svg,
                   const TableOrigin& origin) {
    TRY(words, origin_words(origin));
    if (!origin.columns.empty()) (*words)["nullscope.columns"] = origin.columns;
    std::string metadata = "<metadata xmlns:n=\"nullscope\">\n";
    for (const auto& [keyword, text] : *words)
        metadata += fmt::format("<n:text keyword=\"{}\">{}</n:text>\n", in_xml(keyword), in_xml(text));
    svg.insert(svg.find('>') + 1, "\n" + metadata + "</metadata>");
    TRY(table, write_text_atomically(csv_file, csv));
    return write_text_atomically(svg_file, svg);
}

}  // namespace nullscope::cli
