// The shader core as C++ reads nothing outside of its tables. In a shader such a fetch gives some value that is not used;
// in C++ it reads what lies there. The tables end where memory that must not be read begins.
#include <doctest/doctest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "render/frame_tables.h"

using namespace nullscope;

namespace {

// A copy of a table that ends at a page which cannot be read.
class Guarded {
public:
    explicit Guarded(TexelView view) : view_(view) {
        const std::size_t page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
        const std::size_t size = static_cast<std::size_t>(view.width) * view.height * 4 * sizeof(float);
        const std::size_t before = (size + page - 1) / page * page;
        bytes_ = before + kForbidden;
        memory_ = ::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        REQUIRE(memory_ != MAP_FAILED);
        char* const end = static_cast<char*>(memory_) + before;
        REQUIRE(::mprotect(end, kForbidden, PROT_NONE) == 0);
        view_.data = reinterpret_cast<const float*>(std::memcpy(end - size, view.data, size));
    }
    ~Guarded() { ::munmap(memory_, bytes_); }
    Guarded(const Guarded&) = delete;
    Guarded& operator=(const Guarded&) = delete;
    TexelView view() const { return view_; }

private:
    static constexpr std::size_t kForbidden = 64u << 20;  // further than any cell of a table
    TexelView view_;
    void* memory_ = nullptr;
    std::size_t bytes_ = 0;
};

}  // namespace

TEST_CASE("bounds: no ray reads outside of strip and ends, near the hole and far away") {
    int captured = 0;
    for (const double r : {1.0001, 1.1, 1.5, 3.0, 10.0, 1000.0}) {
        CAPTURE(r);
        Scene scene;
        scene.sky.kind = SkyKind::kBlack;
        scene.camera.r = r;
        scene.camera.width = scene.camera.height = 65;
        scene.camera.plane_width = 20.0;
        for (const double yaw : {0.0, M_PI}) {
            scene.camera.yaw = yaw;
            FrameTables tables;
            REQUIRE(tables.update(scene));
            CoreInput input = tables.core_input();
            const Guarded strip(input.strip), ends(input.ends);
            input.strip = strip.view();
            input.ends = ends.view();
            for (int y = -32; y <= 32; ++y)
                for (int x = -32; x <= 32; ++x) {
                    captured += trace_core64(input, x, y).fate == Fate::kCaptured;
                    captured += trace_core32(input, x, y).fate == Fate::kCaptured;
                }
        }
    }
    CHECK(captured > 1000);
}
