#include "base/manual.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <system_error>

#include "base/atomic_file.h"
#include "base/text.h"

namespace nullscope {
namespace {

// Text as roff takes it: a line that begins with a dot or an apostrophe would be a request.
std::string roff(const std::string& text) {
    std::string out;
    bool begins = true;
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) out += "\\&";
        begins = c == '\n';
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    return out;
}

bool is_word(const Option& option) { return !option.names.starts_with("-"); }
bool takes_value(const Option& option) { return !std::holds_alternative<bool*>(option.target); }

std::vector<std::string> names_of(const Option& option) { return split(option.names, ','); }

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string synopsis(const Command& command, const std::string& path) {
    std::string line = fmt::format(".B {}\n", roff(path));
    if (!command.commands().empty()) return line + ".I COMMAND\n[\\fIOPTION\\fR ...]\n";
    for (const auto& option : command.options())
        if (is_word(*option))
            line += fmt::format("{0}\\fI{1}\\fR{2}\n", option->is_required ? "" : "[",
                                roff(upper(names_of(*option).front())), option->is_required ? "" : "]");
    return line + "[\\fIOPTION\\fR ...]\n";
}

std::string entry(const Option& option) {
    std::string names;
    for (const std::string& name : names_of(option))
        names += fmt::format("{}{}", names.empty() ? "" : ", ",
                             name.starts_with("-") ? fmt::format("\\fB{}\\fR", roff(name))
                                                   : fmt::format("\\fI{}\\fR", roff(upper(name))));
    if (!is_word(option) && takes_value(option)) names += fmt::format(" \\fI{}\\fR", roff(option_value(option)));
    std::string text = option.help;
    if (const std::string usual = option.shows_default ? option_default(option) : ""; !usual.empty())
        text += fmt::format(" (default: {})", usual);
    if (option.is_required) text += " (required)";
    if (!option.other.empty()) text += fmt::format(" (only with {})", option.other);
    return fmt::format(".TP\n{}\n{}\n", names, roff(text));
}

void add_pages(const Command& command, const std::string& path, const Command& program,
               std::vector<ManualPage>& pages) {
    std::string name = path;
    std::ranges::replace(name, ' ', '-');
    const std::string title = upper(name);
    const std::vector<std::string> lines = split(command.help(), '\n');
    std::string first = lines.front();
    if (const std::string prefix = path + ": "; first.starts_with(prefix)) first = first.substr(prefix.size());
    std::string text =
        fmt::format(".TH {} 1 \"\" \"nullscope {}\" \"User Commands\"\n", roff(title), program.version());
    text += fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(first));
    text += fmt::format(".SH SYNOPSIS\n{}", synopsis(command, path));
    if (lines.size() > 1 || !command.footer().empty()) {
        text += ".SH DESCRIPTION\n";
        text += ".nf\n";
        for (std::size_t i = 1; i < lines.size(); ++i) text += fmt::format("{}\n", roff(lines[i]));
        text += ".fi\n";
        for (const std::string& line : split(command.footer(), '\n'))
            text += line.empty() ? ".PP\n" : fmt::format("{}\n", roff(line));
    }
    if (!command.commands().empty()) {
        text += ".SH COMMANDS\n";
        for (const auto& child : command.commands())
            text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(child->name()), roff(split(child->help(), '\n').front()));
    }
    text += ".SH OPTIONS\n";
    for (const auto& option : command.options()) text += entry(*option);
    text += ".TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\nPrint help and exit\n";
    if (!command.version().empty()) text += ".TP\n\\fB\\-\\-version\\fR\nPrint the version and exit\n";
    if (!command.credits().empty())
        text += ".TP\n\\fB\\-\\-credits\\fR\nPrint whose data ship with the program, and on what terms\n";
    text +=
        ".SH EXIT STATUS\n0: done. 1: something failed from outside (a file, a driver). 2: bad input; one line says "
        "where and what is "
        "allowed.\n";
    if (&command != &program) text += fmt::format(".SH SEE ALSO\n.BR {} (1)\n", roff(program.name()));
    pages.push_back({name, std::move(text)});
    for (const auto& child : command.commands())
        add_pages(*child, fmt::format("{} {}", path, child->name()), program, pages);
}

std::string quoted(const std::string& words) { return fmt::format("'{}'", words); }  // words hold no quotes

// One branch of the completion's `case`: the words typed so far, without options.
void add_cases(const Command& command, const std::string& path, const std::string& scene_names, std::string& cases) {
    std::vector<std::string> offered, values;
    for (const auto& child : command.commands()) offered.push_back(child->name());
    bool scene = false;
    for (const auto& option : command.options()) {
        const std::vector<std::string> names = names_of(*option);
        scene = scene || names.front() == "scene";
        for (const std::string& name : names)
            if (name.starts_with("-")) offered.push_back(name);
        if (is_word(*option)) {
            offered.insert(offered.end(), option->words.begin(), option->words.end());
            continue;
        }
        if (!option->words.empty())
            values.push_back(fmt::format("                {}) words={}; files=no ;;\n", fmt::join(names, "|"),
                                         quoted(fmt::format("{}", fmt::join(option->words, " ")))));
    }
    offered.emplace_back("--help");
    cases += fmt::format("        {})\n            words={}\n", quoted(path),
                         quoted(fmt::format("{}", fmt::join(offered, " "))));
    if (scene && !scene_names.empty())
        cases += fmt::format("            [[ $now == -* ]] || words+=\" $({})\"\n", scene_names);
    if (!command.commands().empty()) cases += "            files=no\n";
    if (!values.empty())
        cases += fmt::format("            case $before in\n{}            esac\n", fmt::join(values, ""));
    cases += "            ;;\n";
    for (const auto& child : command.commands())
        add_cases(*child, fmt::format("{} {}", path, child->name()), scene_names, cases);
}

void add_paths(const Command& command, const std::string& path, std::vector<std::string>& paths) {
    for (const auto& child : command.commands()) {
        paths.push_back(fmt::format("{} {}", path, child->name()));
        add_paths(*child, paths.back(), paths);
    }
}

}  // namespace

std::vector<ManualPage> manual_pages(const Command& program) {
    std::vector<ManualPage> pages;
    add_pages(program, program.name(), program, pages);
    return pages;
}

std::string bash_completion(const Command& program, const std::string& scene_names) {
    std::string cases;
    add_cases(program, program.name(), scene_names, cases);
    std::vector<std::string> paths;
    add_paths(program, program.name(), paths);
    std::string function = program.name();
    std::ranges::replace(function, '-', '_');
    return fmt::format(R"(# bash completion of {0}
_{3}() {{
    local now=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} path={0} words= files=yes i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "$path ${{COMP_WORDS[i]}}" in
            {1}) path+=" ${{COMP_WORDS[i]}}" ;;
        esac
    done
    case $path in
{2}    esac
    COMPREPLY=($(compgen -W "$words" -- "$now"))
    if [[ $files == yes && $now != -* ]]; then COMPREPLY+=($(compgen -f -- "$now")); fi
}}
complete -o filenames -F _{3} {0}
)",
                       program.name(), fmt::format("'{}'", fmt::join(paths, "' | '")), cases, function);
}

Status write_manual(const Command& program, const std::string& scene_names, const std::filesystem::path& folder) {
    std::error_code reason;
    std::filesystem::create_directories(folder / "man1", reason);
    if (reason)
        return failed(fmt::format("cannot make the folder '{}': {}", (folder / "man1").string(), reason.message()));
    for (const ManualPage& page : manual_pages(program)) {
        TRY(written, write_text_atomically(folder / "man1" / (page.name + ".1"), page.text));
    }
    return write_text_atomically(folder / (program.name() + ".bash"), bash_completion(program, scene_names));
}

}  // namespace nullscope
