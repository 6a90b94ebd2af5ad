// Controls of a scene, made from what the engine says of it: keys() and metrics() of engine.js. Help, range, unit and choices are theirs.

import { entries, partsOf, table } from "./line.js";
import { plain } from "./view.js";

// What is shown first of a section; its other keys are behind "More".
const FIRST = {
  camera: ["exposure", "fov", "observer", "velocity"],
  disc: ["brightness", "inner", "outer", "emission", "temperature", "texture", "opacity"],
  sky: ["kind", "brightness", "yaw", "tilt"],
  far_sky: ["kind", "brightness"],
  light: ["lensing", "aberration", "doppler", "gravity", "beaming", "delay"],
  picture: ["bloom", "tone", "auto_exposure", "ticks", "streamlines", "polariser"],
};
const ORDER = ["camera", "disc", "spot", "sphere", "cap", "cylinder", "sky", "far_sky", "light", "picture"];
const OPEN = ["spacetime", "camera"];
const OPTIONAL = ["disc"];  // sections that a scene may do without
// Where a slider's way is shorter than what is allowed.
const SPANS = {
  "camera.exposure": [-6, 6], "camera.fov": [10, 150], "disc.brightness": [0, 10], "disc.inner": [0, 20], "disc.outer": [0, 60],
  "sky.brightness": [0, 4], "far_sky.brightness": [0, 4], "disc.temperature": [1000, 100000], "sky.temperature": [1000, 100000],
  "sphere.temperature": [1000, 100000], "sphere.spin_rate": [-0.3, 0.3], "cap.temperature": [1000, 100000], "cap.brightness": [0, 10],
  "cylinder.temperature": [1000, 100000],
  "picture.polariser": [0, 180], "spot.r": [1.5, 20], "spot.size": [0.05, 2], "spot.brightness": [0, 10], "spot.temperature": [1000, 100000],
};
const WORDS = {
  fov: "Field of view", r: "Distance r", yaw: "Turn", pitch: "Tilt up", "sky.yaw": "Turn", "far_sky.yaw": "Turn", u: "u", v: "v",
  far_sky: "Far sky", zamo: "ZAMO", spot: "Hot spot", picture: "Picture", cylinder: "Thick disc", sphere: "Sphere", cap: "Hot cap",
  "light.gravity": "Gravitational shift", "light.doppler": "Doppler shift", "light.delay": "Light-travel time", "sky.kind": "Shows",
  "reissner-nordstrom": "Reissner\u2013Nordstr\u00f6m (charged)", kerr: "Kerr (rotating)", "kerr-newman": "Kerr\u2013Newman",
  ellis: "Ellis wormhole", "dneg-wormhole": "Wormhole of \u201cInterstellar\u201d", minkowski: "Flat", schwarzschild: "Schwarzschild",
  "janis-newman-winicour": "Janis\u2013Newman\u2013Winicour", "neutron-star": "Neutron star", formula: "Formula", velocity: "Speed",
  "counter-orbit": "Counter-orbit",
};
// How the picture is moved: what moves it, by a mouse and keys, by fingers.
const HANDS = [["Look round", "drag, arrows", "one finger"], ["Closer, farther", "wheel, W S", "two fingers apart"],
  ["Round the centre", "Alt and drag", "two fingers, drag"], ["Fly", "W A S D, Space, C", ""], ["Roll", "right drag, Q E", "two fingers, twist"],
  ["Zoom", "Shift and wheel, + -", ""], ["Fall, stop", "F", ""], ["The scene's camera", "R", ""]];
const AXES = ["outward", "southward", "eastward"];
const NOT_HERE = new Set(["camera.size", "camera.plane_width", "camera.focal_distance", "camera.stereo", "camera.eye_distance",
  "camera.pixel_aspect", "sky.catalogue", "picture.scale_bar", "picture.shutter", "picture.sub_frames"]);
const TYPES = new Set(["number", "whole", "choice", "velocity", "colour", "formula"]);

export const words = (name, full = name) =>
  WORDS[full] ?? WORDS[name] ?? name.charAt(0).toUpperCase() + name.slice(1).replaceAll("_", " ");

export function make(kind, values = {}, ...children) {
  const { dataset, ...rest } = values;
  const element = Object.assign(document.createElement(kind), rest);
  Object.assign(element.dataset, dataset);
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}
const fixed = (value) => String(Number(value.toPrecision(6)));
let labels = 0;

// One row: its name, which shows the help when it is pressed, and what changes the value.
function row(name, help, unit, ...inputs) {
  const id = `c${++labels}`;
  const told = make("p", { className: "help", id: `${id}-help`, textContent: help, hidden: true });
  const label = make("button", { type: "button", className: "name", title: help, id, textContent: name });
  label.setAttribute("aria-expanded", "false");
  label.setAttribute("aria-controls", told.id);
  label.addEventListener("click", () => {
    told.hidden = !told.hidden;
    label.setAttribute("aria-expanded", String(!told.hidden));
  });
  for (const input of inputs) {
    if (!input.ariaLabel && !input.hasAttribute("aria-label")) input.setAttribute("aria-labelledby", id);
    input.setAttribute("aria-describedby", told.id);
    input.title ||= help;
  }
  const [first, ...others] = inputs;
  return make("div", { className: "row" }, label, make("span", { className: "value" }, first, unit ? make("i", { textContent: unit }) : null),
    ...others, told);
}

// Each kind of control: { element, show(value as text) }; give(value as text, as a scene file has it) is called when a hand changes it.
function number(name, key, give) {
  const [low, high] = SPANS[key.name] ?? (key.unit === "deg" && key.range[1] > 360 ? [-180, 180] : key.range);
  const field = make("input", { type: "number", step: key.type === "whole" ? 1 : "any", inputMode: "decimal" });
  if (key.range[1] > key.range[0]) [field.min, field.max] = key.range;
  const slides = high > low && high - low <= 1e5;
  const steep = slides && low > 0 && high / low > 50;
  const to = steep ? Math.log : (x) => x, from = steep ? Math.exp : (x) => x;
  const slider = make("input", { type: "range", min: 0, max: 1, step: key.type === "whole" ? 1 / (high - low) : 0.001 });
  const place = (value) => (to(Math.min(high, Math.max(low, value))) - to(low)) / (to(high) - to(low));
  const shown = (value) => {
    slider.setAttribute("aria-valuetext", `${fixed(value)} ${key.unit ?? ""}`.trim());
    slider.style.setProperty("--at", place(value));
  };
  slider.addEventListener("input", () => {
    let value = from(to(low) + Number(slider.value) * (to(high) - to(low)));
    if (key.type === "whole") value = Math.round(value);
    const digits = steep ? 3 : Math.max(0, 3 - Math.floor(Math.log10(high - low)));
    const text = steep ? String(Number(value.toPrecision(3))) : String(Number(value.toFixed(Math.min(digits, 6))));
    field.value = text;
    shown(Number(text));
    give(text);
  });
  // Emptied, an optional key is left out again.
  field.addEventListener("change", () => field.value !== "" ? give(String(Number(field.value))) : key.optional && give(""));
  return {
    element: row(name, key.help, key.unit, field, ...(slides ? [slider] : [])),
    show(value) {
      const now = Number(value);
      field.value = value === "" ? "" : fixed(now);
      if (!slides) return;
      slider.value = value === "" ? 0 : place(now);
      if (value === "") slider.style.setProperty("--at", 0), slider.setAttribute("aria-valuetext", "none");
      else shown(now);
    },
  };
}
function choice(name, key, give) {
  if (key.choices.length === 2 && key.choices.includes("on")) {
    const box = make("input", { type: "checkbox", className: "switch" });
    box.setAttribute("role", "switch");
    box.addEventListener("change", () => give(`"${box.checked ? "on" : "off"}"`));
    return { element: row(name, key.help, "", box), show: (value) => (box.checked = value === "on") };
  }
  const list = make("select", {}, ...key.choices.map((value) => make("option", { value, textContent: words(value, value) })));
  list.addEventListener("change", () => give(`"${list.value}"`));
  return { element: row(name, key.help, "", list), show: (value) => (list.value = value) };
}
function velocity(name, key, give) {
  const sliders = AXES.map((axis) => {
    const slider = make("input", { type: "range", min: -0.99, max: 0.99, step: 0.01, ariaLabel: `${name}, ${axis}` });
    slider.setAttribute("aria-label", `${name}, ${axis}`);
    return slider;
  });
  const text = make("output", {});
  const show = (values) => {
    values.forEach((value, i) => {
      sliders[i].value = value;
      sliders[i].style.setProperty("--at", (Number(value) + 0.99) / 1.98);
    });
    text.value = fixed(Math.hypot(...values));
  };
  for (const slider of sliders)
    slider.addEventListener("input", () => {
      // The others give way: the speed stays below that of light.
      const own = Number(slider.value), others = sliders.filter((other) => other !== slider);
      const rest = Math.hypot(...others.map((other) => Number(other.value))), most = Math.sqrt(Math.max(0, 0.995 ** 2 - own ** 2));
      const shrink = rest > most ? most / rest : 1;
      const values = sliders.map((each) => (each === slider ? own : Number((Number(each.value) * shrink).toFixed(4))));
      show(values);
      give(`[${values.join(", ")}]`);
    });
  const element = row(name, key.help, key.unit, text);
  const axes = make("div", { className: "axes" });
  sliders.forEach((slider, i) => axes.append(make("label", {}, make("span", { textContent: AXES[i] }), slider)));
  element.insertBefore(axes, element.querySelector(".help"));
  return { element, show: (value) => show(JSON.parse(value)) };
}
function colour(name, key, give) {
  const field = make("input", { type: "color" });
  const packed = (x) => Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
  const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
  field.addEventListener("input", () =>
    give(`[${[1, 3, 5].map((at) => Number(linear(parseInt(field.value.slice(at, at + 2), 16) / 255).toFixed(4))).join(", ")}]`));
  return {
    element: row(name, key.help, "", field),
    show(value) {
      const parts = JSON.parse(value).map((x) => packed(Math.min(1, Math.max(0, x))).toString(16).padStart(2, "0"));
      field.value = `#${parts.join("")}`;
    },
  };
}
function formula(name, key, give) {
  const field = make("input", { type: "text", spellcheck: false, autocomplete: "off" });
  field.addEventListener("change", () => give(JSON.stringify(field.value)));
  return { element: row(name, key.help, "", field), show: (value) => (field.value = value) };
}
const MAKERS = { number, whole: number, choice, velocity, colour, formula };

// One call at a time, and then the last of those that came meanwhile.
function latest(act) {
  let busy = false, next;
  return async function call(...values) {
    if (busy) return void (next = values);
    busy = true;
    try {
      await act(...values);
    } finally {
      busy = false;
    }
    if (next !== undefined) {
      const then = next;
      next = undefined;
      await call(...then);
    }
  };
}

// A control that a hand is just changing is left alone.
const held = (element) => element.querySelector(":active, input[type=number]:focus, input[type=text]:focus") !== null;

// Fills `place` with the controls of a <nullscope-view>. refresh(): shows what the scene has now.
export class Controls {
  constructor(view, place, say) {
    this.view = view;
    this.place = place;
    this.say = say;
    this.controls = new Map();
    this.refresh = latest(() => this.#refresh());
  }

  async #refresh() {
    const [keys, metrics, line] = await Promise.all([this.view.ask("keys"), this.view.ask("metrics"), this.view.ask("sceneLine")]);
    const parts = partsOf(line);
    if (!this.sections) this.#build(keys);
    const own = (section, name) => entries(parts.get(section) ?? "{}").get(name);
    this.#metric("spacetime", metrics, unquoted(own("spacetime", "metric")) ?? "schwarzschild", parts);
    this.#metric("split", metrics, parts.has("split") ? unquoted(own("split", "metric")) ?? "schwarzschild" : null, parts);
    const meant = new Map(keys.map((key) => [key.name, key]));
    for (const [name, control] of this.controls) {
      const key = meant.get(name);
      control.element.hidden = !key.meant;
      if (key.meant && !held(control.element)) control.show(key.value);
    }
    for (const [title, section] of this.sections) {
      const has = [...section.querySelectorAll(".row")].some((one) => !one.hidden);
      const several = parts.get(title)?.startsWith("[");
      const elsewhere = title === "far_sky" && !this.spacetime.parameters.some(({ name }) => name === "throat");
      section.hidden = several || elsewhere || (!has && !OPTIONAL.includes(title));
      const box = section.querySelector(".has");
      if (box) box.checked = parts.has(title);
      const more = section.querySelector(".more");
      if (more) more.hidden = ![...more.querySelectorAll(".row")].some((one) => !one.hidden);
    }
  }

  #set(name) {
    return latest(async (value) => {
      try {
        await this.view.set(name, value);
        this.say("");
      } catch (error) {
        this.say(plain(error.message));
      }
    });
  }
  async change(edit) {
    try {
      await this.view.change(edit);
      this.say("");
    } catch (error) {
      this.say(plain(error.message));
    }
    await this.refresh();
  }

  #build(keys) {
    this.sections = new Map();
    this.spacetime = this.#section("spacetime", "Spacetime");
    this.split = this.#section("split", "Right half of the split view");
    for (const title of ORDER) {
      const own = keys.filter((key) => key.name.startsWith(`${title}.`) && TYPES.has(key.type) && !NOT_HERE.has(key.name));
      if (own.length === 0) continue;
      const body = this.#section(title, words(title), OPTIONAL.includes(title));
      const rank = (key) => (FIRST[title] ?? own.map(short)).indexOf(short(key));
      const first = own.filter((key) => rank(key) >= 0).sort((a, b) => rank(a) - rank(b)), more = own.filter((key) => rank(key) < 0);
      for (const key of first) body.append(this.#control(key));
      if (more.length > 0)
        body.append(make("details", { className: "more" }, make("summary", { textContent: "More" }), ...more.map((key) => this.#control(key))));
    }
    this.#hands();
  }
  #hands() {
    const fingers = matchMedia("(pointer: coarse)").matches;
    const rows = HANDS.map(([what, mouse, touch]) => [what, fingers ? touch : mouse]).filter(([, how]) => how !== "");
    this.place.append(make("details", { className: "section", id: "hands" }, make("summary", {}, make("span", { textContent: fingers ? "Gestures" : "Mouse and keys" })),
      make("dl", { className: "hands" }, ...rows.flatMap(([what, how]) => [make("dt", { textContent: what }), make("dd", { textContent: how })]))));
  }
  #control(key) {
    const made = MAKERS[key.type](words(short(key), key.name), key, this.#set(key.name));
    made.element.dataset.key = key.name;
    this.controls.set(key.name, made);
    return made.element;
  }
  #section(title, name, optional = false) {
    const body = make("div", { className: "body" }), summary = make("summary", {}, make("span", { textContent: name }));
    const section = make("details", { className: "section", open: OPEN.includes(title), dataset: { section: title } }, summary, body);
    if (optional) {
      const box = make("input", { type: "checkbox", className: "switch has" });
      box.setAttribute("role", "switch");
      box.setAttribute("aria-label", `${name} in the scene`);
      box.addEventListener("click", (event) => event.stopPropagation());
      box.addEventListener("change", () => {
        const wanted = box.checked;   // a refresh of a change before may set it again until the edit is made
        return this.change((parts) => (wanted ? parts.set(title, "{ }") : parts.delete(title)));
      });
      summary.append(box);
    }
    this.place.append(section);
    if (title !== "spacetime" && title !== "split") this.sections.set(title, section);
    return body;
  }

  // A metric and its parameters; null: the scene has no such section.
  #metric(title, metrics, metric, parts) {
    const body = this[title];
    body.parentElement.hidden = metric === null;
    if (metric === null) return;
    const own = entries(parts.get(title) ?? "{}"), known = metrics.find((one) => one.metric === metric);
    if (body.dataset.metric !== metric) {
      body.dataset.metric = metric;
      const had = body.contains(document.activeElement);
      const choices = metrics.filter((one) => !one.formulas || one.metric === metric).map((one) => one.metric);
      const list = choice("Metric", { choices, help: known.help }, (value) =>
        this.change((now) => now.set(title, table(new Map([["metric", value]])))));
      list.element.dataset.key = `${title}.metric`;
      list.show(metric);
      const note = make("p", { className: "note", textContent: known.help });
      body.replaceChildren(list.element, note);
      if (had) list.element.querySelector("select").focus();
      body.parameters = known.parameters.map((parameter) => {
        const key = { ...parameter, name: `${title}.${parameter.name}`, type: "number" };
        const made = number(words(parameter.name), key, this.#set(key.name));
        made.element.dataset.key = key.name;
        body.append(made.element);
        return { ...made, name: parameter.name, fallback: parameter.value };
      });
    }
    for (const { element, show, name, fallback } of body.parameters)
      if (!held(element)) show(own.get(name) ?? String(fallback));
  }
}
const short = (key) => key.name.slice(key.name.indexOf(".") + 1);
export const unquoted = (text) => text?.replace(/^["']|["']$/g, "");
