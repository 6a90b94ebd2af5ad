// A target's bytes on their way to the processor, while both do other work: a pixel buffer, and a fence that says when they are there.
#pragma once
#include <functional>

#include "gl/gl.h"

namespace nullscope::gl {

class PixelRead {
public:
    // RGBA8 of all of the target, as it is now: what is drawn to it later, or its end, changes nothing. Returns at once.
    explicit PixelRead(const Target& target);
    ~PixelRead();
    PixelRead(const PixelRead&) = delete;
    PixelRead& operator=(const PixelRead&) = delete;

    int width() const { return width_; }
    int height() const { return height_; }
    // Waits for the bytes, rows from the bottom, and hands them over; once. In the context that has begun it.
    void take(const std::function<void(const unsigned char* rgba)>& use);

private:
    int width_, height_;
    Buffer buffer_;
    void* fence_;  // GLsync
};

}  // namespace nullscope::gl
