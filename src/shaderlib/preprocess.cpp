#include "shaderlib/preprocess.h"

namespace nullscope {

std::string stripped(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        line = line.substr(0, line.find("//"));
        line = line.substr(0, line.find_last_not_of(' ') + 1);
        if (!line.empty()) out.append(line).append("\n");
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return out;
}

std::string resolved_branches(const std::string& text, const std::vector<std::string>& defines) {
    struct Level {
        bool ours, keep;
    };
    std::vector<Level> levels;
    const auto is_ours = [](const std::string& name) {
        for (const char* ours : {"EFFECT_", "BLOCK_", "NEEDS_", "DISPLAY_", "TABLE_", "STEP_ORDER_", "TEXTURE_",
                                 "MAPPING_", "SURFACE_", "METHOD_"})
            if (name.starts_with(ours)) return true;
        return name == "__cplusplus";
    };
    const auto kept = [&] {
        for (const Level& level : levels)
            if (level.ours && !level.keep) return false;
        return true;
    };
    std::string out;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = text.find('\n', at);
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        const bool ifdef = line.starts_with("#ifdef "), ifndef = line.starts_with("#ifndef ");
        bool drop = false;
        if (ifdef || ifndef) {
            const std::string name = line.substr(ifdef ? 7 : 8);
            bool defined = false;
            for (const std::string& d : defines) defined = defined || d == name;
            levels.push_back({is_ours(name), defined == ifdef});
            drop = levels.back().ours;
        } else if (line.starts_with("#else") && !levels.empty()) {
            levels.back().keep = !levels.back().keep;
            drop = levels.back().ours;
        } else if (line.starts_with("#endif") && !levels.empty()) {
            drop = levels.back().ours;
            levels.pop_back();
        }
        if (!drop && kept()) out += line + "\n";
    }
    return out;
}

}  // namespace nullscope
