#include "gl/pixel_read.h"

#include <glad/gl.h>

namespace nullscope::gl {
namespace {

constexpr GLuint64 kLongestWait_ns = 1'000'000'000;  // then it asks again

Buffer make_pixel_buffer(GLsizeiptr bytes) {
    GLuint id = 0;
    glGenBuffers(1, &id);
    Buffer buffer(id);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, id);
    glBufferData(GL_PIXEL_PACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    return buffer;
}

}  // namespace

PixelRead::PixelRead(const Target& target)
    : width_(target.width),
      height_(target.height),
      buffer_(make_pixel_buffer(GLsizeiptr{4} * target.width * target.height)) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.id());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
    check("begin to read pixels");
}

PixelRead::~PixelRead() { glDeleteSync(static_cast<GLsync>(fence_)); }

void PixelRead::take(const std::function<void(const unsigned char* rgba)>& use) {
    while (glClientWaitSync(static_cast<GLsync>(fence_), GL_SYNC_FLUSH_COMMANDS_BIT, kLongestWait_ns) ==
           GL_TIMEOUT_EXPIRED) {
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
    const void* bytes = glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, GLsizeiptr{4} * width_ * height_, GL_MAP_READ_BIT);
    if (bytes != nullptr) {
        use(static_cast<const unsigned char*>(bytes));
        glUnmapBuffer(GL_PIXEL_PACK_BUFFER);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    check("read pixels");
    if (bytes == nullptr) fail("read pixels: the driver does not hand them over");
}

}  // namespace nullscope::gl
