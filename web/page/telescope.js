// The panel "Telescope": what core.wasm finds of it in each picture (engine.js), as plots, and the picture through a beam.

import { make } from "./controls.js";
import { plain } from "./view.js";

const RING_NULL = 0.76547;                  // the first zero of J0, over pi: a thin ring's null times its diameter
const UAS = Math.PI / 180 / 3600e6, DEEP = 0.3;
// What a scene without mass and distance can be given here: its name in a scene file.
const OBJECTS = [["", "None: as if of M87*"], ["m87", "M87*"], ["sgr-a", "Sgr A*"], ["cygnus-x-1", "Cygnus X-1"]];
const THROUGH = ["As it is", "Through a beam", "As baselines resolve it"];
const SLIDERS = {                           // name, unit, least, most, at first, steep
  beam: ["Beam", "µas", 1, 60, 20, false, "Full width at half of the maximum: of an ellipse the longer one."],
  ratio: ["Axis ratio", "", 0.2, 1, 1, false, "The shorter width over the longer one: 1 is round."],
  turn: ["Beam angle", "°", -90, 90, 0, false, "Of the longer axis, from north (up) through east (left)."],
  longest: ["Baselines to", "Gλ", 0.5, 100, 12, true, "Thousand million wavelengths: of the curve, the plane and, if chosen, the picture."],
  angle: ["Direction", "°", 0, 180, 90, false, "Of the curve's baselines, from north (up) through east (left)."],
};
const digits = (x, n) => String(Number(x.toPrecision(n)));

// The least of 1, 2 and 5 times a power of ten that divides a length into at most so many parts.
function step(length, most) {
  const power = 10 ** Math.floor(Math.log10(length / most));
  return [1, 2, 5, 10].map((digit) => digit * power).find((size) => length <= most * size * (1 + 1e-9));
}

// A canvas with (x, y) from low to high inside of it.
class Plot {
  constructor(canvas) {
    const ratio = devicePixelRatio || 1;
    [this.width, this.height] = [canvas.clientWidth, canvas.clientHeight];
    Object.assign(canvas, { width: Math.round(this.width * ratio), height: Math.round(this.height * ratio) });
    const style = getComputedStyle(canvas);
    this.draw = canvas.getContext("2d");
    this.draw.scale(ratio, ratio);
    this.draw.font = "11px system-ui, sans-serif";
    [this.soft, this.warm, this.grid, this.cold] = [style.getPropertyValue("--soft"), style.getPropertyValue("--warm"), "#96a5be3c", "#78c8ff"];
  }
  axes(toX, lowY, highY) {
    const left = 6, right = this.width - 8, top = 6, bottom = this.height - 18;
    this.at = (x, y) => [left + x / toX * (right - left), bottom - (y - lowY) / (highY - lowY) * (bottom - top)];
    [this.top, this.bottom] = [top, bottom];
  }
  line(points, colour, width = 1) {
    this.draw.strokeStyle = colour;
    this.draw.lineWidth = width;
    this.draw.beginPath();
    for (const [x, y] of points) this.draw.lineTo(x, y);
    this.draw.stroke();
  }
  atX(x, words) {
    const [place] = this.at(x, 0), half = this.draw.measureText(words).width / 2;
    this.line([[place, this.top], [place, this.bottom]], this.grid);
    this.words(words, Math.min(Math.max(place - half, 2), this.width - 2 * half - 2), this.height - 5);
  }
  atY(toX, ...values) {
    for (const y of values) this.line([this.at(0, y), this.at(toX, y)], this.grid);
  }
  words(text, x, y, colour = this.soft) {
    this.draw.fillStyle = colour;
    this.draw.fillText(text, x, y);
  }
  dots(places, colour, size) {
    this.draw.fillStyle = colour;
    for (const [x, y] of places) this.draw.fillRect(x - size / 2, y - size / 2, size, size);
  }
}

function drawCurve(canvas, { curve, longest, minimum, source }) {
  const plot = new Plot(canvas), whole = curve[0], size = step(longest, 6);
  plot.axes(longest, 0, 1.04 * whole);
  for (let i = 0; i * size <= longest * (1 + 1e-9); ++i) plot.atX(i * size, digits(i * size, 4));
  plot.atY(longest, 0, whole / 2, whole);
  plot.line(curve.map((value, i) => plot.at(longest * i / (curve.length - 1), value)), plot.cold, 1.8);
  if (minimum) {
    const [x, y] = plot.at(...minimum);
    plot.line([[x, plot.top], [x, plot.bottom]], plot.warm);
    plot.draw.fillStyle = plot.warm;
    plot.draw.beginPath();
    plot.draw.arc(x, y, 3.5, 0, 2 * Math.PI);
    plot.draw.fill();
  }
  const words = `|V| against Gλ; top: ${source.jansky ? `${digits(whole, 3)} Jy` : "all light"}`;
  plot.words(words, plot.width - 8 - plot.draw.measureText(words).width, 16);
}

function drawPlane(canvas, { plane: [side, ...values], tracks, longest, angle }) {
  const plot = new Plot(canvas), most = Math.max(...values), pixels = new Uint8ClampedArray(4 * side * side);
  values.forEach((value, i) => pixels.set([...Array(3).fill(190 * Math.sqrt(value / most)), 255], 4 * i));
  const small = make("canvas", { width: side, height: side });
  small.getContext("2d").putImageData(new ImageData(pixels, side, side), 0, 0);
  plot.draw.drawImage(small, 0, 0, plot.width, plot.height);
  const at = (u, v) => [plot.width / 2 * (1 - u / longest), plot.height / 2 * (1 - v / longest)];
  plot.line([at(longest, 0), at(-longest, 0)], plot.grid);
  plot.line([at(0, longest), at(0, -longest)], plot.grid);
  for (const chosen of [0, 1])
    for (let i = 0; i < tracks.length; i += 3)
      if (tracks[i + 2] === chosen)
        plot.dots([at(tracks[i], tracks[i + 1]), at(-tracks[i], -tracks[i + 1])], chosen ? plot.warm : plot.cold, 2);
  const turn = angle * Math.PI / 180;
  plot.line([at(0, 0), at(longest * Math.sin(turn), longest * Math.cos(turn))], "#ffffff78");
  plot.words("E", 4, plot.height / 2 - 4, "#fff");
  plot.words("N", plot.width / 2 + 4, 12, "#fff");
}

function drawClosure(canvas, { closure, moves }) {
  const plot = new Plot(canvas), end = moves ? closure.at(-1)[0] : 24, size = moves ? step(end, 3) : 6;
  plot.axes(end, -180, 180);
  for (let i = 0; i * size <= end * (1 + 1e-9); ++i)
    plot.atX(i * size, digits(i * size, 3) + ((i + 1) * size > end * (1 + 1e-9) ? " h" : ""));
  plot.atY(end, -180, -90, 0, 90, 180);
  plot.dots(closure.map(([hours, phase]) => plot.at(hours, phase)), plot.warm, 3);
  plot.words("180°", 9, 17);
  plot.words("-180°", 9, plot.bottom - 3);
}

export class Telescope {
  // over: the canvas over the picture.
  constructor(view, place, over) {
    Object.assign(this, { view, over, shown: false, triangle: -1 });
    const canvas = (name, label) => {
      const made = make("canvas", { className: name });
      made.setAttribute("role", "img");
      made.setAttribute("aria-label", label);
      return made;
    };
    this.curve = canvas("curve", "Visibility amplitude against the baseline");
    this.plane = canvas("plane", "The plane of baselines with the tracks of the Event Horizon Telescope");
    this.closure = canvas("closure", "Closure phase against hours");
    this.said = make("p", { className: "note", id: "telescope-says" });
    this.said.setAttribute("role", "status");
    this.through = this.#list("Picture", THROUGH);
    this.objects = this.#list("Object", OBJECTS.map(([, words]) => words));
    this.objects.row.hidden = true;
    this.objects.row.title = "Whose mass and distance the scene has: they say how large it is in the sky.";
    this.triangles = this.#list("Triangle", []);
    this.sliders = Object.fromEntries(Object.entries(SLIDERS).map(([name, row]) => [name, this.#slider(name, ...row)]));
    this.figures = make("dl", { className: "figures" });
    this.found = make("div", { hidden: true }, this.through.row, ...Object.values(this.sliders).map(({ row }) => row), this.curve,
      this.figures, this.triangles.row, make("div", { className: "both" }, this.plane, this.closure), this.objects.row);
    place.append(make("h2", { textContent: "What radio telescopes measure" }), this.found, this.said);
    this.#rows();
    this.through.list.addEventListener("change", () => (this.#rows(), this.#want()));
    this.objects.list.addEventListener("change", () => {
      const [name] = OBJECTS[this.objects.list.value];
      this.given = name !== "";
      view.set("object.name", name && JSON.stringify(name)).catch((error) => (this.said.textContent = plain(error.message)));
    });
    view.addEventListener("scene", ({ detail }) => detail.what && (this.given = false));   // another one
    this.triangles.list.addEventListener("change", () => {
      this.triangle = Number(this.triangles.list.value);
      this.#want();
    });
    view.addEventListener("telescope", ({ detail }) => this.#heard(detail));
    for (const event of ["failed", "lost"]) view.addEventListener(event, () => (over.hidden = true));
  }

  // Whether the panel is open: while it is not, nothing is measured.
  async show(shown) {
    if (shown === this.shown) return;
    this.shown = shown;
    if (!shown) this.over.hidden = true;
    await this.view.ask("telescope", shown ? this.#wish() : null);
  }
  #wish() {
    const value = (name) => this.sliders[name].value();
    return [value("angle"), value("longest"), this.triangle, Number(this.through.list.value), value("beam"), value("ratio"), value("turn")];
  }
  #want() {
    if (this.shown) this.view.ask("wantOfTelescope", this.#wish()).catch(() => {});
  }
  #list(name, items) {
    const list = make("select", {}, ...items.map((textContent, value) => make("option", { value, textContent })));
    list.setAttribute("aria-label", name);
    return { list, row: make("div", { className: "row" }, make("span", { className: "name", textContent: name }), list) };
  }
  #slider(name, label, unit, low, high, first, steep, title) {
    const to = steep ? Math.log : (x) => x, from = steep ? Math.exp : (x) => x;
    const input = make("input", { type: "range", min: 0, max: 1, step: 0.001, id: `telescope-${name}` });
    const text = make("output", {}), value = () => Number(digits(from(to(low) + Number(input.value) * (to(high) - to(low))), 3));
    input.value = (to(first) - to(low)) / (to(high) - to(low));
    input.setAttribute("aria-label", label);
    const show = () => {
      text.value = `${digits(value(), 3)}${unit === "°" ? "" : " "}${unit}`.trim();
      input.setAttribute("aria-valuetext", text.value);
      input.style.setProperty("--at", input.value);
    };
    input.addEventListener("input", () => (show(), this.#rows(), this.#want()));
    show();
    return { value, row: make("div", { className: "row", title }, make("span", { className: "name", textContent: label }), text, input) };
  }
  // What means something now.
  #rows() {
    const beam = this.through.list.value === "1";
    this.sliders.beam.row.hidden = this.sliders.ratio.row.hidden = !beam;
    this.sliders.turn.row.hidden = !beam || this.sliders.ratio.value() === 1;
  }

  // found: as core.wasm has it, null where the picture is dark, or { refusal }.
  #heard(found) {
    if (!this.shown) return;
    const nothing = found === null ? "The picture is dark." : found.refusal;
    this.found.hidden = nothing !== undefined;
    if (nothing !== undefined) {
      this.said.textContent = nothing;
      this.over.hidden = true;
      return;
    }
    this.#names(found);
    drawCurve(this.curve, found);
    drawPlane(this.plane, found);
    drawClosure(this.closure, found);
    this.#figures(found);
    this.#source(found.source);
    this.#beam(found.beam);
  }
  #names({ triangles, triangle }) {
    const { list } = this.triangles;
    if (list.length !== triangles.length || (list.length > 0 && list.options[0].textContent !== triangles[0]))
      list.replaceChildren(...triangles.map((textContent, value) => make("option", { value, textContent })));
    list.value = triangle;
    this.triangle = triangle;
  }
  #figures({ curve, minimum, source }) {
    const part = minimum && minimum[1] / curve[0];
    const least = !minimum ? "" : part < 1e-4 ? "below 0.01\u00a0%" : source.jansky ? `${digits(minimum[1], 2)}\u00a0Jy` : `${digits(100 * part, 2)}\u00a0%`;
    const rows = [[minimum ? `First minimum: ${least}` : "First minimum", minimum ? `${digits(minimum[0], 4)} Gλ` : "none there"],
      ["As a thin ring", minimum && part < DEEP ? `${digits(RING_NULL / (1e9 * minimum[0]) / UAS, 4)} µas` : "not like one"]];
    this.figures.replaceChildren(...rows.map(([name, value]) =>
      make("div", {}, make("dt", { textContent: name }), make("dd", { textContent: value }))));
  }
  #source({ object, assumed, assumed_place: elsewhere, rough, uas, GHz }) {
    let words = `${assumed ? "As if of " : ""}${object}, ${digits(uas[0], 3)} x ${digits(uas[1], 3)} µas, ${GHz} GHz`;
    words += assumed ? ": the scene does not say whose it is. Choose an object above, or give its file mass_suns and distance_pc in [object]." : elsewhere ? ", at the place of M87* in the sky." : ".";
    if (rough) words += " The camera is near, moves or looks aside: the scale is rough.";
    this.said.textContent = words;
    this.objects.row.hidden = !assumed && !this.given;
    if (assumed) this.objects.list.value = 0;
  }
  // The picture through it, with the beam in the corner.
  #beam(beam) {
    this.over.hidden = !beam;
    if (!beam) return;
    const { width, height, pixels, major, minor, angle } = beam, box = this.over.getBoundingClientRect(), ratio = devicePixelRatio || 1;
    const small = make("canvas", { width, height });
    small.getContext("2d").putImageData(new ImageData(pixels, width, height), 0, 0);
    Object.assign(this.over, { width: Math.round(box.width * ratio), height: Math.round(box.height * ratio) });
    const draw = this.over.getContext("2d"), across = this.over.width;
    draw.imageSmoothingQuality = "high";
    draw.drawImage(small, 0, 0, across, this.over.height);
    const reach = major * across / 2, margin = 24 * ratio;
    draw.beginPath();
    // The longer axis from up towards the left.
    draw.ellipse(margin + reach, this.over.height - 72 * ratio - reach, minor * across / 2, reach, -angle, 0, 2 * Math.PI);
    draw.fillStyle = "#ebebeb3c";
    draw.strokeStyle = "#ebebeb";
    draw.lineWidth = 1.4 * ratio;
    draw.fill();
    draw.stroke();
  }
}
