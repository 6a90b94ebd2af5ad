"""The kinds of a scene that tests/cli/test_matrix.py combines: a few values of everything that a scene file chooses, each as the sections
that it adds. Every thing is seen by every camera, and differs from every sky."""
import math
import pathlib
import re

from image_bytes import png

WORMHOLES = ("ellis", "dneg")
FORMULAS = ("hayward", "kottler", "formula-abr")

METRICS = {
    "minkowski": {"metric": "minkowski"},
    "schwarzschild": {"metric": "schwarzschild"},
    "charged": {"metric": "reissner-nordstrom", "charge": 0.8},
    "naked": {"metric": "reissner-nordstrom", "charge": 1.2},
    "kerr": {"metric": "kerr", "spin": 0.9},
    "kerr-newman": {"metric": "kerr-newman", "spin": 0.6, "charge": 0.5},
    "neutron-star": {"metric": "neutron-star", "radius": 2.0},
    "ellis": {"metric": "ellis", "throat": 2.0},
    "dneg": {"metric": "dneg-wormhole", "throat": 2.0, "length": 0.2, "lensing_width": 0.3},
    "jnw": {"metric": "janis-newman-winicour", "gamma": 0.8},
    "hayward": {"metric": "formula", "A": "1 - r^2/(r^3 + 0.3^2)"},
    "kottler": {"metric": "formula", "A": "1 - 1/r - 0.0002*r^2/3"},
    "formula-abr": {"metric": "formula", "A": "1 - 1/r", "B": "1/((1 - 1/r)*(1 + 0.3/r^2))", "R": "r + 0.1/r"},
}

PLAIN = {"texture": "plain", "colour": [3.0, 1.2, 0.4]}
BALL = {"position": [3.6, -2.2, 0.9], "radius": 1.5, **PLAIN}
DISC = {"inner": 3.2, "outer": 7.0, **PLAIN}
THERMAL = {"inner": 3.2, "outer": 7.0, "emission": "thermal", "texture": "plain", "temperature": 7000.0, "brightness": 3.0}
MATTER = {"kind": "formula", "outer": 6.0, "steps": 128}
HOT = {"emission": "synchrotron", "frequency": 230.0}
BLOB = "exp(-((x - 3.5)^2 + (y + 1.5)^2 + (z - 0.5)^2)/1.5)"
OBJECT = {"name": "m87"}

THINGS = {
    "none": {},
    "disc": {"disc": DISC},
    "disc-image": {"disc": {"inner": 3.2, "outer": 7.0, "brightness": 3.0}},
    "disc-flow": {"disc": {**DISC, "texture": "formula", "formula": "0.5 + 0.5*x/length(x, y)", "flow": "kepler", "flow_life": 10}},
    "disc-thermal": {"disc": THERMAL},
    "disc-limb": {"disc": {**THERMAL, "limb_darkening": "on"}},
    "disc-polarised": {"disc": {**THERMAL, "polarisation": "synchrotron", "field": "toroidal"}},
    "disc-lamp": {"disc": {**THERMAL, "emissivity": "lamp", "lamp_height": 4.0}},
    "disc-gas": {"disc": {**DISC, "texture": "gas", "gas_contrast": 0.3}},
    "disc-gas-flow": {"disc": {**DISC, "texture": "gas", "gas_contrast": 0.3, "flow": "kepler", "opacity": 0.6}},
    "disc-clear": {"disc": {**DISC, "opacity": 0.4, "edge": 0.3}},
    "disc-warped": {"disc": {**DISC, "opacity": 0.7, "tilt": 20.0, "warp_radii": [3.0, 5.0, 9.0], "warp_tilts": [0.0, 25.0, 40.0], "warp_nodes": [0.0, 40.0, 60.0]}},
    "disc-rings": {"disc": {**DISC, "rings": [3.2, 4.5, 5.2, 7.0]}},
    "disc-leaning": {"disc": {**DISC, "opacity": 0.7, "tilt": 35.0, "node": 60.0}},
    "spot": {"disc": {**DISC, "opacity": 0.0, "colour": [0.0, 0.0, 0.0]}, "spot": [{"r": 4.5, "size": 0.9, "brightness": 3.0, "count": 3}]},
    "ball": {"ball": [BALL]},
    "ball-lit": {"ball": [{**BALL, "night": 0.2, "sun_longitude": 30.0, "limb": 0.4}]},
    "ball-orbit": {"ball": [{**BALL, "position": [3.6, -2.2, 0.0], "motion": "orbit"}]},
    "ball-geodesic": {"ball": [{**BALL, "position": [4.6, -3.2, 0.9], "motion": "geodesic", "velocity": [0.1, 0.0, 0.36]}]},
    "ball-path": {"ball": [{"radius": 1.5, **PLAIN, "motion": "path", "x": "3.6 + sin(0.2*t)", "y": "cos(0.2*t) - 3", "z": "0.9"}]},
    "ball-hot": {"ball": [{**BALL, "position": [3.6, -2.2, 0.0], "temperature": 5000.0}]},
    "ball-beyond": {"ball": [{**BALL, "position": [5.0, 0.0, 1.5], "radius": 2.5, "side": "far"}]},
    "balls": {"ball": [BALL, {**BALL, "position": [-4.0, 3.0, -1.0], "radius": 2.0}]},
    "sphere": {"sphere": [{"radius": 3.0, **PLAIN}]},
    "sphere-pulsing": {"sphere": [{"radius": 3.0, **PLAIN, "amplitude": 0.2, "period": 30.0}]},
    "sphere-turning": {"sphere": [{"radius": 3.0, **PLAIN, "texture": "formula", "formula": "u", "spin_rate": 0.1}]},
    "sphere-capped": {"sphere": [{"radius": 3.0, "temperature": 5000.0, "colour": [0.8, 0.9, 1.0], "spin_rate": -0.1}],
                      "cap": [{"colatitude": 60.0, "azimuth": 20.0, "radius": 40.0, "temperature": 6000.0}]},
    "cylinder": {"cylinder": [{"inner": 3.5, "outer": 6.0, "height": 0.8, **PLAIN}]},
    "surface": {"surface": [{"kind": "torus", "size": 4.5, "bound": 7.5, **PLAIN}]},
    "surface-t": {"surface": [{"shape": "length(x - 4 - sin(0.2*t), y + 2, z - 0.6) - 1.5", "bound": 8.0, **PLAIN}]},
    "disc-and-ball": {"disc": {**DISC, "opacity": 0.5}, "ball": [{**BALL, "colour": [0.3, 3.0, 0.5], "position": [3.6, -2.2, 1.8]}]},
    "gas": {"medium": {"kind": "gas", "inner": 3.2, "outer": 7.0, "thickness": 0.2, "gas_contrast": 0.0, "brightness": 3.0, "optical_depth": 2.0,
                       "step": 0.25}},
    "gas-flow": {"medium": {"kind": "gas", "inner": 3.2, "outer": 7.0, "thickness": 0.2, "gas_contrast": 0.4, "brightness": 3.0, "flow": "kepler",
                            "step": 0.5}},
    "flow": {"medium": {"kind": "flow", "radius": 3.0, "brightness": 3.0, "emissivity": 3e-18}, "object": OBJECT},
    "matter-jet": {"medium": {"kind": "jet", "inner": 2.5, "outer": 9.0, "opening": 25.0, "lorentz": 1.3, "emissivity": 1e-17, "brightness": 3.0}, "object": OBJECT},
    "matter": {"medium": {**MATTER, "density": BLOB, "emissivity": 3e-18, "brightness": 30.0, "absorption": 1e5}, "object": OBJECT},
    "matter-t": {"medium": {**MATTER, "density": "exp(-((x - 3.5)^2 + (y + 1.5)^2 + (z - sin(0.2*t))^2)/1.5)", "brightness": 30.0},
                 "object": OBJECT},
    "matter-black": {"medium": {**MATTER, "density": BLOB, "emission": "black-body", "local_temperature": "9000 - 300*r", "brightness": 3.0,
                                "velocity_east": "0.3"}},
    "matter-hot": {"medium": {**MATTER, **HOT, "density": f"3e5*{BLOB}", "local_temperature": "6e10", "field": "20",
                              "field_direction": "south", "velocity_out": "-0.2"}, "object": OBJECT},
    "matter-bands": {"medium": {**MATTER, **HOT, "frequency": [86.0, 230.0, 345.0], "density": f"3e5*{BLOB}", "local_temperature": "6e10", "field": "20",
                                "velocity_east": "0.3"}, "object": OBJECT},
    "matter-kappa": {"medium": {**MATTER, **HOT, "density": f"3e4*{BLOB}", "local_temperature": "6e10", "field": "20", "electrons": "kappa",
                                "field_direction": "out", "velocity_out": "-0.2"}, "object": OBJECT},
    "matter-grid": {"medium": {**HOT, "kind": "grid", "file": "torus.grid", "outer": 8.0, "steps": 128}, "object": OBJECT},
    "matter-and-ball": {"medium": {**MATTER, "density": BLOB, "emission": "black-body", "opacity": 0.4, "brightness": 3.0},
                        "ball": [{**BALL, "position": [1.5, 2.6, 0.5]}]},
}

SWITCHES = {"on": {}, "shift": {"shift": "off"}, "beaming": {"beaming": "off"}, "doppler": {"doppler": "off"}, "gravity": {"gravity": "off"},
            "aberration": {"aberration": "off"}, "lensing": {"lensing": "off"}, "delay": {"delay": "off"},
            "bolometric": {"band": "bolometric"}}

CAMERAS = {
    "static": {}, "moving": {"velocity": [0.1, -0.2, 0.3]}, "rain": {"observer": "rain"}, "fall": {"observer": "fall", "fall_from": 40.0},
    "throw": {"observer": "throw", "energy": 1.1}, "orbit": {"observer": "orbit"}, "counter-orbit": {"observer": "counter-orbit"},
    "zamo": {"observer": "zamo"}, "carter": {"observer": "carter", "velocity": [0.2, 0.1, 0.0]},
}

PROJECTIONS = {
    "pinhole": ({"fov": 75.0}, (32, 18)), "shifted": ({"fov": 75.0, "shift_x": 0.1, "shift_y": -0.1, "pixel_aspect": 1.2}, (32, 18)),
    "rolled": ({"fov": 75.0, "yaw": 8.0, "pitch": -5.0, "roll": 30.0}, (32, 18)), "fisheye": ({"projection": "fisheye", "fov": 130.0}, (24, 24)),
    "equirectangular": ({"projection": "equirectangular", "fov": 200.0}, (32, 18)),
    "cylindrical": ({"projection": "cylindrical", "fov": 160.0}, (32, 18)), "cube": ({"projection": "cube"}, (48, 32)),
    "warp": ({"fov": 90.0, "warp": "bent.data"}, (32, 18)),
}
# And each other of scene files.
DOCUMENTED = re.search(r"\| `camera\.projection` \|[^|]*\|[^|]*\| ([^|]+) \|", (pathlib.Path(__file__).parents[2] / "docs/scenes.md").read_text())[1]
PROJECTIONS |= {name: ({"projection": name, "fov": 150.0}, (32, 18)) for name in re.split(", | or ", DOCUMENTED) if name not in PROJECTIONS}

SKIES = {
    "black": {"kind": "black"}, "plain": {"kind": "plain", "colour": [0.1, 0.2, 0.3]},
    "formula": {"kind": "formula", "formula": "0.5 + 0.3*x - 0.2*z", "colour": [0.3, 0.4, 0.6]},
    "checker": {"kind": "checker", "columns": 4, "rows": 2, "colour": [0.1, 0.2, 0.3]},
    "image": {"kind": "image", "image": "smooth.png", "brightness": 0.3},
    "image-hot": {"kind": "image", "image": "smooth.png", "brightness": 0.3, "temperature": 6000.0},
    "nebula": {"kind": "nebula"}, "points": {"kind": "points", "uniform_stars": 300, "magnitude_limit": 0.0},
}

EXTRAS = {
    "none": {}, "split-metric": {"split": {"metric": "schwarzschild"}}, "split-flat": {"split": {"metric": "minkowski"}},
    "split-delay": {"split": {"delay": "off"}}, "zoom": {"zoom": {"depth": 2.0, "angle": 30.0}},
    "stereo": {"camera": {"stereo": "pair", "eye_distance": 0.4}}, "all-round": {"camera": {"stereo": "all-round", "eye_distance": 0.4}},
    "shutter": {"picture": {"shutter": 0.5, "sub_frames": 3}}, "samples": {"picture": {"samples": 2}}, "refine": {"picture": {"refine": "on"}},
    "shown": {"picture": {"bloom": 0.2, "auto_exposure": "on", "dither": "on", "tone": "film"}},
}

# Options of capture, and what has no ray data, layers, maps and half floats.
OPTIONS = {"shutter": ["--frames", "0:1", "--time-step", "0.6"]}
ALONE = {"split-metric", "split-flat", "split-delay", "stereo", "all-round", "shutter"}

# Skies finer than a pixel of these pictures: the shader has their mean over it, the reference one place.
COARSE = {"nebula", "points"}
ROUGH_SKIES = {"checker", "image", "image-hot"}
ROUGH_THINGS = {"disc-image", "disc-gas", "disc-gas-flow", "gas-flow"}

FACTORS = {"metric": METRICS, "thing": THINGS, "switch": SWITCHES, "camera": CAMERAS, "projection": PROJECTIONS, "sky": SKIES, "extra": EXTRAS}


def toml(value):
    if isinstance(value, str):
        return '"' + value.replace('"', '\\"') + '"'
    return str(value).lower() if isinstance(value, bool) else repr(value)


def text_of(sections):
    """A scene file of {section: {key: value}} and {section: [{key: value}, ...]}."""
    lines = [f"{key} = {toml(value)}" for key, value in sections.get("", {}).items()]
    for section, tables in sections.items():
        if section == "":
            continue
        for table in tables if isinstance(tables, list) else [tables]:
            lines.append(f"[[{section}]]" if isinstance(tables, list) else f"[{section}]")
            lines += [f"{key} = {toml(value)}" for key, value in table.items()]
    return "\n".join(lines) + "\n"


def compose(row, place):
    """The sections of a row of values of FACTORS; place: r, theta, phi of the camera, and the time."""
    r, theta, phi, time = place
    camera, size = PROJECTIONS[row["projection"]]
    sections = {"": {"time": time}, "spacetime": METRICS[row["metric"]],
                "sky": SKIES[row["sky"]], "light": SWITCHES[row["switch"]], **THINGS[row["thing"]], **EXTRAS[row["extra"]]}
    sections["camera"] = {"size": list(size), "r": r, "theta": theta, "phi": phi, **camera, **CAMERAS[row["camera"]], **EXTRAS[row["extra"]].get("camera", {})}
    sections["picture"] = {"refine": "off", **EXTRAS[row["extra"]].get("picture", {})}
    if row["metric"] in WORMHOLES:
        sections["far_sky"] = {"kind": "image", "image": "smooth.png", "brightness": 0.4}
    return sections


def write_files(folder, assets):
    """The files that the scenes name."""
    (folder / "torus.grid").write_bytes((assets / "medium/torus.grid").read_bytes())
    wave = lambda turns: round(128 + 90 * math.sin(2 * math.pi * turns))
    rows = b"".join(b"\0" + bytes(v for x in range(64) for v in (wave(x / 64), wave(x / 64 + 0.3), 255 - 7 * y)) for y in range(32))
    (folder / "smooth.png").write_bytes(png(64, 32, rows))
    nodes = [(-1 + 2 * s / 8, -1 + 2 * t / 8) for t in range(9) for s in range(9)]
    (folder / "bent.data").write_text("2\n9 9\n" + "".join(
        f"{x * 16 / 9:.6f} {y} {0.5 + 0.5 * x * (1 - 0.1 * y * y):.6f} {0.5 + 0.5 * y * (1 - 0.1 * x * x):.6f} 1\n" for x, y in nodes))


def is_rough(row):
    """Whether a thing has a pattern; a neutron star has."""
    return row["thing"] in ROUGH_THINGS or row["metric"] == "neutron-star"


def things(*beginnings):
    return {name for name in THINGS if name.startswith(beginnings)}


MATTER_THINGS = things("gas", "flow", "matter")
MOVING = {"disc-flow", "disc-gas-flow", "spot", "ball-orbit", "ball-geodesic", "ball-path", "sphere-pulsing", "sphere-turning", "sphere-capped", "surface-t"}
NO_OBJECTS = {"naked", "neutron-star", "jnw", "formula-abr"}
ROTATING = {"kerr", "kerr-newman"}
PARTS = {"doppler", "gravity", "aberration", "lensing"}
SPLITS = {"split-metric", "split-flat", "split-delay"}
ALL = set(METRICS)
WARPED = {"disc-warped", "disc-rings"}

# What is refused, and words of the message: where each factor that is named has one of the values. The rest must be drawn.
REFUSED = [
    ({"metric": NO_OBJECTS, "thing": set(THINGS) - {"none"}}, r"neither discs nor bodies|no matter along rays|is not available in|no far side|no circular orbit"),
    ({"metric": ALL - set(WORMHOLES), "thing": {"ball-beyond"}}, "has no far side"),
    ({"metric": set(WORMHOLES), "thing": {"ball-hot", "sphere-capped"}}, "how light of bodies is shifted"),
    ({"thing": {"ball-beyond"}, "extra": SPLITS}, "has no far side"),
    ({"metric": ALL - {"kerr", "minkowski"}, "thing": {"matter-grid"}}, "its matter is about a hole|no matter along rays"),
    ({"metric": {*WORMHOLES, *FORMULAS}, "thing": MATTER_THINGS}, "no matter along rays"),
    ({"metric": set(WORMHOLES), "thing": things("disc") | {"spot"}}, "no discs in a wormhole"),
    ({"metric": ROTATING, "thing": WARPED}, "rays keep to no plane"),
    ({"thing": WARPED, "extra": {"zoom"}}, "has a warp or rings"),
    ({"metric": set(WORMHOLES), "thing": things("sphere")}, "about the throat"),
    ({"metric": set(WORMHOLES), "thing": {"ball-orbit", "ball-geodesic", "ball-path"}}, "is not available in|motion is not supported in a wormhole"),
    ({"metric": {*WORMHOLES, *FORMULAS}, "thing": MOVING, "switch": set(SWITCHES) - {"delay"}}, "is not available in"),
    ({"metric": {"kerr"}, "thing": {"matter-grid"}, "extra": {"split-metric", "split-delay"}}, "its matter is about a hole"),
    ({"metric": ROTATING, "switch": PARTS}, "off, which is not supported about a rotating hole"),
    ({"metric": {"ellis", "dneg", "formula-abr", "jnw"}, "camera": {"orbit", "counter-orbit"}}, "no circular orbit"),
    ({"metric": {"minkowski", "naked", "neutron-star", "dneg"}, "extra": {"zoom"}}, "photon sphere|in the tube"),
    ({"metric": set(WORMHOLES), "thing": set(THINGS) - {"none"}, "switch": {"lensing"}}, "straight rays do not pass through a throat|no discs|about the throat|no matter|is not available in|motion is not supported"),
    ({"thing": MATTER_THINGS, "switch": PARTS}, "which a \\[medium\\] does not support"),
    ({"thing": MATTER_THINGS, "extra": {"zoom"}}, "a zoom leaves out"),
    ({"thing": {"matter-bands"}, "sky": set(SKIES) - {"black"}}, "at once, but there is a sky"),
    ({"switch": PARTS, "camera": {"rain", "fall", "throw"}}, r"while light\.\w+ is off"),
    ({"switch": {"lensing"}, "extra": {"zoom"}}, "light travels straight"),
    ({"projection": set(PROJECTIONS) - {"pinhole", "shifted", "rolled", "warp"}, "extra": SPLITS | {"zoom"}}, "requires projection|are squares"),
    ({"projection": {"warp"}, "extra": SPLITS | {"zoom", "stereo"}}, "cannot be combined with|stereo cannot be combined with camera.warp"),
    ({"projection": set(PROJECTIONS) - {"equirectangular"}, "extra": {"all-round"}}, "needs one direction for each column|stereo cannot be combined with camera.warp"),
]


def refusals(row):
    """Words of the messages of which one must come; none where the row must be drawn. A factor that the row lacks refuses nothing."""
    return [words for values, words in REFUSED if all(row.get(factor) in values[factor] for factor in values)]
