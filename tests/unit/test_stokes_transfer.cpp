// Transfer of Stokes parameters by the shader's closed form, in float, against the exponential of the matrix in many digits.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "shadercore/stokes_transfer.h"

using namespace nullscope;

namespace {

// Of a row of length 1: float's rounding in some thirty operations, and that of an angle beyond 10 rad.
double allowed(const StokesWay& way) {
    const double turned = std::hypot(way.turned[0], way.turned[1], way.turned[2]);
    return 1e-5 * std::max(1.0, turned / 10);
}

using Real = long double;
using Matrix = std::array<std::array<Real, 8>, 8>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k)
            for (int j = 0; j < 8; ++j) c[i][j] += a[i][k] * b[k][j];
    return c;
}

// exp(-[[K, -1], [0, 0]]) = [[exp(-K), mean of exp(-tK)], [0, 1]], by its series of a 2^-20th part, squared 20 times.
Matrix exponential(const StokesWay& way) {
    const Real d = way.depth, q = way.absorbed[0], u = way.absorbed[1], v = way.absorbed[2], rq = way.turned[0],
               ru = way.turned[1], rv = way.turned[2];
    const Real k[4][4] = {{d, q, u, v}, {q, d, rv, -ru}, {u, -rv, d, rq}, {v, ru, -rq, d}};
    constexpr int kHalvings = 20;
    Matrix m{};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) m[i][j] = -std::ldexp(k[i][j], -kHalvings);
        m[i][i + 4] = std::ldexp(Real{1}, -kHalvings);
    }
    Matrix sum{}, term{};
    for (int i = 0; i < 8; ++i) sum[i][i] = term[i][i] = 1;
    for (int n = 1; n < 12; ++n) {
        term = product(term, m);
        for (auto& row : term)
            for (Real& part : row) part /= n;
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j) sum[i][j] += term[i][j];
    }
    for (int n = 0; n < kHalvings; ++n) sum = product(sum, sum);
    return sum;
}

double largest_error(const StokesWay& way) {
    const Matrix exact = exponential(way);
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        StokesRow row{};
        row[i] = 1;
        const StokesSeen seen = stokes_seen(row, way);
        for (std::size_t j = 0; j < 4; ++j) {
            const double behind = static_cast<double>(exact[i][j]), mean = static_cast<double>(exact[i][j + 4]);
            CHECK(std::isfinite(seen.mean[j]));
            CHECK(std::isfinite(seen.behind[j]));
            most = std::max({most, std::abs(seen.behind[j] - behind), std::abs(seen.mean[j] - mean)});
        }
    }
    return most;
}

}  // namespace

TEST_CASE("stokes transfer: absorption, rotation and conversion alone, and all together") {
    for (const float size : {1e-6F, 1e-3F, 0.05F, 0.1F, 0.14F, 0.15F, 0.7F, 3.0F, 20.0F}) {
        INFO("size ", size);
        const StokesWay ways[] = {
            {size, {}, {}},
            {size, {0.7F * size, 0, 0}, {}},
            {size, {0.7F * size, -0.3F * size, 0.6F * size}, {}},
            {0, {}, {0, 0, size}},
            {0, {}, {size, 0, 0}},
            {0, {}, {0.6F * size, 0, 0.8F * size}},
            {size, {0.5F * size, 0.1F * size, 0.02F * size}, {0.3F * size, -0.4F * size, 3 * size}},
            {size, {0.7F * size, 0, 0}, {0, 0, 0.7F * size}},  // (a + i rho)^2 = 0
            {0.1F * size, {0.07F * size, 0, 0.01F * size}, {0.02F * size, 0, 5 * size}}};
        for (const StokesWay& way : ways) CHECK(largest_error(way) < allowed(way));
    }
}

TEST_CASE("stokes transfer: 4000 random ways, thin and thick") {
    std::mt19937 numbers(20261129);
    std::uniform_real_distribution<double> part(-1, 1), decades(-5, 1.3);
    double most = 0;
    for (int i = 0; i < 4000; ++i) {
        const double depth = std::pow(10.0, decades(numbers)), turn = std::pow(10.0, decades(numbers));
        const double share = std::abs(part(numbers));
        const Real x = part(numbers), y = part(numbers), z = part(numbers), length = std::sqrt(x * x + y * y + z * z);
        StokesWay way{static_cast<float>(depth), {}, {}};
        const Real direction[] = {x / length, y / length, z / length};
        for (std::size_t k = 0; k < 3; ++k) {
            way.absorbed[k] = static_cast<float>(share * depth * static_cast<double>(direction[k]));
            way.turned[k] = static_cast<float>(turn * part(numbers));
        }
        most = std::max(most, largest_error(way) / allowed(way));
    }
    MESSAGE("largest error over what is allowed ", most);
    CHECK(most < 1);
}

// Without absorption of polarised light and conversion the light is what it is without polarisation.
TEST_CASE("stokes transfer: a row of intensity stays one where nothing is polarised") {
    for (const float depth : {0.0F, 1e-5F, 0.1F, 1.0F, 2.5F, 50.0F}) {
        const StokesSeen seen = stokes_seen({1, 0, 0, 0}, {depth, {}, {0, 0, 2.0F}});
        const double mean = depth > 0 ? -std::expm1(-static_cast<double>(depth)) / depth : 1.0;
        CHECK(std::abs(seen.mean[0] - mean) < 2e-7);
        CHECK(std::abs(seen.behind[0] - std::exp(-depth)) < 4e-7);
        CHECK(seen.behind[1] == 0.0F);
    }
}
