// The engine: core.wasm, a WebGL2 context and the loop that draws when there is something to draw. It runs in a worker where the browser lets
// one draw (worker.js), else in the page; it knows nothing of the page's controls.

import { Failure, Module, fetched } from "./module.js";
import { deviceString, glFunctions } from "./webgl.js";

const LEAST_SCALE = 0.25;      // of the canvas's pixels in each direction, in motion
const FIRST_PIXELS = 640 * 360; // of the first picture at most: a slow GPU shows it soon, too
const SLOW_MS = 28, FAST_MS = 11; // a frame in motion: longer makes pixels larger, shorter smaller
const STRETCH_MS = 30;         // of work; then messages, hands and the page have their turn
const REST_MS = 250;           // without a hand: then the picture is drawn with all its pixels
const ADAPTATION_S = 0.3;      // of automatic exposure
const SHIPPED = "/assets/";    // paths of files that ship, as core.wasm names them
const LOST = "the graphics device is gone for a moment";

export class Engine {
  // say(event, values): "telescope" (what was found, null where the picture is dark, or { refusal }), "drawn", "ticks" (to be drawn over it, or null: none any more), "rest" (the picture has all its pixels and rays, and nothing
  // moves), "lost", "restored", "failed"
  constructor(say) {
    this.say = say;
    this.hand = { right: 0, up: 0, backward: 0, roll: 0 };
    this.clock = 0;
    this.scale = 1;
    this.size = { width: 0, height: 0 };
    this.fixed = false;
    this.stretch = STRETCH_MS;
    this.due = false;
    this.touched = -Infinity;
    this.fetching = new Map();
    this.absent = new Set();
    this.lives = 0;      // of contexts: how many were lost
    this.waiting = [];   // for the picture that is drawn next: { done, fail }
  }

  // canvas: HTMLCanvasElement or OffscreenCanvas. base: URL of the folder that has core.wasm and assets/.
  async start(canvas, base, width, height) {
    this.canvas = canvas;
    this.base = base;
    this.resize(width, height);
    canvas.width = width;
    canvas.height = height;
    const gl = canvas.getContext("webgl2", {
      alpha: false, antialias: false, depth: false, stencil: false, preserveDrawingBuffer: true,
      powerPreference: "high-performance",
    });
    if (!gl) throw new Failure("this browser has no WebGL2");
    this.gl = gl;
    this.limits = this.#extensions();
    canvas.addEventListener("webglcontextlost", (event) => this.#lost(event));
    canvas.addEventListener("webglcontextrestored", () => this.#restored());
    this.functions = glFunctions(gl, () => this.core);
    const imports = { env: this.functions };
    const [core, scenes] = await Promise.all([
      Module.load(new URL("core.wasm", base), imports),
      fetched(new URL("assets/scenes.json", base)).then((bytes) => JSON.parse(new TextDecoder().decode(bytes))),
    ]);
    this.core = core;
    for (const [path, text] of Object.entries(scenes)) core.call("put_file", SHIPPED + path, text);
    core.exports.start_view(this.limits.floats, this.limits.filtered);
    return { device: deviceString(gl), ...this.limits };
  }

  #extensions() {
    const gl = this.gl;
    const floats = Boolean(gl.getExtension("EXT_color_buffer_float"));
    const halves = floats || Boolean(gl.getExtension("EXT_color_buffer_half_float"));
    const blend = Boolean(gl.getExtension("EXT_float_blend"));
    const linear = Boolean(gl.getExtension("OES_texture_float_linear"));
    return { floats, halves, linear, filtered: floats && blend && linear, largest: gl.getParameter(gl.MAX_TEXTURE_SIZE) };
  }

  // ---- scenes

  // what: the name of a scene that ships, the text of a scene file, or a line "scene = {...}".
  async open(what) {
    const core = this.core;
    const line = what.startsWith("scene =");
    const name = !line && /^[\w-]+$/.test(what) ? what : null;
    const text = name === null ? what : this.#sceneFile(name);
    await this.#withFiles(() =>
      line ? core.call("open_line", text) : core.call("open_scene", text, name === null ? "scene" : `${name}.toml`));
    this.name = name;
    this.started = true;
    return this.touch();
  }
  #sceneFile(name) {
    const size = this.core.call("read_file", `${SHIPPED}scenes/${name}.toml`);
    if (size) return this.core.answer();
    this.core.call("no_scene", name);
    throw new Failure(this.core.answer());
  }
  // Runs a call that may need files which the page has not fetched. Throws why it fails by another reason.
  async #withFiles(call) {
    while (!call()) {
      const why = this.core.answer();
      const missed = this.core.json("missed_files").filter((path) => path.startsWith(SHIPPED) && !this.absent.has(path));
      if (missed.length === 0) throw new Failure(why);
      await Promise.all(missed.map((path) => this.#fetchFile(path)));
    }
  }
  #fetchFile(path) {
    if (!this.fetching.has(path)) this.fetching.set(path, this.#fetchOnce(path));
    return this.fetching.get(path);
  }
  async #fetchOnce(path) {
    try {
      const response = await fetch(new URL(path.slice(1), this.base));
      if (response.ok) this.core.call("put_file", path, await this.#fileBytes(path, await response.blob()));
      else this.absent.add(path);
    } catch (error) {
      throw error instanceof Failure ? error : new Failure(`${path.slice(SHIPPED.length)}: ${error.message}`);
    } finally {
      this.fetching.delete(path);  // who asks again may have better luck
    }
  }
  // Pictures are decoded by the browser; core.wasm reads what web/platform/images.cpp says. By a texture of this context, whose bindings stay: a
  // 2D canvas would multiply colours by their alpha and back, and WebKit has no WebGL2 for a canvas that is not on the page.
  async #fileBytes(path, blob) {
    if (!/\.(png|jpe?g)$/i.test(path)) return new Uint8Array(await blob.arrayBuffer());
    const bitmap = await createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
    const { width, height } = bitmap, gl = this.gl, largest = this.limits.largest;
    if (Math.max(width, height) > largest)
      throw new Failure(`${path.slice(SHIPPED.length)}: ${width} x ${height} px; this device takes images of at most ${largest} px`);
    const bytes = new Uint8Array(13 + 4 * width * height), head = new DataView(bytes.buffer);
    bytes.set([0x89, 0x52, 0x47, 0x42, 0x41]);
    head.setUint32(5, width, true);
    head.setUint32(9, height, true);
    const before = [gl.TEXTURE_BINDING_2D, gl.DRAW_FRAMEBUFFER_BINDING, gl.READ_FRAMEBUFFER_BINDING, gl.PIXEL_UNPACK_BUFFER_BINDING,
      gl.PIXEL_PACK_BUFFER_BINDING].map((what) => gl.getParameter(what));
    const texture = gl.createTexture(), framebuffer = gl.createFramebuffer();
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes.subarray(13));
    gl.bindTexture(gl.TEXTURE_2D, before[0]);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, before[1]);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, before[2]);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, before[3]);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, before[4]);
    gl.deleteFramebuffer(framebuffer);
    gl.deleteTexture(texture);
    bitmap.close();
    return bytes;
  }
  async set(key, value) {
    await this.#withFiles(() => this.core.call("set_key", key, value));
    return this.touch();
  }
  keys() { return this.core.json("keys"); }
  metrics() { return this.core.json("metrics"); }
  plan() { return this.core.json("plan"); }
  gallery() { return this.core.json("gallery"); }
  sceneText() { return this.#text("scene_as_text"); }
  sceneLine() { return this.#text("scene_as_line"); }
  #text(name) {
    if (!this.core.call(name)) throw new Failure(this.core.answer());
    return this.core.answer();
  }

  // ---- input

  grab(x, y) { this.core.exports.grab(...this.#scaled(x, y)); }
  look(x, y) { this.core.exports.look(...this.#scaled(x, y)); this.touch(); }
  orbit(x, y) { this.core.exports.orbit(...this.#scaled(x, y)); this.touch(); }
  roll(angle) { this.core.exports.roll(angle); this.touch(); }
  zoom(factor) { this.core.exports.zoom(factor); this.touch(); }
  approach(change) { this.core.exports.approach(change); this.touch(); }
  // Directions of flight, each -1 to 1, until they change.
  fly(hand) { Object.assign(this.hand, hand); this.touch(); }
  letGo() {
    if (!this.core.exports.let_go()) throw new Failure(this.core.answer());
    return this.touch();
  }
  // What telescopes measure of each picture from now on, said as "telescope"; null: nothing more. wish: as want_of_telescope() has it.
  async telescope(wish) {
    this.measures = wish !== null;
    if (!this.measures) return this.core.exports.end_telescope();
    await this.wantOfTelescope(wish);
    return this.touch();
  }
  async wantOfTelescope(wish) {
    this.telescopeWish = wish;
    await this.#withFiles(() => this.core.call("want_of_telescope", ...wish));
    const found = JSON.parse(this.core.answer());
    if (found !== null) this.#sayFound(found);
  }
  async #measure(quick) {
    const { width, height } = this.size;
    try {
      if (!this.limits.floats) throw new Failure("This device cannot draw to textures of floats: its light cannot be read.");
      await this.#withFiles(() => this.core.call("look_by_telescope", width, height, Number(quick)));
      this.#sayFound(JSON.parse(this.core.answer()));
    } catch (error) {
      if (this.measures && !this.gl.isContextLost()) this.say("telescope", { refusal: error.message });
    }
  }
  #sayFound(found) {
    if (!this.measures) return;  // it was told to end meanwhile
    if (found?.beam) {
      const [width, height, place] = found.beam.picture;
      Object.assign(found.beam, { width, height, pixels: new Uint8ClampedArray(this.core.bytes.slice(place, place + 4 * width * height)) });
    }
    this.say("telescope", found);
  }
  setClock(rate) { this.clock = rate; return this.touch(); }
  // px of the canvas to those of the scene's camera, which were set by the last picture
  #scaled(x, y) {
    const drawn = this.drawn ?? this.size;
    return [x * drawn.width / this.size.width, y * drawn.height / this.size.height];
  }

  // ---- pictures

  resize(width, height) {
    this.size = { width: Math.max(1, Math.round(width)), height: Math.max(1, Math.round(height)) };
    this.touch();
  }
  // Every picture has all its pixels, in motion too.
  fix(fixed) { this.fixed = fixed; this.touch(); }
  touch() {
    this.touched = performance.now();
    this.due = true;
    this.rested = false;
    this.failure = undefined;
    this.#wake();
    return true;
  }
  #wake() {
    if (this.turning || !this.started) return;
    this.turning = true;
    this.turned = performance.now();
    const next = globalThis.requestAnimationFrame ?? ((turn) => setTimeout(() => turn(performance.now()), 16));
    const { lives } = this;
    const turn = async () => {
      this.breathed = performance.now();
      try {
        await this.#turn();
      } catch (error) {
        this.#fail(error);
        return;
      }
      if (this.turning && lives === this.lives) next(turn);
    };
    next(turn);
  }

  // What was shown belongs to another scene, or to nothing that is open: it goes, and who waits for a picture hears why there is none.
  #fail(error) {
    this.turning = this.due = false;
    this.failure = error;
    this.drawn = null;
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
    this.gl.clearColor(0, 0, 0, 1);
    this.gl.clear(this.gl.COLOR_BUFFER_BIT);
    this.#refuse(error);
    this.say("failed", { message: error.message });
  }
  #refuse(error) {
    for (const { fail } of this.waiting.splice(0)) fail(error);
  }

  async #turn() {
    const now = performance.now(), seconds = Math.min((now - this.turned) / 1000, 0.25);
    this.turned = now;
    const { right, up, backward, roll } = this.hand;
    const flies = right !== 0 || up !== 0 || backward !== 0;
    if (flies) this.core.exports.fly(right, up, backward, seconds);
    if (roll !== 0) this.core.exports.roll(roll * seconds);
    const moves = flies || roll !== 0 || Boolean(this.core.exports.step(seconds, this.clock));
    if (moves) this.touched = now, this.rested = false;
    const rests = now - this.touched > REST_MS;
    const quick = !this.fixed && (!this.everDrawn || !rests);
    const first = Math.min(1, Math.sqrt(FIRST_PIXELS / (this.size.width * this.size.height)));
    const scale = !quick ? 1 : this.everDrawn ? this.scale : first;
    if (this.due || moves || (rests && !this.#isWhole())) {
      await this.#draw(scale, quick, quick && this.everDrawn ? 1 - Math.exp(-seconds / ADAPTATION_S) : 1);
    } else if (rests && !this.rested) {
      this.rested = true;
      this.say("rest", this.drawn);
    } else if (rests && !this.core.exports.build_next()) {
      this.turning = false;
    }
  }

  // Whether what is shown has all its pixels and all its rays.
  #isWhole() {
    const { width, height } = this.size;
    return !this.painting && Boolean(this.drawn) && !this.drawn.quick && this.drawn.width === width && this.drawn.height === height;
  }
  // quick: see draw() of core.wasm. adaptation: of automatic exposure; a picture that is not quick has its own.
  async #draw(scale, quick, adaptation) {
    const width = Math.max(1, Math.round(this.size.width * scale)), height = Math.max(1, Math.round(this.size.height * scale));
    const began = performance.now(), { lives } = this;
    this.due = false;
    try {
      await this.#paint(width, height, adaptation, quick);
    } catch (error) {
      if (this.gl.isContextLost() || lives !== this.lives) return;
      throw error;
    }
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));  // waits until it is drawn
    const ms = performance.now() - began;
    this.drawn = { width, height, quick };
    if (this.everDrawn && scale === this.scale && ms > SLOW_MS) this.scale = Math.max(LEAST_SCALE, this.scale / Math.SQRT2);
    if (this.everDrawn && scale === this.scale && ms < FAST_MS) this.scale = Math.min(1, this.scale * Math.SQRT2);
    const first = !this.everDrawn;
    if (first) this.touched = -Infinity;  // the whole picture follows at once
    this.everDrawn = true;
    const place = [0, 1, 2, 3, 4].map((which) => this.core.exports.place(which));
    this.say("drawn", { width, height, ms, place, falls: Boolean(this.core.exports.falls()) });
    if (this.measures) await this.#measure(quick);
    if (!first || !quick) this.#ticks();  // the first picture does not wait for their program
    for (const { done } of this.waiting.splice(0)) done();
  }
  // A sky in pieces, then pass by pass: a driver that compiles takes its time within one, and nothing else runs meanwhile.
  async #paint(width, height, adaptation, quick) {
    const { exports } = this.core, { lives } = this, none = 0, gone = 2;
    this.painting = true;
    try {
      for (let left = gone; left !== none;) {
        if (left === gone) {
          await this.#withFiles(() => this.core.call("begin_picture", width, height, adaptation, Number(quick)));
          if ((await this.#paintSkies()) === gone) continue;
          while (!exports.is_compiled()) await this.#breath();
          this.#resizeCanvas(width, height);
        }
        await this.#breatheAtTimes();
        left = exports.draw_next();
      }
    } finally {
      if (lives === this.lives) this.painting = false;
    }
  }
  // Another size clears the canvas: until the last pass of the picture it shows the one before.
  #resizeCanvas(width, height) {
    const { gl, canvas } = this, { width: w, height: h } = canvas;
    if (w === width && h === height) return;
    const kept = gl.createFramebuffer(), colours = gl.createRenderbuffer();
    const copy = (from, to, ...sizes) => {
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, from);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to);
      gl.blitFramebuffer(0, 0, w, h, 0, 0, ...sizes, gl.COLOR_BUFFER_BIT, gl.LINEAR);
    };
    gl.disable(gl.SCISSOR_TEST);
    gl.bindRenderbuffer(gl.RENDERBUFFER, colours);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, w, h);
    gl.bindFramebuffer(gl.FRAMEBUFFER, kept);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, colours);
    copy(null, kept, w, h);
    Object.assign(canvas, { width, height });
    copy(kept, null, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(kept);
    gl.deleteRenderbuffer(colours);
  }
  // Some drivers compile meanwhile.
  async #paintSkies() {
    for (const more = 1; ;) {
      this.core.exports.is_compiled();
      await this.#breatheAtTimes();
      await this.#withFiles(() => this.core.call("paint_skies", this.stretch));
      const [left] = JSON.parse(this.core.answer());
      if (left !== more) return left;
    }
  }
  async #breatheAtTimes() {
    if (performance.now() - this.breathed > this.stretch) await this.#breath();
  }
  // Throws where the context was lost meanwhile.
  async #breath() {
    const { lives } = this;
    await new Promise((done) => setTimeout(done));
    this.breathed = performance.now();
    if (lives !== this.lives || this.gl.isContextLost()) throw new Failure(LOST);
  }
  // Of the canvas's size, in motion too.
  #ticks() {
    const { width, height } = this.size, had = this.ticks;
    if (!this.core.call("ticks", width, height)) throw new Failure(this.core.answer());
    this.ticks = JSON.parse(this.core.answer());
    if (this.ticks || had) this.say("ticks", this.ticks && { width, height, ...this.ticks });
  }
  // The next picture with all its pixels, as RGBA from the top.
  async picture() {
    await this.whole();
    const { width, height } = this.drawn, gl = this.gl;
    const rows = new Uint8ClampedArray(4 * width * height), pixels = new Uint8ClampedArray(rows.length);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, rows);
    for (let y = 0; y < height; ++y) pixels.set(rows.subarray(4 * width * y, 4 * width * (y + 1)), 4 * width * (height - 1 - y));
    return { width, height, pixels };
  }
  async whole() {
    while (this.due || !this.#isWhole()) {
      if (this.failure) throw this.failure;
      if (!this.started) throw new Failure(this.gl.isContextLost() ? LOST : "no scene is open");
      const drawn = new Promise((done, fail) => this.waiting.push({ done, fail }));
      this.#wake();
      await drawn;
    }
  }
  // Where the GPU sent each pixel's ray, for reference.wasm: bytes of RayPixel, and the scene's line.
  async rays(width, height, rowStep = 1) {
    if (!this.limits.floats) throw new Failure("this GPU cannot draw to float textures: its rays cannot be read");
    await this.#withFiles(() => this.core.call("trace_rays", width, height, rowStep));
    if (this.gl.isContextLost()) throw new Failure("the GPU's context was lost while it traced");
    const [w, h, place, bytes] = JSON.parse(this.core.answer());
    const pixels = this.core.bytes.slice(place, place + bytes);
    const line = this.sceneLine();
    this.drawn = null;
    this.touch();
    return { width: w, height: h, rowStep, pixels, line, device: deviceString(this.gl) };
  }

  // ---- a context that is lost

  loseContext() { (this.loser ??= this.gl.getExtension("WEBGL_lose_context")).loseContext(); }
  restoreContext() { this.loser.restoreContext(); }
  #lost(event) {
    event.preventDefault();
    ++this.lives;
    this.started = this.turning = this.painting = false;
    this.#refuse(new Failure(LOST));
    this.say("lost", {});
  }
  #restored() {
    this.limits = this.#extensions();
    this.functions.forget();
    this.core.exports.end_telescope();  // its renderer was the old context's
    this.core.exports.start_view(this.limits.floats, this.limits.filtered);
    if (this.measures) this.telescope(this.telescopeWish.map((value, i) => (i === 2 ? -1 : value)));
    this.started = true;
    this.drawn = null;
    this.say("restored", {});
    this.touch();
  }
}

