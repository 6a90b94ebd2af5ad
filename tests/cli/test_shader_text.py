#!/usr/bin/env python3
"""The shader of a scene holds nothing of an effect that is off there, for every row of the effects table."""
import json
import pathlib
import re

import support

ASSETS = pathlib.Path(__file__).resolve().parents[2] / "assets"
IMAGE = ASSETS / "images" / "accretion-disc.png"
MESH = ASSETS / "warp" / "mirror.data"
GRID = ASSETS / "medium" / "torus.grid"

# Identifiers that belong to an effect, as regular expressions of whole words; members of the uniform block too.
WORDS = {
    "lensing": [r"strip\w*", r"Strip\w*", r"orbit", r"orbit_\w*", r"Orbit\w*", r"Octave", r"octave\w*", r"sweep\w*", r"series"],
    "spin": [r"spin\w*", r"Spin\w*", r"SPIN_\w*"],
    "spin-fall": [r"ingoing\w*"],
    "aberration": [r"aberrat\w*", r"Aberration", r"boost\w*", r"motion", r"stretch"],
    "disc": [r"disc(?!ard)\w*", r"Disc\w*", r"plane_\w*", r"PlaneMeeting", r"meeting"],
    "disc-image": [r"disc_texture", r"disc_texel", r"disc_filtered"],
    "disc-pattern": [r"disc_material\w*"],
    "translucent-disc": [r"fade"],
    "thermal-disc": [r"disc_matter\w*", r"DiscMatter", r"thermal\w*", r"disc_heat"],
    "shift": [r"colour_shift"],
    "beaming": [r"beaming"],
    "bolometric": [r"all_wavelengths"],
    "point-stars": [r"image_of_star", r"star_(?:lens|place|peak|make|middle)\w*", r"StarImage", r"point_stars", r"point_spread", r"image_order"],
    "sphere": [r"sphere_(?!position)\w*"],
    "cylinder": [r"cylinder\w*"],
    "ball": [r"ball\w*"],
    "surface": [r"surface\w*", r"clearance\w*"],
    "pattern": [r"pattern\w*"],
    "noise": [r"grain\w*"],
    "formula": [r"\w+_blend"],
    "body-image": [r"\w+_image", r"body_image_\d"],
    "glow": [r"(?:ball|sphere|surface|cylinder|pulse)\w*_glow", r"glow_\w+", r"rest_g", r"moving_g", r"solid_g"],
    "sky": [r"sky_texture", r"celestial\w*"],
    "sky-shift": [r"sky_(?:shift|light)"],
    "sky-pattern": [r"sky_pattern\w*"],
    "inner": [r"frame\.strip\.w"],
    "far-sky": [r"other_side\w*"],
    "bounce": [r"by_centre"],
    "bloom": [r"bloom"],
    "auto-exposure": [r"meter_texture", r"metered", r"METER_KEY"],
    "tone-film": [r"tone_film"],
    "tone-neutral": [r"tone_neutral"],
    "dither": [r"dither_noise"],
    "samples": [r"sampling_(?:first|count)"],
    "spin-ring": [r"ring_(?:barrier|peak|force|offset|settling|leaves)\w*", r"RingBarrier"],
    "spin-near": [r"near_(?:above|below|x|force|fine|log|turn)", r"NearHorizon", r"spin_near\w*"],
    "zoom": [r"ring_part", r"polar_(?:length|weight)", r"frame\.ring"],
    "cube-faces": [r"cube_(?:view|place)", r"face_(?:of|middle)", r"on_face"],
    "warp": [r"warp_\w+", r"WarpPlace", r"WarpNode", r"pixel_share", r"frame\.warp"],
    "refine": [r"edge_(?:shown|value)"],
    "star": [r"star_(?:surface|square)\w*"],
    "delay": [r"light_time", r"delay_\w+"],
    "light-times": [r"vec4 delay"],
    "disc-flow": [r"disc_(?:flow|turned|winding|orbit|rate\b)"],
    "ring-rates": [r"disc_rate_\w+"],
    "narrow-disc": [r"narrow_disc\w*"],
    "spot": [r"spot_\w+"],
    "ball-path": [r"ball_path\w*", r"moving_ball\w*"],
    "pulse": [r"pulse\w*"],
    "inner-horizon": [r"inner_horizon\w*"],
    "sides": [r"\w+_by_side", r"throat", r"end_side"],
    "limb-darkening": [r"limb_darkening", r"disc_cosine", r"disc_light"],
    "polarisation": [r"vec4 polarisation"],
    "polariser": [r"disc_polarised", r"vec4 polariser"],
    "disc-gas": [r"disc_gas\w*"],
    "disc-warp": [r"disc_warp\w*", r"warped_\w+", r"WARPED_\w+", r"DISC_WARP\w*"],
    "disc-lean": [r"leaning_\w+", r"LEANING_\w+"],
    "sphere-turn": [r"sphere_turn", r"sphere_velocity", r"SPHERE_TURN"],
    "caps": [r"cap_\w+", r"with_caps", r"CAP_\w+"],
    "medium-gas": [r"gas_(?:clumps|rim|rate)", r"GAS_(?:INNER|OUTER|THICKNESS|HEAT|RIM)"],
    "medium-motion": [r"gas_moved"],
    "medium-formula": [r"medium_formulas"],
    "medium-grid": [r"grid_\w+", r"GridNumbers", r"medium_texture"],
    "medium-black-body": [],   # JOINT has them
    "medium-synchrotron": [r"log2_synchrotron"],
    "medium-bands": [r"law_band", r"medium_bands?\w*", r"bands_colour"],
    "medium-electrons": [r"electron_(?:texture|row|scale|sine|stokes)", r"ElectronScale", r"ELECTRON_(?:FIRST|RATE|KAPPA|CELLS|MOST)"],
    "medium-polarisation": [r"medium_stokes", r"stokes_(?:rows|factors|through|turned)", r"screen_direction"],
}
# Words of any of several effects.
JOINT = {("medium-formula", "medium-grid"): [r"SPHERE_(?:RADIUS|HEIGHT|STEP)", r"medium_(?:in_sphere|inside)"], ("medium-gas", "medium-black-body"): [r"medium_glow"]}
SCENES = {
    "nothing": '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "black"\n',
    "lensing": '[sky]\nkind = "black"\n',
    "aberration": '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "black"\n[camera]\nvelocity = [0.1, 0.2, 0.3]\n',
    "disc": '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "black"\n[disc]\n',
    "translucent-disc": '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "black"\n[disc]\nopacity = 0.5\n',
    "thermal-disc": '[sky]\nkind = "black"\n[disc]\nemission = "thermal"\n[light]\nshift = "off"\nbeaming = "off"\n',
    "shift": '[sky]\nkind = "black"\n[disc]\nemission = "thermal"\n[light]\nbeaming = "off"\n',
    "zoom": '[sky]\nkind = "black"\n[zoom]\n',
    "beaming": '[sky]\nkind = "black"\n[disc]\nemission = "thermal"\n[light]\nshift = "off"\n',
    "bolometric": '[sky]\nkind = "black"\n[disc]\nemission = "thermal"\n[light]\nband = "bolometric"\n',
    "point-stars": '[sky]\nkind = "points"\neven_stars = 10\n[light]\nshift = "off"\n',
    "sky": '[spacetime]\nmetric = "minkowski"\n',
    "sky-shift": '[camera]\nvelocity = [0.1, 0.2, 0.3]\n[sky]\ntemperature = 5000\n',
    "lensing, disc": '[sky]\nkind = "black"\n[disc]\n',
    "lensing, sky": '[spacetime]\nmetric = "schwarzschild"\n',
    "sphere": '[sky]\nkind = "black"\n[sphere]\n',
    "cylinder": '[sky]\nkind = "black"\n[cylinder]\n',
    "ball": '[sky]\nkind = "black"\n[ball]\n',
    "surface": '[sky]\nkind = "black"\n[surface]\n',
    "pattern": '[sky]\nkind = "black"\n[sphere]\ntexture = "grid"\n',
    "noise": '[sky]\nkind = "black"\n[cylinder]\ntexture = "noise"\n',
    "formula": '[sky]\nkind = "black"\n[ball]\ntexture = "formula"\nformula = "u"\n',
    "body-image": '[sky]\nkind = "black"\n[sphere]\ntexture = "image"\nimage = "IMAGE"\n',
    "glow": '[sky]\nkind = "black"\n[sphere]\ntemperature = 6000\n[light]\nshift = "off"\n',
    "sphere-turn": '[sky]\nkind = "black"\n[sphere]\ntexture = "checker"\nspin_rate = 0.1\n',
    "caps": '[sky]\nkind = "black"\n[sphere]\ntemperature = 6000\n[cap]\n',
    "spin, sphere-turn, caps": '[spacetime]\nmetric = "kerr"\n[sphere]\ntemperature = 6000\nspin_rate = 0.1\n[cap]\n[light]\ndelay = "off"\n',
    "everything": '[camera]\nvelocity = [0.1, 0.2, 0.3]\n[disc]\nedge = 0.2\n[sphere]\ntexture = "checker"\n'
                  '[cylinder]\ntexture = "noise"\n[ball]\ntexture = "formula"\nformula = "u"\n',
    "ring-rates": '[spacetime]\nmetric = "formula"\nA = "1 - 1/r"\n[sky]\nkind = "black"\n[disc]\nflow = "kepler"\n[light]\ndelay = "off"\n',
    "narrow-disc": '[camera]\ntheta = 90.1\n[sky]\nkind = "black"\n[disc]\n',
    "spin, narrow-disc": '[spacetime]\nmetric = "kerr"\n[camera]\ntheta = 89.9\n[sky]\nkind = "black"\n[disc]\n',
    "inner": '[spacetime]\nmetric = "ellis"\n[sky]\nkind = "black"\n[far_sky]\nkind = "black"\n',
    "far sky": '[spacetime]\nmetric = "ellis"\n[sky]\nkind = "black"\n',
    "bounce": '[spacetime]\nmetric = "reissner-nordstrom"\ncharge = 1.2\n[sky]\nkind = "black"\n',
    "bloom": '[picture]\nbloom = 0.1\n',
    "auto-exposure": '[picture]\nauto_exposure = "on"\ntone = "film"\n',
    "tone-film": '[spacetime]\nmetric = "minkowski"\n[picture]\ntone = "film"\n',
    "samples": '[spacetime]\nmetric = "minkowski"\n[picture]\nsamples = 2\n',
    "tone-neutral": '[spacetime]\nmetric = "minkowski"\n[picture]\ntone = "neutral"\ndither = "on"\n',
    "disc-pattern": '[sky]\nkind = "black"\n[disc]\ntexture = "plain"\n',
    "sky-pattern": '[spacetime]\nmetric = "minkowski"\n[sky]\nkind = "plain"\n',
    "sky and disc": '[sky]\nkind = "grid"\n[disc]\ntexture = "noise"\n',
    "sky and far sky": '[spacetime]\nmetric = "ellis"\n[sky]\nkind = "formula"\nformula = "u * x"\n',
    "spin": '[spacetime]\nmetric = "kerr"\n[sky]\nkind = "black"\n',
    "spin, spin-fall, spin-near": '[spacetime]\nmetric = "kerr"\n[camera]\nobserver = "rain"\nr = 0.8\n[sky]\nkind = "black"\n',
    "spin, spin-ring, zoom": '[spacetime]\nmetric = "kerr"\n[sky]\nkind = "black"\n[zoom]\n',
    "spin, disc, sky": '[spacetime]\nmetric = "kerr"\n[camera]\nvelocity = [0.1, 0.2, 0.3]\n[disc]\nemission = "thermal"\n',
    "disc-warp": '[sky]\nkind = "black"\n[disc]\nwarp_radii = [3, 9]\nwarp_tilts = [0, 20]\nwarp_nodes = [0, 30]\nrings = [3, 5, 7, 12]\n',
    "spin, disc-lean": '[spacetime]\nmetric = "kerr"\n[disc]\nemission = "thermal"\ntilt = 30\n',
    "limb-darkening": '[sky]\nkind = "black"\n[disc]\nemission = "thermal"\nlimb_darkening = "on"\n',
    "spin, limb-darkening": '[spacetime]\nmetric = "kerr"\n[disc]\nemission = "thermal"\nlimb_darkening = "on"\n',
    "spin, medium-polarisation": '[spacetime]\nmetric = "kerr"\n[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\nkind = "formula"\nemission = "synchrotron"\nfield_direction = "south"\npolarisation = "on"\n',
    "spin, medium-electrons": '[spacetime]\nmetric = "kerr"\n[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\nkind = "formula"\nemission = "synchrotron"\nelectrons = "kappa"\n',
    "medium-polarisation, polariser": '[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\nkind = "flow"\nemission = "synchrotron"\nfield_direction = "east"\npolarisation = "on"\n[picture]\npolariser = 20\n',
    "spin, medium-bands": '[spacetime]\nmetric = "kerr"\n[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\nkind = "formula"\nemission = "synchrotron"\nfrequency = [86, 230, 345]\n',
    "medium-bands": '[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\nkind = "flow"\nfrequency = [86, 230]\n',
    "polarisation": '[sky]\nkind = "black"\n[disc]\nemission = "thermal"\npolarisation = "scattering"\n',
    "polariser": '[disc]\nemission = "thermal"\npolarisation = "synchrotron"\n[picture]\npolariser = 30\n',
    "spin, polariser": '[spacetime]\nmetric = "kerr"\n[disc]\nemission = "thermal"\npolarisation = "scattering"\n[picture]\npolariser = 30\n[spot]\n[light]\ndelay = "off"\n',
    "no spin": '[spacetime]\nmetric = "kerr"\nspin = 0.0\n[disc]\n',
    "spin, patterns": '[spacetime]\nmetric = "kerr"\n[sky]\nkind = "grid"\n[disc]\ntexture = "checker"\n',
    "spin, points": '[spacetime]\nmetric = "kerr"\n[camera]\nvelocity = [0.1, 0.2, 0.3]\n[sky]\nkind = "points"\neven_stars = 10\n',
    "cube-faces, points": '[camera]\nprojection = "cube"\nsize = [36, 24]\n[sky]\nkind = "points"\neven_stars = 10\n',
    "fisheye, warp": '[camera]\nprojection = "fisheye"\nwarp = "WARP"\n',
    "spin, cylindrical": '[spacetime]\nmetric = "kerr"\n[camera]\nprojection = "cylindrical"\n[sky]\nkind = "black"\n',
    "star": '[spacetime]\nmetric = "neutron-star"\n',
    "delay, flow, spot": '[sky]\nkind = "black"\n[disc]\ntexture = "noise"\nflow = "kepler"\n[spot]\n',
    "inner horizon": '[spacetime]\nmetric = "reissner-nordstrom"\ncharge = 0.8\n[sky]\nkind = "black"\n[disc]\nflow = "kepler"\n',
    "disc-gas": '[sky]\nkind = "black"\n[disc]\ntexture = "gas"\n',
    "gas that flows": '[disc]\ntexture = "gas"\nemission = "thermal"\nflow = "kepler"\nedge = 0.2\n',
    "spin, medium-gas": '[spacetime]\nmetric = "kerr"\n[sky]\nkind = "black"\n[medium]\n',
    "medium-motion": '[sky]\nkind = "black"\n[medium]\nflow = "kepler"\n',
    "medium-formula": '[sky]\nkind = "black"\n[object]\nname = "sgr-a"\n[medium]\nkind = "formula"\ndensity = "1/r"\n',
    "spin, medium-grid": '[spacetime]\nmetric = "kerr"\nspin = 0.9\n[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\nkind = "grid"\nfile = "GRID"\n',
    "medium-black-body": '[sky]\nkind = "black"\n[medium]\nkind = "formula"\nemission = "black-body"\n',
    "spin, medium-synchrotron": '[spacetime]\nmetric = "kerr"\n[sky]\nkind = "black"\n[object]\nname = "m87"\n[medium]\nkind = "formula"\nemission = "synchrotron"\nfield_direction = "south"\n',
    "flow without delay": '[disc]\nflow = "kepler"\n[light]\ndelay = "off"\n',
    "delay, ball, sphere, surface": '[sky]\nkind = "black"\n[ball]\nmotion = "orbit"\n[sphere]\nswing = 0.1\n[surface]\nshape = "x^2 + y^2 + z^2 - 9 - sin(t)"\n',
    "flat and moving": '[spacetime]\nmetric = "minkowski"\n[ball]\nmotion = "path"\nx = "5"\ny = "t"\nz = "0"\n[disc]\n[spot]\n',
    "sides": '[spacetime]\nmetric = "ellis"\n[sky]\nkind = "black"\n[ball]\nside = "far"\n[cylinder]\n',
}


def choices(key):
    row = re.search(rf"\| `{key}` \|[^|]*\|[^|]*\| ([^|]+) \|", (ASSETS.parent / "docs/scenes.md").read_text())
    return set(re.split(", | or ", row[1]))


# Projections and models of matter along rays that are not above: words begin with their names, and the scene is the name alone.
PROJECTIONS = choices(r"camera\.projection") - {"pinhole", "cube"}
WORDS |= {name: [rf"{name}_(?:view|place)"] for name in PROJECTIONS}
SCENES |= {name: f'[camera]\nprojection = "{name}"\n' for name in PROJECTIONS}
MODELS = choices(r"medium\.kind")
WORDS |= {f"medium-{model}": [rf"{model.upper()}_\w+"] for model in MODELS if f"medium-{model}" not in WORDS}
SCENES |= {f"medium-{model}": f'[sky]\nkind = "black"\n[object]\nname = "sgr-a"\n[medium]\nkind = "{model}"\n' for model in MODELS - {"grid", "formula"}}


def words_in(code, effect):
    return sorted({w for pattern in WORDS[effect] for w in re.findall(rf"\b{pattern}\b", code)})


class ShaderText(support.CliTest):
    @support.costly
    def test_nothing_of_an_effect_that_is_off(self):
        seen_on = set()
        for name, text in SCENES.items():
            scene = self.write("scene.toml", text.replace("IMAGE", str(IMAGE)).replace("WARP", str(MESH)).replace("GRID", str(GRID)))
            plan = json.loads(self.run_nullscope("plan", scene, "--json").out)
            on = {e["effect"] for e in plan["effects"]}
            off = {e["effect"] for e in plan["left_out"]}
            self.assertEqual(on | off, set(WORDS), "an effect has no words here: add them")
            code = re.sub(r"^// .*", "", self.run_nullscope("capture", scene, "--dump-shader").out, flags=re.M)   # files' names
            for effect in sorted(off - ({"samples"} if "refine" in on else set())):   # that has several rays a pixel too
                self.assertEqual(words_in(code, effect), [], f"{effect} is off in scene '{name}'")
            for effects, patterns in JOINT.items():
                found = [w for pattern in patterns for w in re.findall(rf"\b{pattern}\b", code)]
                self.assertEqual(bool(found), not on.isdisjoint(effects), f"{effects} in scene '{name}': {found}")
            for effect in sorted(effect for effect in on if WORDS[effect]):
                self.assertTrue(words_in(code, effect), f"{effect} is on in scene '{name}', without its words")
            seen_on |= on
            self.assertNotRegex(code, r"#\s*if|EFFECT_", f"unresolved branches in scene '{name}'")
        self.assertEqual(seen_on, set(WORDS))

    def test_the_dump_is_what_plan_measures(self):
        dump = self.run_nullscope("capture", "first-light", "--dump-shader").out
        shader = json.loads(self.run_nullscope("plan", "first-light", "--json").out)["shader"]
        self.assertEqual((len(dump.encode()), dump.count("\n")), (shader["bytes"], shader["lines"]))


if __name__ == "__main__":
    support.main()
