// The cases of a parameter study: every combination of values of a scene's keys.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"

namespace nullscope::cli {

inline constexpr int kMostCases = 100000;

// Keys whose values change together: one, or the columns of a table.
struct Sweep {
    std::vector<std::string> keys;
    std::vector<std::vector<std::string>> values;  // of each step, one for each key
};

// "KEY=VALUE", "KEY=A,B,C" (commas within brackets or quotes are a value's own) or "KEY=FROM:TO:COUNT", both ends included. Errors (bad input).
Result<Sweep> parse_sweep(const std::string& words);
// A table (CSV) whose header has keys, a case in each line. Errors: one line with the file's.
Result<Sweep> read_sweep(const std::string& file);

// Every combination of them; those of the last sweep come one after the other.
class Cases {
public:
    // Errors (bad input): a key that two sweeps have, more than kMostCases.
    static Result<Cases> of(std::vector<Sweep> sweeps);
    int count() const { return count_; }
    const std::vector<Sweep>& sweeps() const { return sweeps_; }
    std::vector<std::string> keys() const;
    std::vector<std::string> values(int number) const;  // one for each key
    std::vector<std::string> words(int number) const;   // "KEY=VALUE" of each, for --set
    int columns() const;  // of a contact sheet: steps of the last sweep, if there are several sweeps

private:
    std::vector<Sweep> sweeps_;
    int count_ = 1;
};

}  // namespace nullscope::cli
