#include "shaderlib/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/text.h"

namespace nullscope {
namespace {

constexpr std::array<std::pair<Lookup, const char*>, 4> kLookups = {{{Lookup::kHardware, "hardware"},
                                                                     {Lookup::kBilinear, "bilinear"},
                                                                     {Lookup::kCubic, "cubic"},
                                                                     {Lookup::kHermite, "hermite"}}};
constexpr double kEulerSpan = 2.5 * M_PI;  // rad: what a march of N equal steps is spread over
constexpr int kStepsPerSpan = 12;          // the cap of the high orders, in spans of 1 rad per step size

int most_steps(MethodKind kind, int order, double step) {
    const Method usual;  // auto's, of a rotating hole
    if (kind == MethodKind::kMino)
        return std::max(usual.most_steps, static_cast<int>(std::ceil(usual.most_steps * usual.step / step)));
    return order == 1 ? static_cast<int>(std::lround(kEulerSpan / step))
                      : static_cast<int>(std::ceil(3.0 * kStepsPerSpan / step));
}

bool euler_steps(double n) { return n >= 10 && n <= 5000 && n == std::floor(n); }

Result<Method> parse_table(const std::vector<std::string>& parts, const Error& error) {
    Method method{.kind = MethodKind::kTable};
    if (parts.size() > 1) {
        const auto size = parse_number(parts[1]);
        if (!size || *size < 8 || *size > 1024 || *size != std::floor(*size)) return error;
        method.size = static_cast<int>(*size);
    }
    if (parts.size() < 3) return method;
    for (const auto& [lookup, name] : kLookups) {
        if (parts[2] != name) continue;
        method.lookup = lookup;
        return method;
    }
    return error;
}

// integrate or mino.
Result<Method> parse_steps(MethodKind kind, const std::vector<std::string>& parts, const Error& error) {
    Method method{.kind = kind};
    if (parts.size() > 1) {
        const auto order = parse_number(parts[1]);
        if (!order || ((*order != 1 || kind == MethodKind::kMino) && *order != 4 && *order != 6)) return error;
        method.order = static_cast<int>(*order);
    }
    if (parts.size() > 2) {
        const auto step = parse_number(parts[2]);
        if (!step || *step < 1e-3 || *step > 1.0) return error;
        method.step = *step;
    }
    method.most_steps = most_steps(kind, method.order, method.step);
    return method;
}

}  // namespace

Result<Method> parse_method(const std::string& text) {
    const Error error = bad_input(
        fmt::format("method \"{}\" is not known", text),
        "strip, strip:cubic, table[:SIZE[:hardware|bilinear|cubic|hermite]] with SIZE 8 to 1024, closed-form, "
        "integrate[:ORDER[:STEP]] with ORDER 1, 4 or 6 and STEP 0.001 to 1 rad, euler:STEPS with STEPS 10 to 5000, "
        "mino[:ORDER[:STEP]] with ORDER 4 or 6 and STEP 0.001 to 1, kerr-schild:STEP with STEP 0.001 to 1");
    const auto parts = split(text, ':');
    if (parts.empty() || parts.size() > 3) return error;
    if (parts[0] == "table") return parse_table(parts, error);
    if (parts[0] == "integrate") return parse_steps(MethodKind::kIntegrate, parts, error);
    if (parts[0] == "mino") return parse_steps(MethodKind::kMino, parts, error);
    if (parts[0] == "euler" && parts.size() == 2) {
        const auto steps = parse_number(parts[1]);
        if (!steps || !euler_steps(*steps)) return error;
        Method method{.kind = MethodKind::kIntegrate, .order = 1, .step = kEulerSpan / *steps};
        method.most_steps = static_cast<int>(*steps);
        return method;
    }
    if (parts[0] == "kerr-schild" && parts.size() == 2) {
        const auto step = parse_number(parts[1]);
        if (!step || *step < 1e-3 || *step > 1.0) return error;
        return Method{.kind = MethodKind::kKerrSchild, .step = *step};
    }
    if (text == "strip") return Method{};
    if (text == "strip:cubic") return Method{.cubic = true};
    if (parts.size() == 1 && text == "closed-form") return Method{.kind = MethodKind::kClosedForm};
    return error;
}

std::string method_name(const Method& method) {
    switch (method.kind) {
        case MethodKind::kStrip: return method.cubic ? "strip:cubic" : "strip";
        case MethodKind::kClosedForm: return "closed-form";
        case MethodKind::kMino: return fmt::format("mino:{}:{}", method.order, method.step);
        case MethodKind::kKerrSchild: return fmt::format("kerr-schild:{}", method.step);
        case MethodKind::kTable:
            return fmt::format("table:{}:{}", method.size, kLookups[static_cast<std::size_t>(method.lookup)].second);
        case MethodKind::kIntegrate:
            if (method.order == 1 && method.step == kEulerSpan / method.most_steps && euler_steps(method.most_steps))
                return fmt::format("euler:{}", method.most_steps);
            return fmt::format("integrate:{}:{}", method.order, method.step);
    }
    return "";
}

}  // namespace nullscope
