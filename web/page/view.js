// <nullscope-view scene="kerr">: a picture that the user moves, without controls. scene: the name of a scene that ships, a scene file's text, or its
// line, scene = { ... }. Events: "drawn", "rest" (the picture is whole and nothing moves), "scene" (another one, or changed), "hand" (somebody
// moves the camera), "ticks" (of polarised light, over the picture), "lost", "restored", "failed"; values are in event.detail. Children lie over the picture.

import { lineOf, partsOf } from "./line.js";

const HERE = new URL("./", import.meta.url).href;
const WHEEL_STEP = 0.15, ZOOM_STEP = 0.08;      // a notch, of the logarithm of distance and of the picture's half width
const WHEEL_RATE = 12;                          // 1/s: how fast the wheel's notches are worked off
const ROLL_PACE = 0.8;                          // rad/s of Q and E
const ROLL_RADIUS = 12;                         // px about the middle where the pointer's angle says nothing
const ARROW_STEP = 0.05;                        // of the picture's height
const FLIGHT = {
  KeyD: ["right", 1], KeyA: ["right", -1], Space: ["up", 1], KeyC: ["up", -1], KeyS: ["backward", 1], KeyW: ["backward", -1],
  KeyE: ["roll", ROLL_PACE], KeyQ: ["roll", -ROLL_PACE],
};
const ARROWS = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const STYLE = `
  :host { display: block; position: relative; overflow: hidden; background: #000; min-height: 40px; outline: none; }
  :host(:not([hidden])) { aspect-ratio: 16 / 9; }
  canvas { position: absolute; inset: 0; width: 100%; height: 100%; touch-action: none; cursor: grab; display: block; }
  canvas:active { cursor: grabbing; }
  canvas + canvas { pointer-events: none; }
  :host(:focus-visible) canvas { outline: 1px solid #ffb65cb0; outline-offset: -1px; }
  p { position: absolute; left: 50%; top: 50%; transform: translate(-50%, -50%); margin: 0; max-width: min(34em, 84%); box-sizing: border-box;
      padding: .8em 1.1em; border-radius: 10px; background: #0c0e13e6; color: #e9ebf0; font: 15px/1.45 system-ui, sans-serif; text-align: center;
      overflow-wrap: anywhere; }
  [hidden] { display: none; }
`;

// Where the engine runs: calls with answers, and calls without. Both have the same two methods.
class InWorker {
  constructor(say) {
    const script = new URL("worker.js", HERE).href;
    // Another site's script starts no worker, but may be imported by one.
    const url = new URL(HERE).origin === location.origin ? script
      : URL.createObjectURL(new Blob([`import ${JSON.stringify(script)};`], { type: "text/javascript" }));
    this.worker = new Worker(url, { type: "module" });
    this.waiting = new Map();
    this.last = 0;
    this.worker.onmessage = ({ data: { id, value, error, event, values } }) => {
      if (event) return say(event, values);
      const { done, fail } = this.waiting.get(id);
      this.waiting.delete(id);
      return error === undefined ? done(value) : fail(new Error(error));
    };
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.failure = new Error(event.message || "the program could not be loaded");
      for (const { fail } of this.waiting.values()) fail(this.failure);
      this.waiting.clear();
    };
  }
  ask(call, values, transfer = []) {
    return new Promise((done, fail) => {
      if (this.failure) return fail(this.failure);
      this.waiting.set(++this.last, { done, fail });
      return this.worker.postMessage({ id: this.last, call, values }, transfer);
    });
  }
  tell(call, values) {
    this.worker.postMessage({ call, values });
  }
  end() {
    this.worker.terminate();
  }
}
class InPage {
  constructor(say) {
    this.say = say;
    this.engine = import("./engine.js").then(({ Engine }) => new Engine(say));
  }
  async ask(call, values) {
    return (await this.engine)[call](...values);
  }
  tell(call, values) {
    this.ask(call, values).catch((error) => this.say("failed", { message: error.message }));
  }
  end() {}
}

export class NullscopeView extends HTMLElement {
  static observedAttributes = ["scene"];

  constructor() {
    super();
    this.attachShadow({ mode: "open" }).innerHTML =
      `<style>${STYLE}</style><canvas part="picture"></canvas><canvas part="ticks" hidden></canvas><slot></slot><p part="message" role="status" hidden></p>`;
    this.message = this.shadowRoot.querySelector("p");
    this.held = new Set();       // keys
    this.fingers = new Map();    // by pointer: where it is, canvas px
    this.left = 0;               // of the wheel's way
    this.#listen();
  }

  connectedCallback() {
    this.tabIndex = this.tabIndex < 0 ? 0 : this.tabIndex;
    this.setAttribute("role", "application");
    if (!this.hasAttribute("aria-label")) this.setAttribute("aria-label", "Picture of a curved spacetime. W A S D fly, arrow keys look around.");
    this.#say("Loading the spacetime\u2026");
    this.ready = this.#start();
    this.ready.then(() => this.hasAttribute("scene") && !this.opened && this.open(this.getAttribute("scene")).catch(() => {}), () => {});
  }
  disconnectedCallback() {
    this.observer?.disconnect();
    this.engine?.end();
    this.opened = undefined;
  }
  attributeChangedCallback(name, before, now) {
    if (this.opened !== undefined && now !== null && now !== before) this.open(now).catch(() => {});
  }

  // ---- what a page may call

  // A call of the class Engine (engine.js): its value, later.
  async ask(call, ...values) {
    await this.ready;
    return this.engine.ask(call, values);
  }
  // Shows another scene, whose line is then in `line`. Throws what is wrong with it, and says so over the picture if there is none yet.
  async open(what) {
    this.opened = what;
    try {
      await this.ask("open", what);
    } catch (error) {
      if (!this.drawn) this.#say(plain(error.message));
      throw error;
    }
    this.line = await this.ask("sceneLine");
    this.#event("scene", { what });
  }
  // A key of a scene file gets another value, both as text.
  async set(key, value) {
    await this.ask("set", key, value);
    this.#event("scene", { key });
  }
  // edit(parts): changes the parts of the scene, a Map of sections as a scene's line has them.
  async change(edit) {
    const parts = partsOf(await this.ask("sceneLine"));
    edit(parts);
    await this.ask("open", lineOf(parts));
    this.#event("scene", {});
  }
  // Back to the camera that the scene had when it was opened.
  async home() {
    const camera = partsOf(this.line).get("camera");
    await this.change((parts) => (camera ? parts.set("camera", camera) : parts.delete("camera")));
    this.#event("hand", {});
  }
  async letGo() {
    await this.ask("letGo");
    this.#event("hand", {});
  }
  // The picture with all its pixels, as a PNG.
  async png() {
    const { width, height, pixels } = await this.ask("picture");
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    const drawing = canvas.getContext("2d");
    drawing.putImageData(new ImageData(pixels, width, height), 0, 0);
    if (this.ticks) drawTicks(drawing, this.ticks);
    return new Promise((done) => canvas.toBlob(done, "image/png"));
  }

  // ---- the engine

  async #start() {
    const say = (event, values) => this.#heard(event, values);
    const old = typeof DecompressionStream === "undefined" || typeof WebAssembly === "undefined" || typeof ResizeObserver === "undefined";
    if (old) this.#fail(new Error("this browser is too old. Any current one shows it"));
    const start = (engine, canvas, transfer) => {
      this.engine = engine;
      const { width, height } = this.#pixels();
      return engine.ask("start", [canvas, HERE, width, height], transfer);
    };
    try {
      try {
        const canvas = this.#canvas().transferControlToOffscreen();
        this.device = await start(new InWorker(say), canvas, [canvas]);
      } catch {
        // Some browsers draw with WebGL in the page only.
        this.engine?.end();
        this.device = await start(new InPage(say), this.#canvas(true), []);
      }
      if (!this.device.halves) throw new Error("this device cannot draw to textures of floats, which brightness needs");
    } catch (error) {
      this.#fail(error);
    }
    this.observer = new ResizeObserver(() => {
      const { width, height } = this.#pixels();
      this.engine.tell("resize", [width, height]);
    });
    this.observer.observe(this);
  }
  #fail(error) {
    this.#say(plain(error.message));
    this.#event("failed", { message: error.message });
    throw error;
  }
  #canvas(anew = this.used) {
    const canvas = this.shadowRoot.querySelector("canvas");
    this.used = true;
    if (!anew) return canvas;
    const another = canvas.cloneNode();
    canvas.replaceWith(another);
    return another;
  }
  #pixels() {
    const ratio = devicePixelRatio || 1;
    return { width: Math.max(1, Math.round(this.clientWidth * ratio)), height: Math.max(1, Math.round(this.clientHeight * ratio)) };
  }
  #heard(event, values) {
    if (event === "drawn") {
      this.drawn = values;
      this.message.hidden = true;
    }
    if (event === "ticks") this.#showTicks(values);
    if (event === "failed" || event === "lost") this.#showTicks(null);
    if (event === "lost") this.#say("The graphics device is gone for a moment. The picture comes back by itself.");
    if (event === "failed") this.#say(plain(values.message));
    this.#event(event, values);
  }
  #event(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
  #showTicks(ticks) {
    const over = this.shadowRoot.querySelector("[part=ticks]");
    this.ticks = ticks;
    over.hidden = !ticks;
    if (!ticks) return;
    over.width = ticks.width;   // which clears it
    over.height = ticks.height;
    drawTicks(over.getContext("2d"), ticks);
  }
  #say(text) {
    this.message.textContent = text;
    this.message.hidden = false;
  }
  #tell(call, ...values) {
    this.engine?.tell(call, values);
    if (call !== "grab") this.#event("hand", {});
  }

  // ---- input

  #listen() {
    const on = (name, act, options) => this.addEventListener(name, (event) => this.drawn && act(event), options);
    on("pointerdown", (event) => this.#down(event));
    on("pointermove", (event) => this.#move(event));
    for (const name of ["pointerup", "pointercancel"]) on(name, (event) => this.#up(event));
    on("wheel", (event) => this.#wheel(event), { passive: false });
    on("contextmenu", (event) => event.preventDefault());
    on("keydown", (event) => this.#key(event));
    on("keyup", (event) => this.held.delete(event.code) && this.#fly());
    on("blur", () => (this.held.clear(), this.#fly()));
  }
  // A place in canvas pixels
  #place(event) {
    const box = this.getBoundingClientRect(), ratio = devicePixelRatio || 1;
    return [(event.clientX - box.left) * ratio, (event.clientY - box.top) * ratio];
  }
  #down(event) {
    this.focus({ preventScroll: true });
    this.setPointerCapture(event.pointerId);
    const at = this.#place(event);
    if (event.pointerType === "mouse") {
      event.preventDefault();
      this.fingers.clear();
      this.kind = event.button === 2 ? "roll" : event.button === 1 || event.altKey ? "orbit" : "look";
    }
    this.fingers.set(event.pointerId, at);
    if (event.pointerType !== "mouse") this.kind = this.fingers.size === 1 ? "look" : "two";
    if (this.kind === "look") this.#tell("grab", ...at);
  }
  #move(event) {
    const from = this.fingers.get(event.pointerId);
    if (!from) return;
    const at = this.#place(event), [dx, dy] = [at[0] - from[0], at[1] - from[1]];
    if (dx === 0 && dy === 0) return;
    const before = [...this.fingers.values()].slice(0, 2);
    this.fingers.set(event.pointerId, at);
    if (this.kind === "look") this.#tell("look", ...at);
    if (this.kind === "orbit") this.#tell("orbit", dx, dy);
    if (this.kind === "roll") this.#turn(from, at);
    if (this.kind === "two" && before.length === 2) this.#two(before, [...this.fingers.values()].slice(0, 2));
  }
  #up(event) {
    if (!this.fingers.delete(event.pointerId)) return;
    const [left] = this.fingers.values();
    this.kind = left === undefined ? undefined : this.fingers.size === 1 ? "look" : "two";
    if (this.kind === "look") this.#tell("grab", ...left);
  }
  #turn(from, at) {
    const { width, height } = this.#pixels();
    const [a, b] = [from, at].map(([x, y]) => [x - width / 2, height / 2 - y]);
    if (Math.min(Math.hypot(...a), Math.hypot(...b)) > ROLL_RADIUS)
      this.#tell("roll", Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]));
  }
  // Two fingers: apart comes nearer, a drag goes round the centre, a twist rolls.
  #two(before, now) {
    const middle = ([a, b]) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], span = ([a, b]) => [b[0] - a[0], b[1] - a[1]];
    const [mx, my] = middle(before), [nx, ny] = middle(now), [u, v] = [span(before), span(now)];
    const apart = Math.hypot(...v) / Math.max(Math.hypot(...u), 1);
    if (apart > 0) this.#tell("approach", -Math.log(apart));
    this.#tell("orbit", nx - mx, ny - my);
    this.#tell("roll", -Math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]));
  }
  // In a page that scrolls, the wheel is the page's until the picture was clicked.
  #wheel(event) {
    const page = document.scrollingElement;
    if (page && page.scrollHeight > page.clientHeight && document.activeElement !== this) return;
    event.preventDefault();
    const way = event.deltaY || event.deltaX, line = event.deltaMode === 0 ? 100 : event.deltaMode === 1 ? 3 : 1;
    const notches = Math.max(-4, Math.min(4, way / line)) * (event.ctrlKey ? 4 : 1);
    if (event.shiftKey) return this.#tell("zoom", Math.exp(ZOOM_STEP * notches));
    this.left += WHEEL_STEP * notches;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return this.#tell("approach", this.left), (this.left = 0);
    if (!this.gliding) this.#glide(performance.now());
    return undefined;
  }
  #glide(before) {
    this.gliding = requestAnimationFrame((now) => {
      const rest = Math.abs(this.left) < 1e-3, seconds = Math.max(0, now - before) / 1000;
      const part = rest ? this.left : this.left * (1 - Math.exp(-WHEEL_RATE * seconds));
      this.left -= part;
      this.#tell("approach", part);
      if (rest) this.gliding = undefined;
      else this.#glide(Math.max(now, before));
    });
  }
  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { code } = event;
    if (code in FLIGHT) {
      this.held.add(code);
      if (!event.repeat) this.#fly();
    } else if (code in ARROWS) {
      const { width, height } = this.#pixels(), [x, y] = ARROWS[code];
      this.#tell("grab", width / 2, height / 2);
      this.#tell("look", width / 2 + ARROW_STEP * height * x, height / 2 + ARROW_STEP * height * y);
    } else if (code === "KeyF") {
      if (!event.repeat) this.letGo().catch((error) => this.#event("refused", { message: plain(error.message) }));
    } else if (code === "KeyR") {
      this.home().catch((error) => this.#event("refused", { message: plain(error.message) }));
    } else if (event.key === "+" || event.key === "-") {
      this.#tell("zoom", Math.exp(event.key === "+" ? -ZOOM_STEP : ZOOM_STEP));
    } else {
      return;
    }
    event.preventDefault();
  }
  #fly() {
    const hand = { right: 0, up: 0, backward: 0, roll: 0 };
    for (const code of this.held) hand[FLIGHT[code][0]] += FLIGHT[code][1];
    this.#tell("fly", hand);
  }
}

// As src/viewer/tick_lines.cpp draws them.
function drawTicks(drawing, { thick, lines }) {
  drawing.beginPath();
  for (let i = 0; i < lines.length; i += 4) {
    const [x, y, right, up] = lines.slice(i, i + 4);
    drawing.moveTo(x - right, y + up);
    drawing.lineTo(x + right, y - up);
  }
  drawing.lineCap = "round";
  for (const [width, colour] of [[2.2 * thick, "#00000096"], [thick, "#f5f5f5"]]) {
    drawing.lineWidth = width;
    drawing.strokeStyle = colour;
    drawing.stroke();
  }
}

// A message of the engine for people: without the place in a file that they never saw.
export function plain(message) {
  const text = message.replace(/^scene(\.toml)?(:\d+)*: /, "").replace(/^[a-z]+(?![\w.])/, (word) => word[0].toUpperCase() + word.slice(1));
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

customElements.define("nullscope-view", NullscopeView);
