// What is drawn, and where: whole framebuffers, rows, tiles, points, marked pixels.
#include <glad/gl.h>

#include "gl/gl.h"

namespace nullscope::gl {
namespace {

// What every draw begins with: neither blending nor depth, marks nor scissors.
void begin_draw(const Program& program, const VertexArray& vertices, unsigned framebuffer, int x, int y, int width,
                int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(x, y, width, height);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(program.id());
    glBindVertexArray(vertices.id());
}

void limit_to_rows(int width, int first, int last) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, first, width, last - first);
}

void begin_layer(const Layer& layer) {
    if (layer.share < 1.0) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_CONSTANT_ALPHA, layer.replaces ? GL_ZERO : GL_ONE);
        glBlendColor(0, 0, 0, static_cast<float>(layer.share));
    }
    if (layer.marked != Marked::kAny) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_EQUAL, layer.marked == Marked::kOnly ? 1 : 0, 0xff);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }
}

void end_draw(const char* where) {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_BLEND);
    check(where);
}

}  // namespace

void draw_fullscreen(const Program& program, const VertexArray& empty, unsigned framebuffer, int width, int height,
                     double share) {
    begin_draw(program, empty, framebuffer, 0, 0, width, height);
    if (share < 1.0) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
        glBlendColor(0, 0, 0, static_cast<float>(share));
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
    end_draw("draw");
}

void draw_rows(const Program& program, const VertexArray& empty, unsigned framebuffer, int width, int height, int first,
               int last, const Layer& layer) {
    begin_draw(program, empty, framebuffer, 0, 0, width, height);
    begin_layer(layer);
    limit_to_rows(width, first, last);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    end_draw("draw rows");
}

namespace {
template <class Draw>
void draw_points_of_tiles(const Program& program, const VertexArray& empty, unsigned framebuffer, int width, int height,
                          int side, int first, int last, const Layer& layer, Draw draw) {
    const int across = (width + side - 1) / side, up = (height + side - 1) / side;
    begin_draw(program, empty, framebuffer, 0, 0, across * side,
               up * side);  // a point whose middle is outside is left out
    begin_layer(layer);
    glEnable(GL_PROGRAM_POINT_SIZE);
    limit_to_rows(width, first, last);
    draw(across);
    end_draw("draw tiles");
}
}  // namespace

void draw_tiles(const Program& program, const VertexArray& empty, unsigned framebuffer, int width, int height, int side,
                int first, int last, const Layer& layer) {
    draw_points_of_tiles(program, empty, framebuffer, width, height, side, first, last, layer, [&](int across) {
        const int from = first / side, to = (last + side - 1) / side;
        glDrawArrays(GL_POINTS, from * across, (to - from) * across);
    });
}

void draw_listed_points(const Program& program, const VertexList& vertices, unsigned framebuffer, int width, int height,
                        const Layer& layer) {
    begin_draw(program, vertices.layout, framebuffer, 0, 0, width, height);
    begin_layer(layer);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glDrawArrays(GL_POINTS, 0, vertices.count);
    end_draw("draw listed points");
}

void draw_points(const Program& program, const VertexList& vertices, int count, int copies, unsigned framebuffer,
                 int width, int height, int margin) {
    begin_draw(program, vertices.layout, framebuffer, -margin, -margin, width + 2 * margin, height + 2 * margin);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
    glDrawArraysInstanced(GL_POINTS, 0, count, copies);
    end_draw("draw points");
}

Marks make_marks(const Target& target) {
    Marks marks;
    marks.width = target.width, marks.height = target.height, marks.of = target.framebuffer.id();
    unsigned id = 0;
    glGenTextures(1, &id);
    marks.seen = Texture(id);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, id);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, target.width, target.height, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    glGenRenderbuffers(1, &id);
    marks.stencil = Renderbuffer(id);
    glBindRenderbuffer(GL_RENDERBUFFER, id);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, target.width, target.height);
    glGenFramebuffers(1, &id);
    marks.framebuffer = Framebuffer(id);
    for (const unsigned framebuffer : {target.framebuffer.id(), id}) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, marks.stencil.id());
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, marks.seen.id(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        fail("the driver cannot mark the pixels of a target of this size");
    check("marks");
    return marks;
}

void clear_marks(const Marks& marks) {
    glBindFramebuffer(GL_FRAMEBUFFER, marks.framebuffer.id());
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 0);
    glClearStencil(0);
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void mark_rows(const Program& program, const VertexArray& empty, const Marks& marks, int first, int last,
               unsigned char* seen) {
    begin_draw(program, empty, marks.framebuffer.id(), 0, 0, marks.width, marks.height);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    limit_to_rows(marks.width, first, last);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    end_draw("mark rows");
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, first, marks.width, last - first, GL_RED, GL_UNSIGNED_BYTE, seen);
    check("read marks");
}

}  // namespace nullscope::gl
