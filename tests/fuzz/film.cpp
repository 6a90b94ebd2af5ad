// Films that are marked as films of the sphere.
#include <sstream>

#include "fuzz.h"
#include "image/sphere_film.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const FilmSphere sphere{FilmEyes::kLeftAbove, 0.0, 0.125, 0.25, 0.5};
    std::istringstream film{std::string(fuzz::text_of(data, size))};
    std::ostringstream marked, again;
    const Status done = copy_with_sphere(film, sphere, marked);
    if (!done) {
        Error error = done.error();  // of what ffmpeg wrote, not of an input
        error.kind = ErrorKind::kBadInput;
        fuzz::must_be_a_good_error(error);
        return 0;
    }
    fuzz::must(marked.str().size() > size && marked.str().size() < size + 200, "a film grows by its boxes");
    std::istringstream once{marked.str()};
    fuzz::must(!copy_with_sphere(once, sphere, again), "a film is marked once");
    return 0;
}
