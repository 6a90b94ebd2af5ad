// Values of the C library's functions at the same 20000 places on every machine, their bits in hexadecimal, a function a line.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

namespace {

template <class Value>
void line(const char* name, double low, double high, Value value) {
    constexpr int kPlaces = 20000;
    std::mt19937_64 generator(7);
    const auto place = [&] { return low + (high - low) * (static_cast<double>(generator() >> 11) * 0x1p-53); };
    std::printf("%s", name);
    for (int i = 0; i < kPlaces; ++i) {
        const double x = place(), y = place();
        std::printf(" %llx",
                    static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(static_cast<double>(value(x, y)))));
    }
    std::printf("\n");
}

}  // namespace

#define ONE(name, low, high) line(#name, low, high, [](double x, double) { return std::name(x); })
#define TWO(name, low, high) line(#name, low, high, [](double x, double y) { return std::name(x, y); })
#define ONE_FLOAT(name, low, high) \
    line(#name "f", low, high, [](double x, double) { return std::name(static_cast<float>(x)); })
#define TWO_FLOAT(name, low, high) \
    line(#name "f", low, high,     \
         [](double x, double y) { return std::name(static_cast<float>(x), static_cast<float>(y)); })

int main() {
    ONE(sqrt, 0, 9);
    ONE(sin, -9, 9);
    ONE(cos, -9, 9);
    ONE(tan, -3, 3);
    ONE(asin, -1, 1);
    ONE(acos, -1, 1);
    ONE(atan, -9, 9);
    TWO(atan2, -3, 3);
    ONE(exp, -9, 9);
    ONE(expm1, -2, 2);
    ONE(log, 1e-3, 99);
    ONE(log1p, -0.9, 9);
    TWO(pow, 0.01, 5);
    TWO(hypot, -5, 5);
    ONE(cbrt, -9, 9);
    ONE(sinh, -5, 5);
    ONE(cosh, -5, 5);
    ONE(tanh, -3, 3);
    ONE(asinh, -9, 9);
    ONE(acosh, 1, 99);
    ONE(atanh, -0.99, 0.99);
    ONE(tgamma, 0.1, 20);
    ONE(lgamma, 0.1, 20);
    ONE(erf, -3, 3);
    ONE_FLOAT(sin, -9, 9);
    ONE_FLOAT(exp, -9, 9);
    ONE_FLOAT(log, 1e-3, 9);
    TWO_FLOAT(pow, 0.01, 5);
    ONE_FLOAT(atan, -9, 9);
    TWO_FLOAT(atan2, -9, 9);
    TWO_FLOAT(hypot, -9, 9);
}
