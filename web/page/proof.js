// The proof: rays that this device's GPU traced, measured by the reference tracer in a worker of its own.

import { make } from "./controls.js";
import { plain } from "./view.js";

const MOST_PIXELS = 640 * 360;
const HERE = new URL("./", import.meta.url).href;

const count = (n) => n.toLocaleString("en").replaceAll(",", "\u202f");
const px = (x) => (x === 0 ? "0 px" : x < 1e-4 ? `${x.toExponential(1)} px` : `${Number(x.toPrecision(2))} px`);

// Rays that end on the sky or on something, both as the GPU and as the reference have them: where they end can be compared.
const positions = ({ sky_px: sky, place_px: place }) => sky.count + place.count;
// How long it takes to measure so many pixels, as people say it.
function duration(count, { measured, seconds }) {
  const all = count * seconds / Math.max(measured, 1);
  return all < 90 ? `some ${Math.max(1, Math.round(all))} s` : `some ${Math.round(all / 60)} minutes`;
}

function judging(heard) {
  const judge = new Worker(new URL("judge.js", HERE), { type: "module" });
  judge.onmessage = ({ data }) => heard(data);
  return judge;
}

export class Proof {
  // scene(): { title, link } of what is shown, later.
  constructor(view, place, heat, scene) {
    this.view = view;
    this.heat = heat;
    this.scene = scene;
    this.button = make("button", { type: "button", className: "main", id: "measure", textContent: "Measure this device" });
    this.button.addEventListener("click", () => (this.judge ? this.#end("Stopped.") : this.#measure()));
    this.status = make("p", { className: "note" });
    this.status.setAttribute("role", "status");
    this.progress = make("progress", { max: 1, value: 0, hidden: true });
    this.progress.setAttribute("aria-label", "Pixels measured");
    this.figures = make("dl", { className: "figures", hidden: true });
    this.text = make("pre", { id: "certificate", hidden: true, tabIndex: 0 });
    this.copy = make("button", { type: "button", textContent: "Copy as text", hidden: true });
    this.copy.addEventListener("click", async () => {
      await navigator.clipboard.writeText(this.text.textContent);
      this.copy.textContent = "Copied";
      setTimeout(() => (this.copy.textContent = "Copy as text"), 2000);
    });
    this.show = make("input", { type: "checkbox", className: "switch" });
    this.show.setAttribute("role", "switch");
    this.show.setAttribute("aria-label", "Errors over the picture");
    this.show.addEventListener("change", () => (heat.hidden = !this.show.checked));
    this.toggle = make("label", { className: "row", hidden: true }, make("span", { className: "name", textContent: "Errors over the picture" }), this.show);
    this.legend = make("p", { className: "note", hidden: true, textContent: "Black: 0.0001 px and less; then blue, green, yellow, red; white: a whole pixel. A dark "
      + "picture is an exact one." });
    this.list = make("dl", { className: "plan" });
    place.append(
      make("h2", { textContent: "How exact is this picture?" }),
      make("p", { className: "note", textContent: "Your graphics device finds where the light of each pixel comes from. A second program, which shares no "
        + "code with the first, then computes the same rays in double precision. The difference is measured in pixels of the picture." }),
      this.button, this.progress, this.status, this.figures, this.toggle, this.legend, this.text, this.copy,
      make("h2", { textContent: "What is simulated here, and why" }), this.list);
    view.addEventListener("hand", () => (this.show.checked = false));
    view.addEventListener("scene", () => this.#stale());
    view.addEventListener("drawn", ({ detail }) => (this.falls = detail.falls));
  }

  plan(effects) {
    this.list.replaceChildren(...effects.flatMap(({ effect, reason, cost }) => [
      make("dt", { textContent: effect }), make("dd", {}, reason, make("small", { textContent: cost }))]));
  }

  // Says how long it would take here, by some of the reference's rays, or why nothing can be measured; before anybody asks.
  async estimate() {
    this.trial?.terminate();
    if (this.judge || !this.text.hidden) return;
    try {
      const rays = { ...this.#size(), line: await this.view.ask("sceneLine"), pixels: new Uint8Array() };
      this.trial = judging(({ error, certificate }) => {
        this.trial.terminate();
        if (this.judge || this.button.disabled) return;
        this.#say(error === undefined ? `Measuring takes ${duration(certificate.pixels, certificate)} here.` : plain(error));
      });
      this.trial.postMessage({ base: HERE, rays });
    } catch {
      this.#say("");   // there is no scene
    }
  }
  // Of the picture that is measured, px.
  #size() {
    const box = this.view.getBoundingClientRect(), ratio = devicePixelRatio || 1;
    const width = box.width * ratio, height = box.height * ratio, scale = Math.min(1, Math.sqrt(MOST_PIXELS / (width * height)));
    return { width: Math.floor(width * scale), height: Math.floor(height * scale) };
  }
  async #measure() {
    this.trial?.terminate();
    const device = this.view.device;
    if (device && !device.floats)
      return this.#say("This device cannot draw to textures of floats, so its rays cannot be read. The picture is not affected.");
    this.#stale();
    this.#say("Tracing the rays on your device\u2026");
    this.button.disabled = true;
    try {
      if (this.falls) await this.view.letGo();
      const { width, height } = this.#size(), rays = await this.view.ask("rays", width, height);
      this.about = { ...(await this.scene()), device: rays.device, browser: browser(), width: rays.width, height: rays.height, date: new Date() };
      this.judge = judging((data) => this.#heard(data));
      this.judge.onerror = (event) => this.#end(plain(event.message || "The reference tracer could not be loaded"));
      this.judge.postMessage({ base: HERE, rays }, [rays.pixels.buffer]);
      this.button.textContent = "Stop";
      this.progress.hidden = false;
      this.#say("The reference tracer is at work. What is known by now is below and over the picture.");
    } catch (error) {
      this.#say(plain(error.message));
    }
    this.button.disabled = false;
    return undefined;
  }
  #heard({ error, certificate, heat, width, height, whole }) {
    if (error !== undefined) return this.#end(plain(error));
    Object.assign(this.heat, { width, height });
    this.heat.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(heat.buffer), width, height), 0, 0);
    this.progress.value = certificate.measured / certificate.pixels;
    if (!this.shown) {
      this.shown = true;
      this.show.checked = true;
      this.heat.hidden = false;
      for (const part of [this.figures, this.toggle, this.legend]) part.hidden = false;
    }
    this.#figures(certificate);
    if (!whole) this.#say(`The reference tracer is at work: ${duration(certificate.pixels - certificate.measured, certificate)} are left. What is known by now is below and over the picture.`);
    if (whole && positions(certificate) === 0)
      return this.#end("Every ray is traced again, and no place could be measured: what the picture shows here has none, as the black of a hole. "
        + "This certifies no precision.");
    if (whole) {
      this.#end("Every pixel is measured.");
      this.text.textContent = this.#certificate(certificate);
      for (const part of [this.text, this.copy]) part.hidden = false;
    }
    return undefined;
  }
  #figures(certificate) {
    const { measured, pixels, fate_errors: wrong, sky_px: sky, place_px: place } = certificate, known = positions(certificate);
    const error = (values) => (known === 0 ? "\u2013" : px(Math.max(...values)));
    const figures = [
      ["Largest error", error([sky.max, place.max])], ["99.9 % of places within", error([sky.p999, place.p999])],
      ["Places measured", count(known)], ["Wrong fates", count(wrong)],
      ["Pixels", measured === pixels ? count(pixels) : `${count(measured)} of ${count(pixels)}`],
    ];
    this.figures.replaceChildren(...figures.map(([name, value]) =>
      make("div", {}, make("dt", { textContent: name }), make("dd", { textContent: value }))));
  }
  #certificate(certificate) {
    const { pixels, fate_errors: wrong, forgiven, sky_px: sky, place_px: place, seconds } = certificate;
    const { title, link, device, browser, width, height, date } = this.about;
    const spread = (name, { max, p999, count: n }) =>
      n > 0 ? [`${name.padEnd(16)}largest error ${px(max)}, 99.9 % within ${px(p999)}, ${count(n)} pixels`] : [];
    return [
      "nullscope: measured on this device", "",
      `largest error   ${px(Math.max(sky.max, place.max))}`,
      `99.9 % within   ${px(Math.max(sky.p999, place.p999))}`,
      `wrong fates     ${count(wrong)}${forgiven > 0 ? `, and ${count(forgiven)} within 0.01 px of an edge` : ""}`,
      `pixels          ${count(pixels)}, every one`,
      `places          ${count(positions(certificate))}: rays that end on the sky, the disc or a body`,
      ...spread("sky", sky), ...spread("disc, bodies", place),
      `device          ${deviceName(device)}`, `browser         ${browser}`, `scene           ${title}`, `size            ${width} x ${height}`,
      `date            ${date.toISOString().slice(0, 16).replace("T", " ")} UTC, ${Math.round(seconds)} s`, `view            ${link}`,
    ].join("\n");
  }
  #say(text) {
    this.status.textContent = text;
  }
  #end(text) {
    this.judge?.terminate();
    this.judge = undefined;
    this.progress.hidden = true;
    this.button.textContent = "Measure this device";
    this.#say(text);
  }
  // Another scene: what was measured is of the one before.
  #stale() {
    if (this.judge) this.#end("Stopped: the scene has changed.");
    this.shown = false;
    this.heat.hidden = true;
    for (const part of [this.figures, this.toggle, this.legend, this.text, this.copy]) part.hidden = true;
  }
}

// WebKit has one name for every device, and elsewhere than on Apple's systems its numbers are no version of anything.
function deviceName(device) {
  return device === "Apple GPU" ? "not told (WebKit says Apple GPU of every device)" : device;
}
function browser() {
  const brands = navigator.userAgentData?.brands.filter(({ brand }) => !/Not/.test(brand)) ?? [];
  const known = brands.find(({ brand }) => brand !== "Chromium") ?? brands[0];
  if (known) return `${known.brand} ${known.version}, ${navigator.userAgentData.platform}`;
  const found = (navigator.userAgent.match(/(Firefox|Edg|OPR|Chrome|Version)\/[\d.]+/g) ?? [navigator.userAgent]).at(-1);
  const name = !found.startsWith("Version") ? found.replace("/", " ") : /^(Mac|iP)/.test(navigator.platform) ? found.replace("Version/", "Safari ") : "WebKit";
  return `${name}, ${navigator.platform}`;
}
