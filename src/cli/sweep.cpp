#include "cli/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/text.h"
#include "scenefile/scene_override.h"

namespace nullscope::cli {
namespace {

constexpr std::size_t kLargestTable = std::size_t{64} << 20;  // bytes

// At commas that stand neither in brackets nor in quotes.
std::vector<std::string> values_of(const std::string& text) {
    std::vector<std::string> values(1);
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else
            depth += c == '[' || c == '{' || c == '(' ? 1 : c == ']' || c == '}' || c == ')' ? -1 : 0;
        if (c == ',' && depth == 0 && quote == 0)
            values.emplace_back();
        else
            values.back() += c;
    }
    return values;
}

// FROM:TO:COUNT; nothing: it is none of these.
Result<std::optional<std::vector<std::string>>> range_of(const std::string& words, const std::string& text) {
    const std::vector<std::string> parts = split(text, ':');
    std::vector<double> numbers;
    for (const std::string& part : parts)
        if (const auto number = parse_number(part); number && std::isfinite(*number)) numbers.push_back(*number);
    if (parts.size() != 3 || numbers.size() != 3) return std::optional<std::vector<std::string>>();
    const double from = numbers[0], to = numbers[1], count = numbers[2];
    if (!(count >= 2 && count <= kMostCases) || count != std::trunc(count))
        return bad_input(fmt::format("--set {}: {} values", words, parts[2]),
                         fmt::format("FROM:TO:COUNT, both ends included, a whole number from 2 to {}", kMostCases));
    std::vector<std::string> values;
    values.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < static_cast<int>(count); ++i)  // the ends are exact
        values.push_back(fmt::format("{}", i == 0 ? from : i + 1 == count ? to : from + i * (to - from) / (count - 1)));
    return std::optional(std::move(values));
}

}  // namespace

Result<Sweep> parse_sweep(const std::string& words) {
    TRY(given, parse_override(words));
    TRY(range, range_of(words, given->value));
    Sweep sweep{{given->key}, {}};
    for (std::string& value : *range ? **range : values_of(given->value)) {
        if (value.find_first_not_of(' ') == std::string::npos)
            return bad_input(fmt::format("--set {}: a value is missing", words), "KEY=A,B,C or KEY=FROM:TO:COUNT");
        sweep.values.push_back({std::move(value)});
    }
    return sweep;
}

Result<Sweep> read_sweep(const std::string& file) {
    TRY(text, read_text(file, kLargestTable));
    CsvLines lines(*text);
    const auto fault = [&](const std::string& what, const std::string& allowed) {
        Error error = bad_input(what, allowed);
        error.file = file, error.line = lines.number;
        return error;
    };
    Sweep sweep;
    while (lines.next()) {
        const auto fields = csv_fields(lines.line);
        if (!fields) return fault("a quote is not closed", "fields in pairs of quotes");
        if (std::ranges::any_of(*fields, [](const std::string& field) { return field.empty(); }))
            return fault("an empty field",
                         sweep.keys.empty() ? "keys of a scene, as camera.theta" : "a value in each column");
        if (sweep.keys.empty()) {
            sweep.keys = *fields;
        } else if (fields->size() != sweep.keys.size()) {
            return fault(fmt::format("{} fields", fields->size()),
                         fmt::format("{}, as in the header", sweep.keys.size()));
        } else {
            sweep.values.push_back(*fields);
        }
        if (sweep.values.size() > kMostCases) return fault("one line too many", fmt::format("at most {}", kMostCases));
    }
    if (sweep.values.empty()) return fault("no values", "a header of keys, and a line for each case");
    return sweep;
}

Result<Cases> Cases::of(std::vector<Sweep> sweeps) {
    Cases cases;
    cases.sweeps_ = std::move(sweeps);
    std::vector<std::string> known = cases.keys();
    std::ranges::sort(known);
    if (const auto twice = std::ranges::adjacent_find(known); twice != known.end())
        return bad_input(fmt::format("{} is set twice", *twice), "each key once");
    for (const Sweep& sweep : cases.sweeps_) {
        const double count = static_cast<double>(cases.count_) * static_cast<double>(sweep.values.size());
        if (count > kMostCases)
            return bad_input(fmt::format("{:.0f} cases or more", count), fmt::format("at most {}", kMostCases));
        cases.count_ = static_cast<int>(count);
    }
    return cases;
}

std::vector<std::string> Cases::keys() const {
    std::vector<std::string> keys;
    for (const Sweep& sweep : sweeps_) keys.insert(keys.end(), sweep.keys.begin(), sweep.keys.end());
    return keys;
}

std::vector<std::string> Cases::values(int number) const {
    std::vector<std::string> values;
    for (auto sweep = sweeps_.rbegin(); sweep != sweeps_.rend(); ++sweep) {
        const int steps = static_cast<int>(sweep->values.size());
        const auto& here = sweep->values[static_cast<std::size_t>(number % steps)];
        values.insert(values.begin(), here.begin(), here.end());
        number /= steps;
    }
    return values;
}

std::vector<std::string> Cases::words(int number) const {
    const std::vector<std::string> names = keys(), found = values(number);
    std::vector<std::string> words;
    for (std::size_t i = 0; i < names.size(); ++i) words.push_back(SceneOverride{names[i], found[i]}.words());
    return words;
}

int Cases::columns() const {
    const bool table = sweeps_.size() > 1 && sweeps_.back().values.size() > 1;
    return table ? static_cast<int>(sweeps_.back().values.size())
                 : static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count_))));
}

}  // namespace nullscope::cli
