// Recursive descent, one function a level of precedence:
//   sum = product {(+|-) product}     product = sign {(*|/) sign}     sign = - sign | power
//   power = atom [^ sign]             atom = number | name | name(sum, ...) | (sum)
#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/text.h"
#include "expr/formula.h"

namespace nullscope::expr {
namespace {

bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool digit(char c) { return c >= '0' && c <= '9'; }

class Parser {
public:
    Parser(std::string_view text, const std::vector<std::string>& variables) : text_(text), variables_(variables) {}

    Result<std::vector<Formula::Node>> run() {
        const int value = sum();
        skip_blanks();
        if (error_.empty() && at_ < text_.size()) refuse("an operator or the end is missing");
        if (!error_.empty()) return bad_input(error_);
        if (static_cast<std::size_t>(value) + 1 != nodes_.size()) return bad_input("column 1: nothing to compute");
        return std::move(nodes_);
    }

private:
    // The first fault is kept; after it every function returns at once.
    int refuse(const std::string& what) {
        if (error_.empty()) error_ = fmt::format("column {}: {}", at_ + 1, what);
        return 0;
    }
    int node(Formula::Node made) {
        if (!error_.empty()) return 0;
        if (nodes_.size() >= kMostNodes) return refuse(fmt::format("more than {} operands and operations", kMostNodes));
        nodes_.push_back(made);
        return static_cast<int>(nodes_.size()) - 1;
    }
    int node(Op op, int a, int b = 0, int c = 0) { return node({op, {a, b, c}, 0, 0}); }

    void skip_blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    }
    char peek() {
        skip_blanks();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c) {
        if (peek() != c || at_ >= text_.size()) return false;
        ++at_;
        return true;
    }
    bool too_deep() {
        if (depth_ >= kDeepest) refuse(fmt::format("nested more than {} deep", kDeepest));
        return !error_.empty();
    }

    int sum() { return chain(&Parser::product, {{{'+', Op::kAdd}, {'-', Op::kSubtract}}}); }
    int product() { return chain(&Parser::sign, {{{'*', Op::kMultiply}, {'/', Op::kDivide}}}); }
    // Operands with either operator between them, from left to right.
    int chain(int (Parser::*operand)(), const std::array<std::pair<char, Op>, 2>& operators) {
        int left = (this->*operand)();
        while (error_.empty()) {
            const auto next =
                std::find_if(operators.begin(), operators.end(), [&](const auto& o) { return take(o.first); });
            if (next == operators.end()) break;
            left = node(next->second, left, (this->*operand)());
        }
        return left;
    }
    int sign() {
        if (too_deep()) return 0;
        ++depth_;
        const bool negative = take('-');
        const int value = negative ? sign() : power();
        --depth_;
        if (!negative || !error_.empty()) return value;
        Formula::Node& inner = nodes_[static_cast<std::size_t>(value)];
        if (inner.op != Op::kNumber) return node(Op::kNegate, value);
        inner.number = -inner.number;  // x^-2 has a constant exponent
        return value;
    }
    int power() {
        const int base = atom();
        return error_.empty() && take('^') ? node(Op::kPower, base, sign()) : base;
    }
    int atom() {
        const char c = peek();
        if (take('(')) return bracketed();
        if (digit(c) || c == '.') return number();
        if (letter(c)) return name();
        return refuse(c == '\0' ? "the formula ends where a value is expected" : "a value is expected");
    }
    int bracketed() {
        if (too_deep()) return 0;
        ++depth_;
        const int inner = sum();
        --depth_;
        if (error_.empty() && !take(')')) return refuse("a ) is missing");
        return inner;
    }
    int number() {
        double value = 0;
        const auto [end, fault] = fast_float::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (fault != std::errc{} || !(std::abs(value) <= kLargest)) return refuse("not a number up to 1e30");
        at_ = static_cast<std::size_t>(end - text_.data());
        return node({Op::kNumber, {}, value, 0});
    }
    int name() {
        const std::size_t start = at_;
        while (at_ < text_.size() && (letter(text_[at_]) || digit(text_[at_]))) ++at_;
        const std::string word(text_.substr(start, at_ - start));
        if (take('(')) return call(word, start);
        if (word == "pi") return node({Op::kNumber, {}, std::numbers::pi, 0});
        const auto found = std::find(variables_.begin(), variables_.end(), word);
        if (found != variables_.end())
            return node({Op::kVariable, {}, 0, static_cast<std::size_t>(found - variables_.begin())});
        std::vector<std::string> known = variables_;
        known.emplace_back("pi");
        return refuse_word(fmt::format("\"{}\" is not known here", word.substr(0, 20)), word, start, std::move(known));
    }
    // What stands at start is none of the known words, nor of the functions.
    int refuse_word(const std::string& what, const std::string& word, std::size_t start,
                    std::vector<std::string> known) {
        at_ = start;
        for (const OpRow& row : kOps)
            if (!row.name.empty()) known.emplace_back(row.name);
        const std::string nearest = nearest_word(word, known);
        return refuse(nearest.empty() ? what : fmt::format("{} (nearest: {})", what, nearest));
    }
    int call(const std::string& word, std::size_t start) {
        if (too_deep()) return 0;
        ++depth_;
        std::array<int, 3> arguments{};
        std::size_t count = 0;
        do {
            if (count == arguments.size()) return refuse("more than 3 arguments");
            arguments[count++] = sum();
            if (!error_.empty()) return 0;
        } while (take(','));
        --depth_;
        if (!take(')')) return refuse("a ) is missing");
        bool known = false;
        for (const OpRow& row : kOps) {
            if (row.name != word) continue;
            known = true;
            if (row.arguments == count) return node(row.op, arguments[0], arguments[1], arguments[2]);
        }
        if (!known) return refuse_word(fmt::format("no function \"{}\"", word.substr(0, 20)), word, start, {});
        at_ = start;
        return refuse(fmt::format("{} does not take {} arguments", word, count));
    }

    std::string_view text_;
    const std::vector<std::string>& variables_;
    std::vector<Formula::Node> nodes_;
    std::string error_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

Result<Formula> Formula::parse(std::string_view text, const std::vector<std::string>& variables) {
    if (text.size() > kLongest)
        return bad_input(fmt::format("column {}: longer than {} bytes", kLongest + 1, kLongest));
    TRY(nodes, Parser(text, variables).run());
    Formula formula;
    formula.nodes_ = std::move(*nodes);
    formula.variables_ = variables;
    return formula;
}

}  // namespace nullscope::expr
