// The command line of a program: its commands, their options, help, and one line for what is wrong with it. The package
// behind it, CLI11, is included by command_line.cpp alone: its headers take seconds in every file that sees them.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/result.h"

namespace nullscope {

// Where a value goes. It keeps what it holds (the default) unless the option is given.
using OptionTarget = std::variant<bool*, std::string*, int*, unsigned*, double*, std::optional<int>*,
                                  std::optional<double>*, std::vector<std::string>*, std::vector<int>*>;

// One option, and what its values may be.
struct Option {
    std::string names, help;  // "-o,--output"; without dashes: a word by its place
    OptionTarget target;
    bool is_required = false, shows_default = false;
    std::vector<std::string> words;                  // the values that are allowed; none: any
    std::optional<std::pair<double, double>> range;  // of numbers; both ends are allowed
    int values = 1;                                  // of a list of fixed length; a list without one takes 1 or more
    std::string other;                               // the option that this one is part of
    bool one_each = false;                           // a list whose option is given once for each value

    Option& required() {
        is_required = true;
        return *this;
    }
    Option& show_default() {
        shows_default = true;
        return *this;
    }  // help says what the target holds
    Option& one_of(std::vector<std::string> allowed) {
        words = std::move(allowed);
        return *this;
    }
    Option& in_range(double least, double most) {
        range = {least, most};
        return *this;
    }
    Option& count(int exactly) {
        values = exactly;
        return *this;
    }
    Option& repeated() {
        one_each = true;
        return *this;
    }
    Option& needs(std::string name) {
        other = std::move(name);
        return *this;
    }
};

// What its value may be, as help shows it: "INT in [1 - 64]", "TEXT:{gl,reference}"; of a flag nothing. And what its target holds.
std::string option_value(const Option& option);
std::string option_default(const Option& option);

// A program, or a command of one. Options are parsed into their targets, which must outlive the parsing.
class Command {
public:
    Command(std::string name, std::string help) : name_(std::move(name)), help_(std::move(help)) {}

    Command& add_command(std::string name, std::string help);
    Option& add_option(std::string names, OptionTarget target, std::string help);
    void add_flag(std::string names, bool* target, std::string help) {
        add_option(std::move(names), target, std::move(help));
    }
    // What it runs: the exit status, or the error that is reported.
    void on_run(std::function<Result<int>()> run) { run_ = std::move(run); }
    void on_run(std::function<Status()> run) {  // status 0 where there is no error
        run_ = [run = std::move(run)] {
            const Status done = run();
            return done ? Result<int>(0) : done.error();
        };
    }
    void set_footer(std::string text) { footer_ = std::move(text); }    // of the help text
    void set_version(std::string text) { version_ = std::move(text); }  // adds --version
    void set_credits(std::string text) { credits_ = std::move(text); }  // adds --credits

    // The names of the options that were given ("-o,--output") are added to it.
    void note_given(std::vector<std::string>* names) { given_ = names; }

    const std::string& name() const { return name_; }
    const std::string& help() const { return help_; }
    const std::string& footer() const { return footer_; }
    const std::string& version() const { return version_; }
    const std::string& credits() const { return credits_; }
    const std::function<Result<int>()>& run() const { return run_; }
    const std::vector<std::unique_ptr<Command>>& commands() const { return commands_; }
    const std::vector<std::unique_ptr<Option>>& options() const { return options_; }
    std::vector<std::string>* given() const { return given_; }

private:
    std::string name_, help_, footer_, version_, credits_;
    std::function<Result<int>()> run_;
    std::vector<std::string>* given_ = nullptr;
    std::vector<std::unique_ptr<Command>> commands_;  // a command that has commands needs one of them
    std::vector<std::unique_ptr<Option>> options_;    // pointers: add_* give out references
};

// Gives an option's target what the other's holds; both are of one kind.
void copy_value(const Option& from, const Option& to);

// What the words ask for: a text to print (help, version), or the run of the command that was named.
struct Asked {
    std::string text;
    std::function<Result<int>()> run;  // where there is no text; nothing if that command has none
};

// A program with commands takes "help [COMMAND...]" too, and alone it prints its help.
// Errors: one line with the option, its value and what is allowed.
Result<Asked> parse_command_line(const Command& program, int argc, const char* const* argv);

}  // namespace nullscope
