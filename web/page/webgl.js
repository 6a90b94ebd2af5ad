// The functions of OpenGL ES 3.0 that src/gl calls, by WebGL2. Objects have numbers, as there; 0 is none.

// What OpenGL has and WebGL2 names otherwise or not at all.
const INFO_LOG_LENGTH = 0x8b84, COMPLETION_STATUS = 0x91b1, PROGRAM_POINT_SIZE = 0x8642, CONTEXT_LOST = 0x0507;

// gl: a WebGL2 context. module(): the module that calls, for its memory and for strings.
export function glFunctions(gl, module) {
  const objects = new Map(), uniforms = [];
  let parallel = gl.getExtension("KHR_parallel_shader_compile");
  let last = 0;
  const strings = new Map();

  const put = (object) => (objects.set(++last, object), last);
  const at = (id) => (id === 0 ? null : objects.get(id) ?? null);
  const memory = () => module().exports.memory.buffer;
  const ints = (place, count) => new Int32Array(memory(), place, count);
  const text = (place) => {
    const bytes = module().bytes;
    return module().text(place, bytes.indexOf(0, place) - place);
  };
  // The memory behind a place, as texImage2D and readPixels want it for a type of texels.
  const texels = (type, place) => {
    if (place === 0) return null;
    if (type === gl.FLOAT) return new Float32Array(memory(), place);
    if (type === gl.HALF_FLOAT) return new Uint16Array(memory(), place);
    if (type === gl.UNSIGNED_BYTE) return new Uint8Array(memory(), place);
    return new Uint32Array(memory(), place);
  };
  const make = (create) => (count, ids) => {
    const to = ints(ids, count);
    for (let i = 0; i < count; ++i) to[i] = put(create());
  };
  const remove = (destroy) => (count, ids) => {
    for (const id of ints(ids, count)) {
      if (id !== 0) destroy(at(id));
      objects.delete(id);
    }
  };
  const copyText = (log, most, length, place) => {
    const bytes = new TextEncoder().encode(log).slice(0, Math.max(most - 1, 0));
    module().bytes.set(bytes, place);
    module().bytes[place + bytes.length] = 0;
    if (length !== 0) ints(length, 1)[0] = bytes.length;
  };
  const size = (log) => new TextEncoder().encode(log ?? "").length + 1;

  return {
    // After a lost context: what is deleted later was of the old one, and so were its extensions.
    forget: () => {
      objects.clear();
      parallel = gl.getExtension("KHR_parallel_shader_compile");
    },
    glActiveTexture: (unit) => gl.activeTexture(unit),
    glAttachShader: (program, shader) => gl.attachShader(at(program), at(shader)),
    glBindBuffer: (target, id) => gl.bindBuffer(target, at(id)),
    glBindBufferBase: (target, index, id) => gl.bindBufferBase(target, index, at(id)),
    glBindFramebuffer: (target, id) => gl.bindFramebuffer(target, at(id)),
    glBindRenderbuffer: (target, id) => gl.bindRenderbuffer(target, at(id)),
    glBindTexture: (target, id) => gl.bindTexture(target, at(id)),
    glBindVertexArray: (id) => gl.bindVertexArray(at(id)),
    glBlendColor: (r, g, b, a) => gl.blendColor(r, g, b, a),
    glBlendFunc: (from, to) => gl.blendFunc(from, to),
    glBlendFuncSeparate: (a, b, c, d) => gl.blendFuncSeparate(a, b, c, d),
    glBlitFramebuffer: (...places) => gl.blitFramebuffer(...places),
    glBufferData: (target, bytes, place, use) =>
      place === 0
        ? gl.bufferData(target, bytes, use)
        : gl.bufferData(target, new Uint8Array(memory(), place, bytes), use),
    glCheckFramebufferStatus: (target) => gl.checkFramebufferStatus(target),
    glClear: (mask) => gl.clear(mask),
    glClearColor: (r, g, b, a) => gl.clearColor(r, g, b, a),
    glClearStencil: (value) => gl.clearStencil(value),
    glCompileShader: (id) => gl.compileShader(at(id)),
    glCreateProgram: () => put(gl.createProgram()),
    glCreateShader: (kind) => put(gl.createShader(kind)),
    glDeleteBuffers: remove((buffer) => gl.deleteBuffer(buffer)),
    glDeleteFramebuffers: remove((framebuffer) => gl.deleteFramebuffer(framebuffer)),
    glDeleteProgram: (id) => (gl.deleteProgram(at(id)), objects.delete(id)),
    glDeleteQueries: () => {},
    glDeleteRenderbuffers: remove((renderbuffer) => gl.deleteRenderbuffer(renderbuffer)),
    glDeleteShader: (id) => (gl.deleteShader(at(id)), objects.delete(id)),
    glDeleteTextures: remove((texture) => gl.deleteTexture(texture)),
    glDeleteVertexArrays: remove((vertices) => gl.deleteVertexArray(vertices)),
    // Points always have a size of their own here.
    glDisable: (what) => what !== PROGRAM_POINT_SIZE && gl.disable(what),
    glEnable: (what) => what !== PROGRAM_POINT_SIZE && gl.enable(what),
    glDrawArrays: (mode, first, count) => gl.drawArrays(mode, first, count),
    glDrawArraysInstanced: (mode, first, count, copies) => gl.drawArraysInstanced(mode, first, count, copies),
    glDrawBuffers: (count, list) => gl.drawBuffers([...ints(list, count)]),
    glDrawElements: (mode, count, type, offset) => gl.drawElements(mode, count, type, offset),
    glEnableVertexAttribArray: (index) => gl.enableVertexAttribArray(index),
    glFinish: () => gl.finish(),
    glFlush: () => gl.flush(),
    glFramebufferRenderbuffer: (target, place, kind, id) => gl.framebufferRenderbuffer(target, place, kind, at(id)),
    glFramebufferTexture2D: (target, place, kind, id, level) =>
      gl.framebufferTexture2D(target, place, kind, at(id), level),
    glGenBuffers: make(() => gl.createBuffer()),
    glGenFramebuffers: make(() => gl.createFramebuffer()),
    glGenQueries: make(() => null),
    glGenRenderbuffers: make(() => gl.createRenderbuffer()),
    glGenTextures: make(() => gl.createTexture()),
    glGenVertexArrays: make(() => gl.createVertexArray()),
    glGenerateMipmap: (target) => gl.generateMipmap(target),
    glGetError: () => (gl.isContextLost() ? CONTEXT_LOST : gl.getError()),
    glGetIntegerv: (name, place) => (ints(place, 1)[0] = gl.getParameter(name)),
    glGetProgramInfoLog: (id, most, length, place) => copyText(gl.getProgramInfoLog(at(id)) ?? "", most, length, place),
    glGetProgramiv: (id, name, place) => {
      let value;
      if (name === INFO_LOG_LENGTH) value = size(gl.getProgramInfoLog(at(id)));
      else if (name === COMPLETION_STATUS && !parallel) value = true;
      else value = gl.getProgramParameter(at(id), name);
      ints(place, 1)[0] = Number(value);
    },
    glGetShaderInfoLog: (id, most, length, place) => copyText(gl.getShaderInfoLog(at(id)) ?? "", most, length, place),
    glGetShaderiv: (id, name, place) =>
      (ints(place, 1)[0] =
        name === INFO_LOG_LENGTH ? size(gl.getShaderInfoLog(at(id))) : Number(gl.getShaderParameter(at(id), name))),
    glGetString: (name) => {
      if (!strings.has(name)) {
        const bytes = new TextEncoder().encode(`${deviceString(gl, name)}\0`);
        const place = module().exports.allocate(bytes.length);
        module().bytes.set(bytes, place);
        strings.set(name, place);
      }
      return strings.get(name);
    },
    glGetUniformBlockIndex: (id, name) => gl.getUniformBlockIndex(at(id), text(name)),
    glGetUniformLocation: (id, name) => {
      const location = gl.getUniformLocation(at(id), text(name));
      return location === null ? -1 : uniforms.push(location) - 1;
    },
    glLinkProgram: (id) => gl.linkProgram(at(id)),
    glPixelStorei: (name, value) => gl.pixelStorei(name, value),
    glReadBuffer: (which) => gl.readBuffer(which),
    // Of one channel WebGL promises nothing but all four.
    glReadPixels: (x, y, width, height, format, type, place) => {
      if (format !== gl.RED) {
        gl.readPixels(x, y, width, height, format, type, texels(type, place));
        return;
      }
      const all = new Uint8Array(4 * width * height), to = new Uint8Array(memory(), place, width * height);
      gl.readPixels(x, y, width, height, gl.RGBA, type, all);
      for (let i = 0; i < to.length; ++i) to[i] = all[4 * i];
    },
    glRenderbufferStorage: (target, format, width, height) => gl.renderbufferStorage(target, format, width, height),
    glScissor: (x, y, width, height) => gl.scissor(x, y, width, height),
    glShaderSource: (id, count, places, sizes) => gl.shaderSource(at(id), text(ints(places, 1)[0])),
    glStencilFunc: (what, value, mask) => gl.stencilFunc(what, value, mask),
    glStencilOp: (a, b, c) => gl.stencilOp(a, b, c),
    glTexImage2D: (target, level, stored, width, height, border, format, type, place) =>
      gl.texImage2D(target, level, stored, width, height, border, format, type, texels(type, place)),
    glTexImage3D: (target, level, stored, width, height, depth, border, format, type, place) =>
      gl.texImage3D(target, level, stored, width, height, depth, border, format, type, texels(type, place)),
    glTexParameteri: (target, name, value) => gl.texParameteri(target, name, value),
    glTexSubImage2D: (target, level, x, y, width, height, format, type, place) =>
      gl.texSubImage2D(target, level, x, y, width, height, format, type, texels(type, place)),
    glTexSubImage3D: (target, level, x, y, z, width, height, depth, format, type, place) =>
      gl.texSubImage3D(target, level, x, y, z, width, height, depth, format, type, texels(type, place)),
    glUniform1i: (location, value) => location >= 0 && gl.uniform1i(uniforms[location], value),
    glUniformBlockBinding: (id, index, binding) => gl.uniformBlockBinding(at(id), index, binding),
    glUseProgram: (id) => gl.useProgram(at(id)),
    glVertexAttribPointer: (index, count, type, normalized, stride, offset) =>
      gl.vertexAttribPointer(index, count, type, Boolean(normalized), stride, offset),
    glViewport: (x, y, width, height) => gl.viewport(x, y, width, height),
  };
}

// "ANGLE (Qualcomm, Adreno 740, ...)", where the browser tells.
export function deviceString(gl, name = gl.RENDERER) {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  if (info && name === gl.RENDERER) return gl.getParameter(info.UNMASKED_RENDERER_WEBGL);
  if (info && name === gl.VENDOR) return gl.getParameter(info.UNMASKED_VENDOR_WEBGL);
  return gl.getParameter(name);
}
