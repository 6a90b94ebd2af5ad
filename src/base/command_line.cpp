#include "base/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/text.h"

namespace nullscope {
namespace {

using Words = std::vector<std::string>;

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

bool is_list(const Option& option) {
    return std::holds_alternative<Words*>(option.target) || std::holds_alternative<std::vector<int>*>(option.target);
}

enum class Kind { kFlag, kText, kWhole, kReal };

Kind kind_of(const Option& option) {
    return std::visit(
        Overloaded{[](bool*) { return Kind::kFlag; }, [](std::string*) { return Kind::kText; },
                   [](Words*) { return Kind::kText; }, [](double*) { return Kind::kReal; },
                   [](std::optional<double>*) { return Kind::kReal; }, [](auto*) { return Kind::kWhole; }},
        option.target);
}

// The ends of what a number may be: the option's range, else its type's.
std::pair<double, double> range_of(const Option& option) {
    if (option.range) return *option.range;
    if (kind_of(option) == Kind::kReal)
        return {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
    if (std::holds_alternative<unsigned*>(option.target)) return {0.0, std::numeric_limits<unsigned>::max()};
    return {std::numeric_limits<int>::lowest(), std::numeric_limits<int>::max()};
}

std::string number_text(const Option& option, double number) {
    return kind_of(option) == Kind::kReal ? fmt::format("{:g}", number) : fmt::format("{:.0f}", number);
}

std::string allowed_text(const Option& option) {
    if (!option.words.empty()) return fmt::format("{}", fmt::join(option.words, ", "));
    std::string type = kind_of(option) == Kind::kReal ? "numbers" : "whole numbers";
    if (!option.range) return type;
    return fmt::format("{} from {} to {}", type, number_text(option, option.range->first),
                       number_text(option, option.range->second));
}

// Why the value is none for the option; nothing if it is one.
std::optional<std::string> fault_of(const Option& option, const std::string& value) {
    if (!option.words.empty())
        return std::find(option.words.begin(), option.words.end(), value) == option.words.end()
                   ? std::optional("unknown")
                   : std::nullopt;
    if (kind_of(option) == Kind::kText || kind_of(option) == Kind::kFlag) return std::nullopt;
    const auto number = parse_number(value);
    if (!number || std::isnan(*number)) return "not a number";
    if (kind_of(option) == Kind::kWhole && std::trunc(*number) != *number) return "not a whole number";
    const auto [least, most] = range_of(option);
    return *number >= least && *number <= most ? std::nullopt : std::optional("out of range");
}

// value: one that fault_of() has nothing against, so its number is one of the type's.
void store(const Option& option, const Words& values) {
    const auto number = [](const std::string& value) { return *parse_number(value); };
    std::visit(
        Overloaded{[](bool* v) { *v = true; }, [&](std::string* v) { *v = values.front(); },
                   [&](Words* v) { *v = values; }, [&](int* v) { *v = static_cast<int>(number(values.front())); },
                   [&](unsigned* v) { *v = static_cast<unsigned>(number(values.front())); },
                   [&](double* v) { *v = number(values.front()); },
                   [&](std::optional<int>* v) { *v = static_cast<int>(number(values.front())); },
                   [&](std::optional<double>* v) { *v = number(values.front()); },
                   [&](std::vector<int>* v) {
                       v->clear();
                       for (const std::string& value : values) v->push_back(static_cast<int>(number(value)));
                   }},
        option.target);
}

// A command as CLI11 knows it. CLI11 splits the words and writes the help; values are read and judged here.
struct Node {
    const Command* command;
    CLI::App* app;
    std::string path;  // "nullscope bench frames"
    std::string help_text() const {
        return app->help(path.substr(0, path.size() - std::min(path.size(), command->name().size() + 1)));
    }
    std::vector<std::pair<const Option*, CLI::Option*>> options;
    std::vector<Node> nodes;
};

CLI::Option* add_to(CLI::App& app, const Option& option) {
    const std::string help = option.help + (option.other.empty() ? "" : fmt::format(" (only with {})", option.other));
    if (kind_of(option) == Kind::kFlag) return app.add_flag(option.names, help);
    const auto take = [](const CLI::results_t&) { return true; };
    CLI::Option* added = app.add_option(option.names, take, help);
    added->type_name(option_value(option))->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    if (is_list(option) && option.values == 1 && !option.one_each)
        added->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args();
    else
        added->expected(option.values);
    if (option.shows_default) added->default_str(option_default(option));
    return added->required(option.is_required);
}

Node node_of(const Command& command, CLI::App& app, const std::string& path) {
    Node node{&command, &app, path, {}, {}};
    if (!command.version().empty()) app.set_version_flag("--version", command.version());
    if (!command.credits().empty())
        app.add_flag_callback(
            "--credits", [text = command.credits()] { throw CLI::CallForVersion(text, 0); },
            "Sources and licences of the data that ship with the program");
    for (const auto& option : command.options()) node.options.emplace_back(option.get(), add_to(app, *option));
    for (const auto& child : command.commands())
        node.nodes.push_back(node_of(*child, *app.add_subcommand(child->name(), child->help()),
                                     fmt::format("{} {}", path, child->name())));
    if (!node.nodes.empty()) app.require_subcommand(1);
    if (!command.footer().empty()) app.footer(command.footer());  // last: commands would inherit it
    return node;
}

// The innermost command that was named.
const Node& named(const Node& node) {
    for (const Node& child : node.nodes)
        if (child.app->parsed()) return named(child);
    return node;
}

Error usage_error(const Node& node, const std::string& what, const std::string& nearest = "") {
    const std::string hint = nearest.empty() ? "" : fmt::format(" (nearest: {})", nearest);
    return bad_input(fmt::format("{}{} (see: {} --help)", what, hint, node.path));
}

Error unknown_word(const Node& node, const std::string& word) {
    Words known;
    if (word.starts_with("-")) {
        for (const CLI::Option* option : node.app->get_options())
            for (const std::string& name : option->get_lnames()) known.push_back(fmt::format("--{}", name));
        return usage_error(node, fmt::format("{}: no such option", word), nearest_word(word, known));
    }
    if (node.nodes.empty()) return usage_error(node, fmt::format("{}: not expected here", word));
    for (const Node& child : node.nodes) known.push_back(child.command->name());
    return usage_error(node, fmt::format("{}: no such command; allowed: {}", word, fmt::join(known, ", ")),
                       nearest_word(word, known));
}

// What CLI11 has against the words, said in our own.
Error split_error(const Node& root, const CLI::ParseError& error) {
    const Node& node = named(root);
    const Words unknown = root.app->remaining(true);
    if (!unknown.empty()) return unknown_word(node, unknown.front());
    if (!node.nodes.empty()) {
        Words names;
        for (const Node& child : node.nodes) names.push_back(child.command->name());
        return usage_error(node, fmt::format("a command is missing; allowed: {}", fmt::join(names, ", ")));
    }
    const std::string what = error.what(), name = what.substr(0, what.find(':'));
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return usage_error(node, what);
    for (const auto& [option, added] : node.options)
        if (added->check_name(name) && option->values > 1)
            return usage_error(node, fmt::format("{}: takes {} values", name, option->values));
    return usage_error(node, fmt::format("{}: a value is missing", name));
}

std::optional<Error> value_error(const Node& node, const Option& option, const CLI::Option& added,
                                 const Words& values) {
    const std::string name = added.get_name();
    if (kind_of(option) == Kind::kFlag && values != Words(values.size(), "true"))
        return usage_error(node, fmt::format("{}: takes no value", name));
    if (!is_list(option) && values.size() > 1) return usage_error(node, fmt::format("{}: given more than once", name));
    if (option.values > 1 && values.size() != static_cast<std::size_t>(option.values))
        return usage_error(node, fmt::format("{}: takes {} values", name, option.values));
    for (const std::string& value : values)
        if (const auto fault = fault_of(option, value))
            return usage_error(node, fmt::format("{} {}: {}; allowed: {}", name, value, *fault, allowed_text(option)),
                               nearest_word(value, option.words));
    for (const auto& [second, with] : node.options)
        if (with->check_name(option.other) && with->count() == 0)
            return usage_error(node, fmt::format("{}: only with {}", name, option.other));
    return std::nullopt;
}

Result<Asked> asked_of(const Node& node) {
    for (const auto& [option, added] : node.options) {
        if (added->count() == 0) continue;
        if (const auto wrong = value_error(node, *option, *added, added->results())) return *wrong;
        store(*option, added->results());
        if (node.command->given() != nullptr) node.command->given()->push_back(option->names);
    }
    return Asked{"", node.command->run()};
}

// "help bench frames": the help of the command that the words after "help" name.
Result<Asked> help_of(const Node& root, const Words& words) {
    const Node* at = &root;
    for (const std::string& word : words) {
        const auto same = [&](const Node& child) { return child.command->name() == word; };
        const auto found = std::find_if(at->nodes.begin(), at->nodes.end(), same);
        if (found == at->nodes.end()) return unknown_word(*at, word);
        at = &*found;
    }
    return Asked{at->help_text(), {}};
}

}  // namespace

void copy_value(const Option& from, const Option& to) {
    std::visit([&](auto* value) { *std::get<decltype(value)>(to.target) = *value; }, from.target);
}

std::string option_value(const Option& option) {
    if (kind_of(option) == Kind::kFlag) return "";
    if (!option.words.empty()) return fmt::format("TEXT:{{{}}}", fmt::join(option.words, ","));
    if (kind_of(option) == Kind::kText) return "TEXT";
    std::string type = kind_of(option) == Kind::kReal ? "FLOAT" : "INT";
    if (!option.range) return type;
    return fmt::format("{} in [{} - {}]", type, number_text(option, option.range->first),
                       number_text(option, option.range->second));
}

std::string option_default(const Option& option) {
    return std::visit(Overloaded{[](const bool*) { return std::string(); },
                                 [](const Words* v) { return fmt::format("[{}]", fmt::join(*v, ",")); },
                                 [](const std::vector<int>* v) { return fmt::format("[{}]", fmt::join(*v, ",")); },
                                 [](const std::optional<int>* v) { return *v ? fmt::format("{}", **v) : ""; },
                                 [](const std::optional<double>* v) { return *v ? fmt::format("{:g}", **v) : ""; },
                                 [](const double* v) { return fmt::format("{:g}", *v); },
                                 [](const auto* v) { return fmt::format("{}", *v); }},
                      option.target);
}

Command& Command::add_command(std::string name, std::string help) {
    return *commands_.emplace_back(std::make_unique<Command>(std::move(name), std::move(help)));
}

Option& Command::add_option(std::string names, OptionTarget target, std::string help) {
    return *options_.emplace_back(
        std::make_unique<Option>(Option{std::move(names), std::move(help), target, {}, {}, {}, {}, 1, {}}));
}

Result<Asked> parse_command_line(const Command& program, int argc, const char* const* argv) {
    CLI::App app{program.help(), program.name()};
    app.allow_windows_style_options(false);  // a word that begins with '/' is a file everywhere
    const Node root = node_of(program, app, program.name());
    const Words words(argv + std::min(argc, 1), argv + argc);
    if (!root.nodes.empty() && words.empty()) return help_of(root, {});
    if (!root.nodes.empty() && words.front() == "help") return help_of(root, {words.begin() + 1, words.end()});
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) return split_error(root, error);
        std::ostringstream text;  // --help, --version, --credits
        app.exit(error, text, text);
        return Asked{text.str(), {}};
    }
    return asked_of(named(root));
}

}  // namespace nullscope
