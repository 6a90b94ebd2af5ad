// What observers measure of the picture's polarisation, for the panel "Numbers": measured at rest, on a small copy of the picture.
#pragma once
#include <optional>
#include <vector>

#include "compare/rotation_measure.h"
#include "compare/stokes_measures.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace nullscope::viewer {

struct PolarisationNumbers {
    StokesMeasures measures;                 // at the frequency that is shown, or the lowest
    std::vector<RotationMeasure> rotations;  // of matter at several frequencies
};

bool has_polarisation_numbers(const Scene& scene);  // polarised light in one picture

// Of the scene's view in at most 320 x 320 px, by the renderer's method; nothing if the scene cannot be prepared, as the picture says.
// Cost: two of these pictures, and for several frequencies two more for each.
std::optional<PolarisationNumbers> polarisation_numbers(Renderer& renderer, const Scene& scene);

// When they are measured: once for each whole picture that is looked at.
class PolarisationWatch {
public:
    // number: of the picture on the screen. True once for each: measure it.
    bool asks(int number) {
        if (asked_ == number) return false;
        asked_ = number;
        return true;
    }
    void take(std::optional<PolarisationNumbers> numbers) { numbers_ = std::move(numbers), taken_ = asked_; }
    void forget() { *this = {}; }
    bool waits() const { return taken_ != asked_; }
    // Until the next ones come, those of the picture before; nullptr: there are none.
    const PolarisationNumbers* numbers() const { return numbers_ ? &*numbers_ : nullptr; }

private:
    std::optional<PolarisationNumbers> numbers_;
    int asked_ = 0, taken_ = 0;
};

}  // namespace nullscope::viewer
