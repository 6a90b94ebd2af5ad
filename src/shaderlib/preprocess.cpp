#include "shaderlib/preprocess.h"

#include <algorithm>
#include <map>
#include <set>

namespace nullscope {
namespace {

constexpr int kBlankLines = 8;      // a longer gap is shorter as #line
constexpr int kLinesAFile = 10000;  // and more than any has; gl/gl.cpp has it too

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

std::string_view without_comment(std::string_view line) {
    line = line.substr(0, line.find("//"));
    return line.substr(0, line.find_last_not_of(' ') + 1);
}

class Branches {
public:
    explicit Branches(const std::vector<std::string>& defines) : defined_(defines.begin(), defines.end()) {}

    // Is this line left in the text? The directives of branches are not.
    bool keep(std::string_view line) {
        const std::string_view directive = line.substr(0, line.find(' '));
        const auto name = [&] {
            const std::string_view rest = line.substr(std::min(directive.size() + 1, line.size()));
            return std::string(rest.substr(0, rest.find(' ')));
        };
        if (directive == "#ifdef" || directive == "#ifndef")
            levels_.push_back(defined_.contains(name()) == (directive == "#ifdef"));
        else if (directive == "#else" && !levels_.empty())
            levels_.back() = !levels_.back();
        else if (directive == "#endif" && !levels_.empty())
            levels_.pop_back();
        else {
            const bool kept = std::find(levels_.begin(), levels_.end(), false) == levels_.end();
            if (kept && directive == "#define") defined_.insert(name());
            return kept;
        }
        return false;
    }

private:
    std::set<std::string> defined_;
    std::vector<bool> levels_;
};

class Resolver {
public:
    Resolver(const std::vector<std::string>& defines, const ShaderReader& read)
        : read_(read),
          branches_(defines),
          cpp_(std::find(defines.begin(), defines.end(), "__cplusplus") != defines.end()) {}

    void include(const std::string& name) {
        if (!included_.insert(name).second) return;
        std::string_view file = read_(name);
        for (int number = 1; !file.empty(); ++number) {
            const std::string_view line = without_comment(next_line(file));
            if (line.empty() || !branches_.keep(line)) continue;
            constexpr std::string_view kInclude = "#include \"";
            if (line.starts_with(kInclude))
                include(std::string(line.substr(kInclude.size(), line.size() - kInclude.size() - 1)));
            else
                emit(name, number, line);
        }
    }

    std::string text;

private:
    void emit(const std::string& name, int number, std::string_view line) {
        if (name == file_ && number - next_ <= kBlankLines) {
            text.append(static_cast<std::size_t>(number - next_), '\n');
        } else {
            const auto [file, is_new] = numbers_.emplace(name, static_cast<int>(numbers_.size()) + 1);
            if (is_new && !cpp_) text.append("// ").append(name).append("\n");
            text.append("#line ").append(std::to_string(cpp_ ? number : kLinesAFile * file->second + number));
            text.append(cpp_ ? " \"" + name + "\"\n" : "\n");
        }
        text.append(line).append("\n");
        file_ = name;
        next_ = number + 1;
    }

    const ShaderReader& read_;
    Branches branches_;
    bool cpp_;
    std::set<std::string> included_;
    std::map<std::string, int> numbers_;
    std::string file_;  // what the text stands in
    int next_ = 0;
};

}  // namespace

std::string path_line(std::string_view kind, std::string_view name) {
    return "#include \"" + std::string(kind) + "/" + std::string(name.substr(kPathPrefix.size())) + ".glsl\"\n";
}

std::string resolved_branches(std::string_view text, const std::vector<std::string>& defines) {
    Branches branches(defines);
    std::string out;
    while (!text.empty()) {
        const std::string_view line = next_line(text);
        if (branches.keep(line)) out.append(line).append("\n");
    }
    return out;
}

std::string resolved_text(std::string_view root, const std::vector<std::string>& defines, const ShaderReader& read) {
    Resolver resolver(defines, read);
    resolver.include(std::string(root));
    return std::move(resolver.text);
}

}  // namespace nullscope
