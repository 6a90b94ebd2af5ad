"""What is compared: scenes, and for each what the other program draws. Its shaders are read from its checkout; of ours are only the constants
that it leaves to who uses it, and, where its own disc is not what the scene shows, another function of the disc's light (rows "image", "plain").
"""
import functools
import json
import math
import re
import struct
import tomllib
from dataclasses import dataclass
from pathlib import Path

import checkouts

ROOT = Path(__file__).resolve().parents[2]
SHADERS = ("definitions.glsl", "functions.glsl", "model.glsl")
DEMO = "black_hole/demo/camera_view"
FACE = 2048                # texels a side of a face of its sky; nullscope's at these fields of view
GRID = (512, 32, 4)        # its sky with a grid: texels of a face, of a cell, of a line
TEMPERATURE = 4500.0       # K, of a disc whose scene has none
RING_STEP = 0.75           # r_s between the orbits of its disc's particles
ECCENTRICITIES = (0.02, 0.07, 0.04, 0.09, 0.01, 0.06)   # of these orbits, in turn: at random, from 0 to 0.1, in its demo


@dataclass(frozen=True)
class Row:
    name: str
    scene: str
    disc: str           # own, none, image, or plain: a black body without structure
    sky: str            # image: nullscope's own; grid; black
    peer: str           # in words
    doppler: bool = False   # whether nullscope's scene has shifts
    fetch: bool = False

    @property
    def alike(self):
        """Whether the two pictures have the same light at every place."""
        return self.disc in ("none", "image") and not self.fetch

    @property
    def path(self):
        own = Path(__file__).with_name(f"{self.scene}.toml")
        return own if own.exists() else ROOT / "assets/scenes" / f"{self.scene}.toml"


ROWS = (
    Row("fetch", "sky-only", "none", "image", "one fetch of the cube map a pixel, light straight", fetch=True),
    Row("sky", "sky-only", "none", "image", "the same sky, its disc and stars compiled out"),
    Row("pattern", "disc-grid", "own", "grid", "its grid on the disc and on the sky"),
    Row("image", "image-disc", "image", "black", "the same image on its disc, no sky"),
    Row("image-sky", "first-light", "image", "image", "the same image on its disc, the same sky"),
    Row("first-light", "first-light", "own", "image", "its disc of particles and noise, the same sky"),
    Row("plain-thermal", "luminet", "plain", "black", "a black body by its table, shifted, without particles and noise", doppler=True),
    Row("thermal", "luminet", "own", "black", "its black-body disc of particles and noise, shifted", doppler=True),
)

DISC_OF = {
    "none": "vec4 DiscColor(vec2 p, float t, bool top_side, float doppler_factor) { return vec4(0.0); }\n",
    "image": """
uniform sampler2D disc_image;
vec4 DiscColor(vec2 p, float t, bool top_side, float doppler_factor) {
  vec2 place = vec2(0.5) + vec2(p.x, -p.y) * (0.5 / OUTER_DISC_R);
  return vec4(disc_params.x * texture(disc_image, place).rgb, disc_params.y);
}
""",
    "plain": """
vec4 DiscColor(vec2 p, float t, bool top_side, float doppler_factor) {
  float r = max(length(p), INNER_DISC_R);
  float flux = (1.0 - sqrt(INNER_DISC_R / r)) / (r * r * r);
  float temperature = disc_params.z * pow(flux * (1.0 / HOTTEST_FLUX), 0.25) * doppler_factor;
  return vec4(disc_params.x * BlackBodyColor(black_body_texture, max(temperature, 100.0)), disc_params.y);
}
""",
}
FETCH = """
in vec3 view_dir;
uniform vec3 e_w, e_h, e_d;
uniform samplerCube galaxy_cube_texture;
layout(location = 0) out vec4 frag_color;
void main() { frag_color = vec4(GAIN * texture(galaxy_cube_texture, view_dir.x * e_w + view_dir.y * e_h + view_dir.z * e_d).rgb, 1.0); }
"""


def scene_of(row):
    """Its sections. The camera must be at rest and look at the centre, as the harness's does."""
    scene = tomllib.loads(row.path.read_text())
    turned = {"yaw", "pitch", "observer", "velocity", "projection"} & scene["camera"].keys()
    if turned or scene.get("spacetime", {}).get("metric", "schwarzschild") != "schwarzschild":
        raise SystemExit(f"peer: {row.path}: a camera at rest that looks at the hole of Schwarzschild is needed, not {', '.join(turned)}")
    return scene


def ring(number, inner):
    """An orbit of a particle: 1/r at its ends, its first azimuth, and how many periods of 1/r = u1 + (u2 - u1) sin^2 go to a turn: with
    complete elliptic integrals K = pi/2 over the arithmetic-geometric mean of 1 and sqrt(1 - k^2), k^2 = (u2 - u1)/(u3 - u1)."""
    near = inner + number * RING_STEP
    eccentricity = ECCENTRICITIES[number % len(ECCENTRICITIES)]
    u2 = 1.0 / near
    u1 = u2 * (1.0 - eccentricity) / (1.0 + eccentricity)
    u3 = 1.0 - u1 - u2
    a, b = 1.0, math.sqrt((u3 - u2) / (u3 - u1))
    while abs(a - b) > 1e-12:
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    quarter = 0.5 * math.pi / a
    return u1, u2, number * 2.399963 % (2.0 * math.pi), math.pi * math.sqrt(u3 - u1) / (4.0 * quarter)


def constants(row, scene, doppler):
    """What the other program expects to be defined before its shaders."""
    inner, outer = scene.get("disc", {}).get("inner", 3.0), scene.get("disc", {}).get("outer", 12.0)
    rings = [ring(i, inner) for i in range(math.ceil((outer - inner) / RING_STEP))]
    orbits = ", ".join(f"vec4({', '.join(f'{v:.7f}' for v in orbit)})" for orbit in rings)
    hottest = max((1.0 - math.sqrt(inner / r)) / r ** 3 for r in (inner + 0.001 * i for i in range(10000)))
    values = {
        "int RAY_DEFLECTION_TEXTURE_WIDTH": 512, "int RAY_DEFLECTION_TEXTURE_HEIGHT": 512,
        "int RAY_INVERSE_RADIUS_TEXTURE_WIDTH": 64, "int RAY_INVERSE_RADIUS_TEXTURE_HEIGHT": 32,
        "float STARS_CUBE_MAP_SIZE": float(FACE), "float MAX_FOOTPRINT_SIZE": 4.0, "float MAX_FOOTPRINT_LOD": 6.0,
        "float pi": math.pi, "float rad": 1.0, "float INNER_DISC_R": float(inner), "float OUTER_DISC_R": float(outer),
        "float HOTTEST_FLUX": hottest, "int NUM_DISC_PARTICLES": len(rings),
        f"vec4 DISC_PARTICLE_PARAMS[{len(rings)}]": f"vec4[{len(rings)}]({orbits})"}
    return f"""#version 330 core
precision highp float;
#define IN(x) const in x
#define OUT(x) out x
#define LENSING 1
#define DOPPLER {int(doppler)}
#define GRID {int(row.sky == "grid")}
#define STARS 0
""" + "".join(f"const {name} = {value};\n" for name, value in values.items())


def sky_unit(demo):
    """What its shader multiplies texels of the sky by."""
    found = re.search(r"texture\(galaxy_cube_texture, dir\)\.rgb \* ([\d.e+-]+)", demo)
    if found is None:
        raise SystemExit("peer: fragment_shader.glsl does not scale its sky as expected")
    return float(found[1])


def shaders(row, scene, checkout, doppler):
    """Texts of its vertex and fragment shader, and the unit of its sky."""
    plain = lambda path: re.sub(r"/\*.*?\*/", "", (checkout / path).read_text(), flags=re.S)
    vertex = "#version 330 core\n" + plain(f"{DEMO}/vertex_shader.glsl")
    demo = plain(f"{DEMO}/fragment_shader.glsl")
    unit = sky_unit(demo)
    if row.fetch:
        return vertex, f"#version 330 core\n#define GAIN {unit}\n{FETCH}", unit
    text = constants(row, scene, doppler) + "".join(plain(f"black_hole/{name}") for name in SHADERS)
    others = {"DiscColor": DISC_OF.get(row.disc), "GalaxyColor": "vec3 GalaxyColor(vec3 dir) { return vec3(0.0); }\n" if row.sky == "black" else None}
    replaced = {name: body for name, body in others.items() if body is not None}
    text += "".join(f"#define {name} Demo{name}\n" for name in replaced) + demo + "".join(f"#undef {name}\n" for name in replaced)
    return vertex, text + "".join(replaced.values()), unit


def density(black_body, temperature, brightness):
    """So that its black body of that temperature has the brightness of nullscope's hottest ring."""
    values = struct.unpack(f"<{3 * 128}f", black_body.read_bytes())
    at = min(127, int(128 * math.log(temperature / 100.0) / 6.0))
    return brightness / max(values[3 * at:3 * at + 3])


@functools.cache
def sky_picture(path, folder, binary):
    """nullscope's sky, turned and dimmed as in the scene, as the six faces of a cube about a camera in flat space."""
    text = '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 20.0\ntheta = 90.0\nprojection = "cube"\n[picture]\nrefine = "off"\n[sky]\n'
    text += "".join(f"{key} = {json.dumps(value)}\n" for key, value in tomllib.loads(path.read_text()).get("sky", {}).items())
    flat, picture = folder / f"{path.stem}-sky.toml", folder / f"{path.stem}-sky.png"
    flat.write_text(text)
    checkouts.ran(binary, "capture", flat, "--size", f"{3 * FACE}x{2 * FACE}", "--quiet", "-o", picture)
    return picture


def settings(row, checkout, folder, options):
    """Writes what the harness reads and returns its path."""
    scene = scene_of(row)
    camera, disc = scene["camera"], scene.get("disc", {})
    vertex, fragment, unit = shaders(row, scene, checkout, row.doppler or options.doppler)
    tables = checkout / "output/black_hole/demo"
    temperature, brightness = disc.get("temperature", TEMPERATURE), disc.get("brightness", 1.0)
    if row.disc not in ("image", "none"):
        brightness = density(tables / "black_body.dat", temperature, brightness)
    lines = {
        "size": options.size.split("x"), "frames": [options.frames], "warm_up": [options.warm_up],
        "seamless": [int(not options.seams)],
        "vertex": [folder / f"{row.name}.vert"], "fragment": [folder / f"{row.name}.frag"],
        "deflection": [tables / "deflection.dat"], "inverse_radius": [tables / "inverse_radius.dat"],
        "black_body": [tables / "black_body.dat"], "doppler": [tables / "doppler.dat"],
        "noise": [checkout / "color_maps/noise_texture.png"], "disc": [brightness, disc.get("opacity", 1.0), temperature],
        "camera": [camera["r"], camera["theta"], camera.get("phi", 0.0), camera.get("roll", 0.0), camera["fov"]]}
    lines["vertex"][0].write_text(vertex)
    lines["fragment"][0].write_text(fragment)
    if row.disc == "image":
        image = disc.get("image")
        lines["image"] = [(row.path.parent / image).resolve() if image else ROOT / "assets/images/accretion-disc.png"]
    if row.sky == "image":
        lines["sky"] = [sky_picture(row.path, folder, options.binary), 1.0 / unit]
    if row.sky == "grid":
        lines["sky_grid"] = GRID
    path = folder / f"{row.name}.settings"
    path.write_text("".join("\t".join([key, *(str(value) for value in values)]) + "\n" for key, values in lines.items()))
    return path
