// Matter of a file: density, temperature, magnetic field and motion at the nodes of a grid about a hole, as a simulation gives them.
//
// The file begins with these lines, in this order:
//     nullscope-medium 1
//     coordinates kerr-schild        or boyer-lindquist: whose azimuth phi is
//     spin A                         of the hole, over its mass; [-1, 1]
//     r FIRST LAST COUNT             nodes at equal steps of ln r; r_s
//     theta FIRST LAST COUNT         nodes at equal steps of the polar angle; rad
//     phi FIRST COUNT                nodes all round, at equal steps of the azimuth; rad
//     converter TEXT                 the command that made the file   } may be left out
//     source TEXT                    what it was made from            }
//     data
// Then follow eight numbers of each node, 32-bit floats with the lowest byte first: phi changes fastest, then theta, then r, as of an array
// of shape (r, theta, phi, 8).
//   0     density: electrons per cm^3 for synchrotron radiation, else over that of emissivity or opacity; 0 counts as kLeastDensity
//   1     temperature, K; of synchrotron radiation the electrons'; 0 counts as kLeastDensity
//   2-4   magnetic field in the frame of the matter, along r, theta, phi, G
//   5-7   four-velocity along e_r, e_theta, e_phi of the zero-angular-momentum observer (ZAMO): gamma v, c
// The frame of the matter is that observer's, boosted without a rotation.
//
// Between nodes matter is linear in ln r, theta and phi: logarithms of density and temperature, the field's and the velocity's parts, of which
// that along e_r is multiplied by fall(r), since that of matter that falls in grows as 1/sqrt(r - horizon).
// Beyond the first and last nodes of r and theta it is as there, the velocity along e_r but for fall(r).
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace nullscope {

class MediumGrid {
public:
    static constexpr int kNumbers = 8, kMostRings = 1024, kMostSide = 2048, kMostAround = 256, kMostNodes = 1 << 24;
    static constexpr double kLeastDensity = 1e-30, kDensest = 1e30, kHottest_K = 1e14, kStrongest_G = 1e9,
                            kLeastFall = 1e-3, kFastest = 1e3;

    struct Axis {
        double first = 0, step = 0;  // of ln r; rad
        int count = 1;
    };

    // name: of the file, for messages. Errors: what is no such file, with its line or node.
    static Result<MediumGrid> parse(std::string_view bytes, const std::string& name);
    // A file, ring by ring: it is never in memory as a whole, beside its numbers.
    static Result<MediumGrid> read(const std::filesystem::path& file);
    // What stands before the numbers, of which there are none; bytes: at least all of that. file_size: of the whole file.
    static Result<MediumGrid> parse_head(std::string_view bytes, const std::string& name, std::size_t file_size);
    static constexpr std::size_t kMostHead = 1u << 12;
    // Numbers on the straight line from those of `a`, part 0, to those of `b`, part 1, which has the same nodes.
    static MediumGrid between(const MediumGrid& a, const MediumGrid& b, double part);
    MediumGrid without_numbers() const;
    // What differs, but for numbers, notes and roundings: "spin", "nodes of theta", ...; nullptr: nothing.
    const char* other_nodes(const MediumGrid& than) const;

    double spin() const { return spin_; }
    bool kerr_schild() const { return kerr_schild_; }
    const std::string& converter() const { return converter_; }  // empty: the file does not say
    const std::string& source() const { return source_; }
    double nearest() const;  // r of the first node and of the last one, r_s
    double farthest() const;
    double horizon() const;       // of a hole of this spin, r_s
    double fall(double r) const;  // sqrt(1 - horizon/r), but no less than sqrt(kLeastFall)
    const Axis& rings() const { return rings_; }
    const Axis& polar() const { return polar_; }
    const Axis& around() const { return around_; }
    // Eight numbers of each node, r changes fastest, then theta: log2 of the density, velocity as said above; log2 of the temperature, field.
    const std::vector<float>& numbers() const { return numbers_; }
    std::size_t nodes() const;
    std::size_t bytes() const { return sizeof(float) * kNumbers * nodes(); }  // of all numbers
    const float* node(int ring, int polar, int around) const;

private:
    class Head;
    Status read_head(Head& head);
    Status check_size(const Head& head, std::size_t follow) const;  // of what follows the head
    Status read_ring(std::size_t ring, const char* bytes, const Head& head);
    bool kerr_schild_ = true;
    double spin_ = 0;
    std::string converter_, source_;
    Axis rings_, polar_, around_;
    std::vector<float> numbers_;
};

// The grid of a file, read once, and again when the file has changed; the last two are kept. Thread-safe.
Result<std::shared_ptr<const MediumGrid>> load_medium_grid(const std::filesystem::path& file);

}  // namespace nullscope
