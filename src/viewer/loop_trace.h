// The light of a small picture through an orbit, a point at a time, by the painter's thread (studio/loop_watch.h).
#pragma once
#include <memory>
#include <optional>

#include "render/renderer.h"
#include "studio/loop_watch.h"

namespace nullscope::viewer {

// All of it belongs to the thread whose context it is.
class LoopTrace {
public:
    void begin(std::optional<LoopOrder> order);  // nothing: ends, and frees what it kept
    bool runs() const { return order_.has_value(); }
    const StokesLoop& step();  // one more point, some 20 ms with llvmpipe; the first compiles. While it runs

private:
    std::unique_ptr<Renderer> renderer_;  // its programs serve the next order, too
    std::optional<LoopOrder> order_;
    StokesLoop loop_;
};

}  // namespace nullscope::viewer
