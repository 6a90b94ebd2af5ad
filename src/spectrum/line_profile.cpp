#include "spectrum/line_profile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "spacetime/circular_orbit.h"

namespace nullscope {
namespace {

// The image of one ring: traced this far to both sides, over the height above the horizon, with these nodes; more columns than a disc's by
// this factor, for its edges are sharp.
constexpr double kRingWidth = 0.1;
constexpr int kRingRadii = 9, kRingColumns = 32;

double limb_of(Limb limb, double mu) {
    switch (limb) {
        case Limb::kLaor: return 1.0 + 2.06 * mu;
        case Limb::kHaardt: return mu > 0.0 ? std::log1p(1.0 / mu) : 0.0;
        case Limb::kIsotropic: break;
    }
    return 1.0;
}

// Of one ring, at each column: g, photons per dr d(chi), and Q and U of these, where there are any.
struct Ring {
    std::vector<double> g, photons, q, u;
};

// Photons and their Q and U.
struct Share {
    double photons;
    std::complex<double> linear;
};

class Bins {
public:
    Bins(double from, double to, int count, bool polarised)
        : from_(from),
          width_((to - from) / count),
          photons_(static_cast<std::size_t>(count), 0.0),
          energy_(photons_),
          linear_(polarised ? photons_.size() : 0) {}
    // Light that is distributed about the middle as the sum of two uniform numbers from ranges of these widths, wide >= narrow.
    void add(double middle, double wide, double narrow, const Share& share) {
        const double reach = 0.5 * (wide + narrow), flat = 0.5 * (wide - narrow), energy = middle * share.photons;
        const auto below = [&](double g) {  // the part that is
            const double off = g - middle, side = reach - std::fabs(off);
            if (side <= 0.0) return off > 0.0 ? 1.0 : 0.0;
            if (std::fabs(off) <= flat) return 0.5 + off / wide;
            const double tail = 0.5 * side * side / (wide * narrow);
            return off > 0.0 ? 1.0 - tail : tail;
        };
        if (!(width_ > 0.0)) return;
        const double last = static_cast<double>(photons_.size()) - 1.0,
                     first_bin = std::max(std::floor((middle - reach - from_) / width_), 0.0),
                     last_bin = std::min(std::floor((middle + reach - from_) / width_), last);
        if (!(first_bin <= last_bin)) return;
        double before = below(from_ + first_bin * width_);
        for (std::size_t bin = static_cast<std::size_t>(first_bin); bin <= static_cast<std::size_t>(last_bin); ++bin) {
            const double next = below(from_ + static_cast<double>(bin + 1) * width_);
            photons_[bin] += (next - before) * share.photons, energy_[bin] += (next - before) * energy;
            if (!linear_.empty()) linear_[bin] += (next - before) * share.linear;
            before = next;
        }
    }
    void move_to(LineProfile& profile) {
        profile.photons = std::move(photons_), profile.energy = std::move(energy_);
        profile.linear = std::move(linear_);
    }

private:
    double from_, width_;
    std::vector<double> photons_, energy_;
    std::vector<std::complex<double>> linear_;
};

class Rings {
public:
    Rings(const DistantLight& light, const DiscLine& line) : light_(light), line_(line) {
        isco_ = *innermost_stable_orbit(light.spacetime(), line.sense);
    }
    double isco() const { return isco_; }
    Ring at(const DiscImage& image, double r, double emissivity) const {
        const MatterVelocity u = matter(r);
        const double across2 = light_.spacetime().equator(r)->across2;  // Delta
        const LinePolarisation polarised = line_.polarisation ? line_.polarisation(r) : LinePolarisation();
        Ring ring;
        for (const DiscImage::Point& p : image.ring(r)) {
            const auto [lambda, eta] = light_.constants(p.alpha, p.beta);
            const double g = 1.0 / (u.u_t - lambda * u.u_phi - p.slope * r * r / across2 * u.u_r);
            const double limb =
                line_.limb == Limb::kIsotropic ? 1.0 : limb_of(line_.limb, g * std::sqrt(std::max(eta, 0.0)) / r);
            ring.g.push_back(g), ring.photons.push_back(g * g * g * emissivity * limb * p.area);
            if (!polarised) continue;
            const auto linear = ring.photons.back() * polarised({p.alpha, p.beta, lambda, eta, p.slope});
            ring.q.push_back(linear.real()), ring.u.push_back(linear.imag());
        }
        return ring;
    }

private:
    MatterVelocity matter(double r) const {
        if (r < isco_) return disc_matter(light_.spacetime(), r, line_.sense);
        const CircularOrbit orbit = *circular_orbit(light_.spacetime(), r, line_.sense);
        return {orbit.u_t, 0.0, orbit.u_t * orbit.omega};
    }
    const DistantLight& light_;
    const DiscLine& line_;
    double isco_;
};

// The largest value of sign times what is sampled at equal steps, by the parabola through three neighbours; closed: the last is the first's.
double extreme(const std::vector<double>& values, double sign, bool closed) {
    const std::size_t n = values.size();
    std::size_t at = 0;
    for (std::size_t j = 1; j < n; ++j)
        if (sign * values[j] > sign * values[at]) at = j;
    if (!closed && (at == 0 || at + 1 == n)) return values[at];
    const double before = values[(at + n - 1) % n], after = values[(at + 1) % n],
                 bend = before - 2.0 * values[at] + after, tilt = 0.5 * (after - before);
    return bend == 0.0 ? values[at] : values[at] - 0.5 * tilt * tilt / bend;
}

// Rings at equal steps of y, whose photons are per dy d(chi).
struct Piece {
    std::vector<Ring> rings;
    double step;
};

LineProfile empty_profile(const LineBins& bins, const std::vector<Piece>& pieces) {
    LineProfile profile;
    profile.least_g = INFINITY;
    for (const Piece& piece : pieces) {
        std::vector<double> least, most;
        for (const Ring& ring : piece.rings)
            least.push_back(extreme(ring.g, -1.0, true)), most.push_back(extreme(ring.g, 1.0, true));
        profile.least_g = std::min(profile.least_g, extreme(least, -1.0, false));
        profile.most_g = std::max(profile.most_g, extreme(most, 1.0, false));
    }
    constexpr double kRound = 100.0;
    profile.from = bins.from.value_or(std::floor(profile.least_g * kRound) / kRound);
    profile.to = bins.to.value_or((std::floor(profile.most_g * kRound) + 1.0) / kRound);
    return profile;
}

void count(LineProfile& profile, double g, const Share& share) {
    profile.all_photons += share.photons, profile.all_energy += g * share.photons, profile.all_linear += share.linear;
}

// Of a ring: between neighbouring columns.
void add_ring(Bins& bins, LineProfile& profile, const Ring& ring) {
    const std::size_t n = ring.g.size();
    const double step = 2.0 * M_PI / static_cast<double>(n);
    for (std::size_t j = 0; j < n; ++j) {
        const std::size_t next = (j + 1) % n;
        const double photons = 0.5 * step * (ring.photons[j] + ring.photons[next]),
                     middle = 0.5 * (ring.g[j] + ring.g[next]);
        Share share{photons, {}};
        if (!ring.q.empty())
            share.linear = 0.5 * step * std::complex(ring.q[j] + ring.q[next], ring.u[j] + ring.u[next]);
        bins.add(middle, std::fabs(ring.g[next] - ring.g[j]), 0.0, share);
        count(profile, middle, share);
    }
}

// Means over the cells between rings are those of their corners less a twelfth of the second differences (Euler and Maclaurin), which across
// the first and the last ring are taken to be those next to them.
std::vector<double> flattened(const std::vector<Ring>& rings, std::vector<double> Ring::*of, std::size_t i) {
    const std::size_t row = std::clamp<std::size_t>(i, 1, rings.size() - 2);
    const std::vector<double>&here = rings[i].*of, &in = rings[row - 1].*of, &middle = rings[row].*of,
          &out = rings[row + 1].*of;
    const std::size_t n = here.size();
    std::vector<double> flat(n);
    for (std::size_t j = 0; j < n; ++j) {
        const double round = here[j > 0 ? j - 1 : n - 1] - 2.0 * here[j] + here[j + 1 < n ? j + 1 : 0],
                     outward = in[j] - 2.0 * middle[j] + out[j];
        flat[j] = here[j] - (round + outward) / 12.0;
    }
    return flat;
}

// The means of light, Q and U, and the sum of those at two columns.
class FlatLight {
public:
    FlatLight(const std::vector<Ring>& rings, std::size_t i) : photons_(flattened(rings, &Ring::photons, i)) {
        if (rings[i].q.empty()) return;
        q_ = flattened(rings, &Ring::q, i), u_ = flattened(rings, &Ring::u, i);
    }
    double photons(std::size_t j) const { return photons_[j]; }
    std::complex<double> linear(std::size_t j, std::size_t k) const {
        return q_.empty() ? std::complex<double>() : std::complex(q_[j] + q_[k], u_[j] + u_[k]);
    }

private:
    std::vector<double> photons_, q_, u_;
};

void add_piece(Bins& bins, LineProfile& profile, const Piece& piece) {
    const std::vector<Ring>& rings = piece.rings;
    const std::size_t n = rings[0].g.size();
    const double cell = piece.step * 2.0 * M_PI / static_cast<double>(n);
    std::vector<double> g0 = flattened(rings, &Ring::g, 0);
    FlatLight light0(rings, 0);
    for (std::size_t i = 1; i < rings.size(); ++i) {
        std::vector<double> g1 = flattened(rings, &Ring::g, i);
        FlatLight light1(rings, i);
        const std::vector<double>&a = rings[i - 1].g, &b = rings[i].g;
        for (std::size_t j = 0; j < n; ++j) {
            const std::size_t k = j + 1 < n ? j + 1 : 0;
            const double in0 = light0.photons(j), in1 = light0.photons(k), out0 = light1.photons(j),
                         out1 = light1.photons(k), photons = 0.25 * cell * (in0 + in1 + out0 + out1);
            if (!(photons > 0.0)) continue;
            const double round = 0.5 * (a[k] + b[k] - a[j] - b[j]), outward = 0.5 * (b[j] + b[k] - a[j] - a[k]);
            // More of the light is where the cell is brighter.
            const double brighter_round = in1 + out1 - in0 - out0, brighter_outward = out0 + out1 - in0 - in1,
                         moved = cell * (round * brighter_round + outward * brighter_outward) / (24.0 * photons);
            const double middle = 0.25 * (g0[j] + g0[k] + g1[j] + g1[k]) + moved;
            const double wide = std::fabs(round), deep = std::fabs(outward);
            const Share share{photons, 0.25 * cell * (light0.linear(j, k) + light1.linear(j, k))};
            bins.add(middle, std::max(wide, deep), std::min(wide, deep), share);
            count(profile, middle, share);
        }
        g0 = std::move(g1), light0 = std::move(light1);
    }
}

Piece piece_of(const DistantLight& light, const Rings& rings, const DiscLine& line, double inner, double outer,
               const LineCells& cells) {
    const DiscImage image(light, inner, outer, {cells.radii, cells.angles, cells.columns});
    const double horizon = light.horizon(), first = std::log(inner - horizon),
                 step = (std::log(outer - horizon) - first) / cells.rows;
    std::vector<double> radii{inner};
    for (int i = 1; i < cells.rows; ++i) radii.push_back(horizon + std::exp(first + step * i));
    radii.push_back(outer);
    const std::vector<double> emissivity = line.emissivity(radii);
    Piece piece{{}, step};
    for (std::size_t i = 0; i < radii.size(); ++i)
        piece.rings.push_back(rings.at(image, radii[i], emissivity[i] * (radii[i] - horizon)));
    return piece;
}

LineProfile profile_of_ring(const DistantLight& light, const Rings& rings, const DiscLine& line, const LineBins& bins,
                            const LineCells& cells) {
    const double r = line.inner, width = kRingWidth * (r - light.horizon());
    const DiscImage image(light, r - width, r + width, {kRingRadii, cells.angles, kRingColumns * cells.columns});
    const std::vector<Piece> ring{{{rings.at(image, r, line.emissivity({r})[0])}, 0.0}};
    LineProfile profile = empty_profile(bins, ring);
    Bins filled(profile.from, profile.to, bins.count, static_cast<bool>(line.polarisation));
    add_ring(filled, profile, ring[0].rings[0]);
    filled.move_to(profile);
    return profile;
}

// Of the pieces: where the emissivity and the matter's motion are smooth between them.
std::vector<double> rims_of(const DiscLine& line, double isco) {
    constexpr double kThinnest = 1e-3;  // of a radius; thinner pieces are left to their neighbour
    std::vector<double> within = line.kinks, rims{line.inner};
    within.push_back(isco);
    std::ranges::sort(within);
    for (const double r : within)
        if (r > (1.0 + kThinnest) * rims.back() && (1.0 + kThinnest) * r < line.outer) rims.push_back(r);
    rims.push_back(line.outer);
    return rims;
}

}  // namespace

LineProfile line_profile(const DistantLight& light, const DiscLine& line, const LineBins& bins,
                         const LineCells& cells) {
    const Rings rings(light, line);
    if (line.inner == line.outer) return profile_of_ring(light, rings, line, bins, cells);
    std::vector<Piece> pieces;
    const std::vector<double> rims = rims_of(line, rings.isco());
    for (std::size_t i = 1; i < rims.size(); ++i)
        pieces.push_back(piece_of(light, rings, line, rims[i - 1], rims[i], cells));
    LineProfile profile = empty_profile(bins, pieces);
    Bins filled(profile.from, profile.to, bins.count, static_cast<bool>(line.polarisation));
    for (const Piece& piece : pieces) add_piece(filled, profile, piece);
    filled.move_to(profile);
    return profile;
}

double profile_change(const LineProfile& a, const LineProfile& b) {
    double most = 0.0, change = 0.0;
    for (std::size_t i = 0; i < a.photons.size(); ++i) {
        most = std::max(most, b.share(i));
        change = std::max(change, std::fabs(a.share(i) - b.share(i)));
    }
    return most > 0.0 ? change / most : 0.0;
}

ConvergedProfile converged_profile(const DistantLight& light, const DiscLine& line, const LineBins& bins) {
    LineProfile last = line_profile(light, line, bins, LineCells(0));
    LineBins same = bins;
    for (int level = 1;; ++level) {
        same.from = last.from, same.to = last.to;
        LineProfile next = line_profile(light, line, same, LineCells(level));
        const double change = profile_change(last, next);
        if (change <= kConverged || level == kFinest) return {std::move(next), change};
        last = std::move(next);
    }
}

}  // namespace nullscope
