// OSMesa: Mesa's software rasteriser without any window system. It left Mesa in 25.1, so it is opened where it is there.
#include <array>
#include <utility>
#include <vector>

#include "context/context.h"
#include "platform/library.h"

namespace nullscope {
namespace {

// The part of OSMesa that is used here (Mesa's GL/osmesa.h): names, values and signatures are Mesa's.
constexpr int kFormat = 0x22, kRgba = 0x1908, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kOsmesaMajor = 0x36, kOsmesaMinor = 0x37;
constexpr unsigned kUnsignedByte = 0x1401;

struct Osmesa {
    void* (*create)(const int*, void*) = nullptr;
    void (*destroy)(void*) = nullptr;
    unsigned char (*make_current)(void*, void*, unsigned, int, int) = nullptr;
    GlProc (*get_proc_address)(const char*) = nullptr;
};

const Osmesa* osmesa() {
    static Osmesa o;
    static const bool ok = [] {
        void* library = platform::open_library({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
        return library != nullptr && platform::load_symbol(library, "OSMesaCreateContextAttribs", o.create) &&
               platform::load_symbol(library, "OSMesaDestroyContext", o.destroy) &&
               platform::load_symbol(library, "OSMesaMakeCurrent", o.make_current) &&
               platform::load_symbol(library, "OSMesaGetProcAddress", o.get_proc_address);
    }();
    return ok ? &o : nullptr;
}

class OsmesaContext final : public GlContext {
public:
    explicit OsmesaContext(void* context) : context_(context) {}
    ~OsmesaContext() override { osmesa()->destroy(context_); }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;
    bool make_current() { return osmesa()->make_current(context_, pixels_.data(), kUnsignedByte, kSide, kSide) != 0; }
    GlProc get_proc_address(const char* name) const override { return osmesa()->get_proc_address(name); }
    std::string kind() const override { return "osmesa"; }

private:
    static constexpr int kSide = 16;  // of its own buffer, which nothing draws to
    void* context_;
    std::vector<unsigned char> pixels_ = std::vector<unsigned char>(4 * kSide * kSide);
};

}  // namespace

bool has_osmesa() { return osmesa() != nullptr; }

Result<std::unique_ptr<GlContext>> make_osmesa_context() {
    if (osmesa() == nullptr)
        return failed(
            "OSMesa: libOSMesa is not installed (Debian 12, 13, Ubuntu 24.04: apt install libosmesa6; it left Mesa in "
            "25.1)");
    const std::array<int, 12> attributes = {kFormat,      kRgba, kDepthBits,   0, kProfile, kCoreProfile,
                                            kOsmesaMajor, 3,     kOsmesaMinor, 3, 0,        0};
    void* context = osmesa()->create(attributes.data(), nullptr);
    if (context == nullptr) return failed("OSMesa: it gives no OpenGL 3.3 core context");
    auto result = std::make_unique<OsmesaContext>(context);
    if (!result->make_current()) return failed("OSMesa: the context cannot be made current");
    return std::unique_ptr<GlContext>(std::move(result));
}

}  // namespace nullscope
