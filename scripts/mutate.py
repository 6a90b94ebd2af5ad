#!/usr/bin/env python3
"""Mutation testing: plants one mutant at a time and says whether its test catches it.

    scripts/mutate.py                 all of them, as a Markdown table; some fifteen minutes on two cores
    scripts/mutate.py --list          their names
    scripts/mutate.py NAME...         only these
    scripts/mutate.py --check         builds nothing: does the text of every mutant occur exactly once in its file, and is its test there?
    scripts/mutate.py --self-test     does --check report a text that is missing or occurs twice, and a test that is missing?
    --build FOLDER                    the build folder (default build/release), configured before

A mutant is a replacement of one piece of text in one file of shaders/ or src/. The file is changed in place, the one
program that holds the test is built and the test is run; then the file is as it was. Files with changes that are not
committed are not touched. Before that, every test has to pass without a mutant. Ends with 1 if a mutant survives: a
test is missing.
"""
import argparse
import fnmatch
import functools
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent

HARD = ("gpu_tests", "hard cases*")
GOLDEN = ("golden_tests", "every case is*")
LIMB = ("gpu_tests", "limb darkening*")
POLARISED = ("gpu_tests", "polarisation*")
STOKES = ("gpu_tests", "polarised matter*")
GAS = ("gpu_tests", "disc gas*")
GAS_LAW = ("unit_tests", "disc gas*")
LINE = ("unit_tests", "line profile*")
MATRIX = ("cli", "test_matrix.py")


class Mutant(NamedTuple):
    name: str
    what: str
    file: str
    old: str
    new: str
    test: tuple   # program, test case


MUTANTS = [Mutant(*row) for row in [
    ("sign", "a sign: sin(delta) of the ray", "shaders/core/strip.glsl",
     "float sine = tangent * factor - strip.x", "float sine = tangent * factor + strip.x", HARD),
    ("root", "a missing square root: |n x e|", "shaders/planar/trace.glsl",
     "trace.s = sqrt(dot(trace.side, trace.side));", "trace.s = dot(trace.side, trace.side);", HARD),
    ("flat-frame", "a number of the frame that is not handed on as it is", "src/shaderlib/flat_frame.cpp",
     "flat_{0} = frame.{0};", "flat_{0} = 1.001 * frame.{0};", ("gpu_tests", "uniform block*")),
    ("half-angle", "the half-angle formula that cancels", "shaders/core/strip.glsl",
     "float over = cosine > 0.0 ? a : b;\n    float under = cosine > 0.0 ? b : max(a, 1.0e-30);",
     "float over = a;\n    float under = max((1.0 + cosine) * factor, 1.0e-30);", HARD),
    ("axes-disc", "swapped texture axes: the disc's image", "shaders/object/disc_cover.glsl",
     "vec2(0.5 + turned.x, 0.5 - turned.y)", "vec2(0.5 - turned.y, 0.5 + turned.x)", GOLDEN),
    ("axes-orbit", "swapped table axes: the orbit table", "shaders/core/orbit.glsl",
     "vec4 t10 = orbit_fetch(cell.column + 1, cell.row);\n    vec4 t01 = orbit_fetch(cell.column, cell.row + 1);",
     "vec4 t01 = orbit_fetch(cell.column + 1, cell.row);\n    vec4 t10 = orbit_fetch(cell.column, cell.row + 1);",
     HARD),
    ("float-family", "float for double: the camera's place in the table", "src/table/ray_family.cpp",
     "chi0_ = inside_ ? M_PI : spacetime_->chi()->chi_from_radius(r);",
     "chi0_ = static_cast<float>(inside_ ? M_PI : spacetime_->chi()->chi_from_radius(r));", ("unit_tests", "ray family*")),
    ("float-frame", "float for double: the boost's stretch", "src/render/frame_numbers.cpp",
     "std::sqrt((1.0 + speed) / (1.0 - speed))",
     "std::sqrt((1.0f + static_cast<float>(speed)) / (1.0f - static_cast<float>(speed)))", HARD),
    ("ring-rates", "rings about a metric by formula turn as Schwarzschild's", "src/spacetime/circular_orbit.cpp",
     "return e ? -e->slope.tt / e->slope.phiphi * r * r * r : 0.0;", "return e ? 0.5 : 0.0;", ("unit_tests", "disc rate*")),
    ("throat-turn", "rays that pass a throat may turn before it", "src/table/throat_orbit.cpp",
     "if (pull.tube_slope > 0.0) {\n        if (before", "if (pull.tube_slope > 1e9) {\n        if (before", ("unit_tests", "orbit table through*next to*")),
    ("orders", "dropped image orders: two crossings and no more", "shaders/planar/disc_crossing.glsl",
     "#define DISC_MOST_CROSSINGS 12", "#define DISC_MOST_CROSSINGS 2", HARD),
    ("first-crossing", "the first crossing dropped", "shaders/planar/disc_crossing.glsl",
     ">= trace.s ? 0 : 1;", ">= trace.s ? 1 : 1;", HARD),
    ("order-number", "image orders counted in quarter turns", "shaders/stage/raydata.frag",
     "floor(data.angle * 0.31830988618379067154)", "floor(data.angle * 0.63661977236758134308)", HARD),
    ("doppler", "the frequency without the motion's part", "shaders/planar/trace.glsl",
     "frame.radial.w * trace.doppler / energy_at", "frame.radial.w / energy_at", HARD),
    ("dragging", "frame dragging with the wrong sign of L", "shaders/mino/kerr.glsl",
     "(ray.energy - ray.pull * zeta)", "(ray.energy + ray.pull * zeta)",
     ("unit_tests", "kerr: the shader core*")),
    ("tile-disc", "tiles of the disc by their corners alone", "shaders/stage/tile_disc.glsl",
     "#define TILE_SPREAD_MORE 1.25", "#define TILE_SPREAD_MORE 0.0", ("gpu_tests", "tiles: thin*")),
    ("tile-large", "bodies looked for in large tiles by rays next to their middles", "shaders/object/tile.glsl",
     "return 0.5 * tile_side() + 1.0;", "return 0.5 * float(TILE_SIDE) + 1.0;", ("gpu_tests", "tiles: balls*")),
    ("tile-first", "bodies of tiles searched from a swept angle behind their front", "shaders/planar/tile.glsl",
     "min(shown.first, phi + back)", "min(shown.first, phi + 0.1)", ("gpu_tests", "tiles: balls*")),
    ("tile-last", "bodies of tiles searched on half of the way there alone", "shaders/planar/tile.glsl",
     "shown.last = max(shown.last, phi + ahead)", "shown.last = max(shown.last, 0.5 * (phi + ahead))", ("gpu_tests", "tiles: balls*")),
    ("ball-least", "a moving ball taken to be twice as far off where bodies are listed", "shaders/object/moving_ball.glsl",
     "return (sqrt(dot(offset, offset)) - form.w - BALL", "return (2.0 * sqrt(dot(offset, offset)) - form.w - BALL",
     ("gpu_tests", "many bodies: sixty*")),
    ("lattice-probe", "lattices of light tried in the middle of each cell alone", "shaders/stage/lattice.glsl",
     "return 0.3 + 0.4 * fract(turned);", "return 0.5 + 0.0 * turned;", ("gpu_tests", "lattice: what is finer*")),
    ("lattice-error", "lattices of light believed to 10 %", "src/render/light_lattice.h",
     "kError = 5,", "kError = 100,", ("gpu_tests", "lattice: what is finer*")),
    ("tile-fit", "rays interpolated where they are not smooth", "shaders/stage/tile_fit.glsl",
     "#define TILE_SKY_ERROR 2.0e-3", "#define TILE_SKY_ERROR 1.0e-1", ("gpu_tests", "tiles: interpolated*")),
    ("warp", "the corners of a warp mesh's triangles exchanged", "shaders/effect/warp.glsl",
     "s * (b.move - a.move) + t * (c.move - a.move)", "t * (b.move - a.move) + s * (c.move - a.move)",
     ("gpu_tests", "warp*")),
    ("mino", "half of the mass in the orbit of 1/r about a rotating hole", "shaders/mino/kerr.glsl",
     "1.5 * ray.k - 2.0", "0.75 * ray.k - 2.0", ("gpu_tests", "kerr: the shadow*")),
    ("sixth-order", "one weight of the sixth-order step about a rotating hole", "shaders/mino/step.glsl",
     "f3 * (275.0 / 252.0) -", "f3 * (276.0 / 252.0) -", ("gpu_tests", "kerr methods: a shorter*")),
    ("spin-dips", "bodies about a rotating hole that a ray just touches, missed", "src/reference/first_change.h",
     "if (dip <= 0) return first_change", "if (dip <= -1) return first_change", ("unit_tests", "kerr bodies*")),
    ("spin-azimuth", "Kerr-Schild azimuth where Boyer-Lindquist is meant", "src/reference/kerr_trace.h",
     "turned(from, s, length) - chart_.ahead(r))", "turned(from, s, length) - std::atan2(chart_.a, r))",
     ("unit_tests", "kerr bodies*")),
    ("far-body", "steps to far bodies about a rotating hole ten times as far", "shaders/mino/march.glsl",
     "#define MARCH_BELOW 0.9", "#define MARCH_BELOW 9.0", ("gpu_tests", "kerr bodies*")),
    ("narrow-disc", "a narrow disc between two rays is not looked for", "shaders/planar/disc.glsl",
     "crossing.zeta_slope > 0.0 ? 1.0 : 0.0", "crossing.zeta_slope > 0.0 ? 0.0 : 0.0", ("gpu_tests", "refine: a disc*")),
    ("thin-reach", "the limit of many windings far from the critical direction, too", "shaders/planar/disc_thin.glsl",
     "#define DISC_THIN_OFF 0.2", "#define DISC_THIN_OFF 1.0e9", ("gpu_tests", "thin rings*")),
    ("thin-rings", "thin rings met by the pixel's middle only", "shaders/planar/disc_thin.glsl",
     "ring.thin = phi > frame.critical.w", "ring.thin = phi < 0.0", ("gpu_tests", "thin rings*")),
    ("handedness", "a left-handed frame", "src/render/frame_numbers.cpp",
     "cross(radial, meridian)", "cross(meridian, radial)", HARD),
    ("through", "light behind a translucent disc not dimmed", "shaders/stage/ray_light.glsl",
     "sight.through = max(sight.through - sight.through * over.a, 0.0);   // a cover is 1 to rounding\n        sight = covered", "sight = covered", GOLDEN),
    ("display", "a missing square root in the display's curve", "shaders/effect/display.glsl",
     "vec3 s1 = sqrt(c);", "vec3 s1 = c;", GOLDEN),
    ("stale", "tables kept when the camera moves", "src/render/planar_path.cpp",
     "family_->camera_r() != camera.r || !(family_->frame() == plan.observer.frame) ||\n"
     "                       (wanted.tables.orbits && !had.tables.orbits) || (wanted.tables.delays && !had.tables.delays) ||\n"
     "                       (wanted.points && !had.points) || !family_->same_cells(camera_family(plan));",
     "(wanted.tables.orbits && !had.tables.orbits) || (wanted.tables.delays && !had.tables.delays) || "
     "(wanted.points && !had.points);",
     HARD),   # the radius alone is an equivalent mutant: another radius is another w0
    ("stale-zoom", "tables kept when the view narrows", "src/render/planar_path.cpp",
     "!family_->same_cells(camera_family(plan));", "false;", HARD),
    ("nystrom", "a wrong coefficient of the integrator", "src/numeric/nystrom.h",
     "25. / 522", "25. / 525", HARD),
    ("cube", "a mirrored face of the sky", "src/sky/cube.cpp",
     "case 2: return {s, 1, t};", "case 2: return {-s, 1, t};", ("unit_tests", "cube_direction*")),
    ("roll", "a camera that rolls the wrong way", "src/observer/pose.cpp",
     "{{cr, -sr, 0}, {sr, cr, 0}, {0, 0, 1}}", "{{cr, sr, 0}, {-sr, cr, 0}, {0, 0, 1}}", ("unit_tests", "yaw turns*")),
    ("float-reference", "float for double: the reference's roots", "src/reference/schwarzschild_orbit.cpp",
     "const double psi = std::atan2(q, std::sqrt(-delta2));",
     "const double psi = static_cast<double>(static_cast<float>(std::atan2(q, std::sqrt(-delta2))));",
     ("unit_tests", "the reference meets every row*")),
    ("root-reference", "a missing square root in the reference", "src/reference/schwarzschild_orbit.cpp",
     "sinh_third(std::sqrt(start.delta2) / kCritical)", "sinh_third(start.delta2 / kCritical)",
     ("unit_tests", "the reference meets every row*")),
    ("channels", "two channels of the ray data exchanged", "src/compare/ray_channels.cpp",
     "all(p.fate, p.sky.x, p.sky.y,", "all(p.fate, p.sky.y, p.sky.x,",
     ("unit_tests", "compare: every channel*")),
    ("einstein", "the star lens of another Einstein angle", "shaders/planar/star_image.glsl",
     "0.25 * b * b + scale.x * scale.x);", "0.25 * b * b + 1.01 * scale.x * scale.x);", ("gpu_tests", "far star*")),
    ("past-a-mass", "a term of second order lost in the light time past a mass", "src/reference/light_time.cpp",
     "((2 - 1 / at) / at + a * a", "(2 / at + a * a", ("unit_tests", "light time: past*")),
    ("line-carter", "the hole's sense of rotation in Carter's constant of a distant ray", "src/spectrum/distant_light.cpp",
     "of.eta + (of.lambda - a_) * (of.lambda - a_);", "of.eta + (of.lambda + a_) * (of.lambda + a_);", LINE),
    ("line-area", "the image's area by ln r for that by r - r_horizon", "src/spectrum/disc_image.cpp",
     "2.0 / ((high_ - low_) * height);", "2.0 / ((high_ - low_) * r);", LINE),
    ("line-power", "photons by the square of g", "src/spectrum/line_profile.cpp",
     "g * g * g * emissivity", "g * g * emissivity", LINE),
    ("line-fall", "the fall inside the innermost stable orbit turned over", "src/spectrum/line_profile.cpp",
     "- p.slope * r * r / across2 * u.u_r", "+ p.slope * r * r / across2 * u.u_r", LINE),
    ("line-mean", "a cell's mean by its corners alone", "src/spectrum/line_profile.cpp",
     "(round + outward) / 12.0", "0.0 * (round + outward)", LINE),
    ("limb-motion", "the matter's motion left out of the light's angle to the disc", "shaders/planar/disc.glsl",
     "1.0e-20) * (g / g_of(trace));", "1.0e-20);", LIMB),
    ("limb-camera", "the camera's motion in the light's angle to a rotating hole's disc", "shaders/mino/disc.glsl",
     "abs(crossing.rise) / crossing.r * (g / trace.doppler)", "abs(crossing.rise) / crossing.r * g", LIMB),
    ("limb-parts", "a part of light that is off, in the light's angle to the disc", "shaders/object/disc_matter.glsl",
     "disc_cosine(trace, crossing, result.g) * parts", "disc_cosine(trace, crossing, result.g)", LIMB),
    ("polarised-mirror", "the imaginary part of Walker and Penrose's constant turned over", "shaders/core/polarisation.glsl",
     "k.y * f.z - k.z * f.y", "k.z * f.y - k.y * f.z", POLARISED),
    ("polarised-matter", "the matter's motion left out of its light's polarisation", "shaders/core/polarisation.glsl",
     "vec3 way = seen_from(u, k);", "vec3 way = vec3(k.x, k.y, k.z);", POLARISED),
    ("polarised-screen", "the turn of the screen's axes off the line of sight left out", "shaders/core/screen.glsl",
     "vec2(n.x * along.x - n.y * along.y, n.x * along.y + n.y * along.x)", "vec2(0.0)", POLARISED),
    ("polarised-camera", "the camera's motion left out of what its screen stands to", "src/observer/screen_form.cpp",
     "boost(aberration ? observer.velocity : Vec3{})", "boost(Vec3{})", POLARISED),
    ("stokes-place", "the hole's part of Walker and Penrose's constant off the plane left out", "shaders/medium/screen.glsl",
     "float turn = a * place.cosine;", "float turn = 0.0;", STOKES),
    ("stokes-frame", "the motion of Carter's frame left out", "shaders/medium/screen.glsl",
     "float f_phi = f.z - speed * f.w;", "float f_phi = f.z;", STOKES),
    ("stokes-rotation", "Faraday rotation the other way", "shaders/medium/synchrotron_stokes.glsl",
     "turn * cosine * ratios.x * rest", "-turn * cosine * ratios.x * rest", STOKES),
    ("stokes-order", "rows turned the other way", "shaders/core/stokes_transfer.glsl",
     "cross(rho, s)", "cross(s, rho)", ("unit_tests", "stokes transfer*")),
    ("stokes-moment", "a moment of the mean with the wrong factor", "shaders/core/stokes_transfer.glsl",
     "thick.m2 = by * (2.0 * thick.m1 - left);", "thick.m2 = by * (thick.m1 - left);", ("unit_tests", "stokes transfer*")),
    ("scale-lapse", "a scale bar without the lapse", "src/observer/picture_scale.cpp",
     "std::sqrt(spacetime.lapse_squared(camera.r)) /", "1.0 /", ("unit_tests", "annotations*")),
    ("scale-parsec", "a scale bar in light years", "src/annotate/annotations.cpp",
     "3.0856775814913673e16", "9.4607304725808e15", ("unit_tests", "annotations*")),
    ("object-words", "the names of two objects exchanged", "src/scenefile/scene_keys.cpp",
     "other m87 sgr-a", "other sgr-a m87", ("unit_tests", "annotations*")),
    ("scale-impact", "angles for their sines in impact parameters", "src/observer/picture_scale.cpp",
     "std::sin(std::atan(off_centre_px * per_px))", "std::atan(off_centre_px * per_px)", ("unit_tests", "annotations*")),
    ("scale-centre", "the centre a little aside", "src/observer/picture_scale.cpp",
     "Vec3{-1.0, 0.0, 0.0}", "Vec3{-1.0, 0.0, 1e-6}", ("unit_tests", "annotations*")),
    ("fits-rows", "a FITS picture upside down", "src/image/fits_file.cpp",
     "for (int y = image.height - 1; y >= 0; --y)", "for (int y = 0; y < image.height; ++y)", ("unit_tests", "fits*")),
    ("fits-planes", "the same plane three times", "src/image/fits_file.cpp",
     "image.at(x, y)[channel]", "image.at(x, y)[0]", ("unit_tests", "fits*")),
    ("fits-pixel", "FITS pixels counted from 0", "src/cli/fits_header.cpp",
     "{plane.at[0] + 0.5, height - plane.at[1] + 0.5}", "{plane.at[0] - 0.5, height - plane.at[1] - 0.5}",
     ("unit_tests", "fits*")),
    ("fits-east", "east on the right", "src/cli/fits_header.cpp",
     "{-step * kMicroarcsecond_deg, step", "{step * kMicroarcsecond_deg, step", ("unit_tests", "fits*")),
    ("fits-axis", "the spin axis turns towards the west", "src/cli/fits_header.cpp",
     "std::atan2(-step[0]", "std::atan2(step[0]", ("unit_tests", "fits*")),
    ("sphere-offsets", "offsets in a film stay where boxes came before them", "src/image/sphere_film.cpp",
     "bytes_of(offset + boxes.size(), table.width)", "bytes_of(offset, table.width)", ("unit_tests", "sphere film*")),
    ("sphere-sizes", "the box about a film's new boxes keeps its size", "src/image/sphere_film.cpp",
     "{stsd.at, entry->at}", "{entry->at}", ("unit_tests", "sphere film*")),
    ("sphere-odd", "a film says that it has the row that odd sizes lose", "src/scenefile/photo_sphere.cpp",
     "camera.height + all_down % 2", "camera.height", ("unit_tests", "sphere film*")),
    ("texts-piece", "a piece of a text ends within a character", "src/image/picture_texts.cpp",
     "continues(text[at + count])", "false", ("unit_tests", "pieces end*")),
    ("fits-object", "the sky of Earth in a picture of two cameras", "src/cli/fits_header.cpp",
     "if (several || projection", "if (projection", ("unit_tests", "fits*")),
    ("medium-ratio", "matter's light by one power of g less", "src/plan/medium.cpp",
     "light.beaming ? 3.0 : 0.0", "light.beaming ? 2.0 : 0.0", ("gpu_tests", "medium: the five*")),
    ("medium-drag", "matter does not feel the hole's rotation", "shaders/medium/circles.glsl",
     "(drag + l * around);", "(l * around);", ("gpu_tests", "medium: the five*")),
    ("medium-affine", "the affine parameter about a rotating hole as about one at rest", "shaders/medium/march.glsl",
     "at.r * at.r + az * az;", "at.r * at.r;", ("gpu_tests", "medium: the five*")),
    ("medium-edge", "a sample at the edge of matter counts whole", "shaders/medium/sphere.glsl",
     "return max(to - from, 0.0);", "return to > from ? 1.0 : 0.0;", ("gpu_tests", "medium: closed*")),
    ("medium-doppler", "matter's motion along the ray is not felt", "shaders/medium/motion.glsl",
     "medium_doppler(velocity, vec3(photon.x, photon.y, photon.z))", "sqrt(1.0 + dot(velocity, velocity))", ("gpu_tests", "medium: matter*")),
    ("medium-field", "the field's direction is that of who does not go with the matter", "shaders/medium/synchrotron.glsl",
     "medium_seen(place, matter)", "medium_photon(place).xyz", ("gpu_tests", "medium: matter*")),
    ("medium-kirchhoff", "absorption by Rayleigh and Jeans", "shaders/medium/planck.glsl",
     "return log2(t) + (x < 0.02 ? low : high);", "return log2(t);", ("gpu_tests", "medium: closed*")),
    ("list-next", "of a list's rays the first four crossings again", "shaders/stage/ray_list.glsl",
     "frame.disc_surface.w = float(listed_first);", "frame.disc_surface.w = 0.0;", ("cli", "test_trace.py")),
    ("list-meridian", "a list's rays in the first one's meridian", "src/render/light_path.cpp",
     "{world * meridian, 0},", "{world * Vec3{0, 1, 0}, 0},", ("cli", "test_trace.py")),
    ("list-shift", "light's frequency in the disc without the matter's fall", "src/render/light_path.cpp",
     "- sine * inverse_v * met.climb * u.z;", ";", ("cli", "test_trace.py")),
    ("kept-rays", "exact rays kept as moved the other way", "src/compare/remembered_trace.cpp",
     "static_cast<float>(*to[k] - *from[k]);", "static_cast<float>(*from[k] - 2.0 * *to[k]);", ("unit_tests", "compare: a frame's exact*")),
    ("flux-square", "a pixel's flux by its side", "src/cli/flux.cpp",
     "light * pixel * pixel / kJansky", "light * pixel / kJansky", ("cli", "test_astronomy.py")),
    ("flux-region", "the flux of a region without its last column", "src/cli/flux.cpp",
     "x < part[2]", "x < part[2] - 1", ("cli", "test_matter_looks.py")),
    ("grid-late", "matter of dumps is seen before its light left", "shaders/medium/grid.glsl",
     "later -= place.delay;", "later += place.delay;", ("gpu_tests", "medium slow*")),
    ("grid-clock", "dumps of Kerr and Schild's time are taken for those of t", "shaders/medium/grid.glsl",
     "float later = grid_ahead(place.r);", "float later = 0.0;", ("gpu_tests", "medium slow*")),
    ("grid-turn", "a file's azimuths are Boyer and Lindquist's", "shaders/mino/medium.glsl",
     "turned -= GRID_KERR_SCHILD * spin_winding(ray, y.w, spin_fine_at(segment.arc, s, y.w));", "turned -= 0.0;", ("gpu_tests", "medium grid*")),
    ("grid-fall", "matter of a file falls more slowly next to the horizon", "shaders/medium/grid.glsl",
     "clamp(found.first.y * fall,", "clamp(found.first.y,", ("gpu_tests", "medium grid*")),
    ("grid-seam", "no matter of a file between its last azimuth and its first", "shaders/medium/grid.glsl",
     "left + 1.0 < GRID_AROUND_COUNT ? left + 1.0 : 0.0", "min(left + 1.0, GRID_AROUND_COUNT - 1.0)", ("gpu_tests", "medium grid*")),
    ("beside-bodies", "a formula's value for a distance beside several bodies", "shaders/object/march.glsl",
     "depth / nearest.y : -nearest.x;", "depth / nearest.y : -search.value_there / nearest.y;", ("gpu_tests", "bodies: two kinds*")),
    ("spin-near", "rays next to a rotating horizon without their own digits", "src/plan/light_features.cpp",
     "rotates(f) && is_next_to_horizon(", "rotates(f) && !is_next_to_horizon(", ("gpu_tests", "kerr near*")),
    ("medium-late", "clumps where they are now", "shaders/medium/gas.glsl",
     "    age -= place.delay;\n", "", ("gpu_tests", "medium: clumps*")),
    ("medium-until", "matter behind the disc before it", "shaders/stage/ray_light.glsl",
     "walk.more ? crossing.phi : 0.0", "1.0e30", ("gpu_tests", "medium: before*")),
    ("gas-turn", "the gas turns backward", "shaders/object/disc_gas.glsl",
     "(frame.disc_gas.w - delay)", "(delay - frame.disc_gas.w)", GAS),
    ("gas-footprint", "octaves of gas finer than a pixel are drawn", "shaders/object/disc_gas.glsl",
     "        wide *= 2.0;\n", "", GAS),
    ("gas-mean", "the gas's mean light is not 1", "src/reference/disc_gas.cpp", "mean = 1 + c * c / 3", "mean = 1", GAS_LAW),
    ("gas-weights", "noise fades between the rings of gas", "src/reference/noise_ring.h",
     "((1 - s) * a + s * b) / std::sqrt(s * s + (1 - s) * (1 - s))", "(1 - s) * a + s * b", GAS_LAW),
    ("gas-seam", "the last cell of a ring of gas does not meet the first", "src/reference/noise_ring.h",
     "value((first + 1) % cells_)", "value(first + 1 < cells_ ? first + 1 : first)", GAS),
    ("matrix-switch", "beaming that cannot be switched off about a rotating hole", "src/plan/light_features.cpp",
     "return heat_if(f, f.scene.light.beaming);", "return heat_if(f, f.scene.light.beaming || !f.planar);", MATRIX),
    ("matrix-layer", "no layer of the disc's second image", "src/render/picture_layers.cpp",
     'add("disc1", PictureLayer::kDisc1, shares, 1);', "", MATRIX),
    ("matrix-kind", "no hot spots in fisheyes", "shaders/object/spot.glsl",
     "if (profile < 1.0e-6)", "if (profile < 1.0e-6 || frame.projection.x == 1.0)", MATRIX),
]]


def changed(path):
    return subprocess.run(["git", "diff", "--quiet", "HEAD", "--", path], cwd=ROOT).returncode != 0


def build(folder, target):
    return subprocess.run(["cmake", "--build", folder, "--target", target], cwd=ROOT, capture_output=True, text=True)


def run_test(folder, program, case):
    """True if the test failed, as it ought to."""
    environment = {**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"}
    environment.pop("NULLSCOPE_RUN", None)   # a test at its whole quick depth
    if program == "cli":
        command = [sys.executable, "-B", str(ROOT / "tests/cli" / case), str(Path(folder) / "bin/nullscope")]
        return subprocess.run(command, cwd=ROOT, capture_output=True, env=environment).returncode != 0
    done = subprocess.run([str(Path(folder) / "bin" / program), f"-tc={case}", "--abort-after=1"], cwd=ROOT,
                          capture_output=True, env=environment, timeout=900)
    return done.returncode != 0


def occurrences(root, mutant):
    path = root / mutant.file
    return path.read_text().count(mutant.old) if path.is_file() else 0


@functools.cache
def cases_of(root, program):
    """Names of the test cases in the folder of a program's tests, joined where they go on in the next line."""
    text = "\n".join(path.read_text() for path in sorted((root / "tests" / program.removesuffix("_tests")).glob("*.cpp")))
    return ["".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literals)) for literals in re.findall(r'TEST_CASE\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)', text)]


def has_test(root, program, case):
    if program == "cli":
        return (root / "tests/cli" / case).is_file()
    return any(fnmatch.fnmatchcase(name.lower(), case.lower()) for name in cases_of(root, program))   # as doctest's -tc matches


def check(root, mutants):
    """One line for each mutant whose text does not occur exactly once in its file, that changes nothing, or whose test is not there."""
    lost = [f"{mutant.name}: its text occurs {occurrences(root, mutant)} times in {mutant.file}"
            for mutant in mutants if occurrences(root, mutant) != 1]
    lost += [f"{mutant.name}: changes nothing" for mutant in mutants if mutant.old == mutant.new]
    return lost + [f"{mutant.name}: no test {': '.join(mutant.test)}" for mutant in mutants if not has_test(root, *mutant.test)]


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        (root / "a.txt").write_text("once twice twice")
        (root / "tests/unit").mkdir(parents=True)
        (root / "tests/unit/a.cpp").write_text('TEST_CASE("a: first "\n"part, and more" * test::costly()) {}')
        there = ("unit_tests", "a: first part*")
        samples = [Mutant(name, "", file, old, new, test) for name, file, old, new, test in [
            ("good", "a.txt", "once", "x", there), ("missing", "a.txt", "never", "x", there), ("twice", "a.txt", "twice", "x", there),
            ("no-file", "b.txt", "once", "x", there), ("equal", "a.txt", "once", "once", there),
            ("no-case", "a.txt", "once", "x", ("unit_tests", "first*")), ("no-test", "a.txt", "once", "x", ("cli", "test_a.py"))]]
        reported = [line.split(":")[0] for line in check(root, samples)]
        if reported != ["missing", "twice", "no-file", "equal", "no-case", "no-test"]:
            print(f"mutate: the self-test reported {reported}", file=sys.stderr)
            return 1
    return 0


def plant(folder, mutant):
    path = ROOT / mutant.file
    if occurrences(ROOT, mutant) != 1:
        return f"NOT PLANTED: its text occurs {occurrences(ROOT, mutant)} times"
    if changed(mutant.file):
        return "NOT PLANTED: the file has changes that are not committed"
    program, case = mutant.test
    text = path.read_text()
    try:
        path.write_text(text.replace(mutant.old, mutant.new))
        built = build(folder, "nullscope" if program == "cli" else program)
        if built.returncode != 0:
            return "NOT BUILT: " + built.stdout.strip().splitlines()[-1]
        return "caught" if run_test(folder, program, case) else "SURVIVED"
    finally:
        path.write_text(text)


def run(folder, chosen):
    for program, case in sorted({mutant.test for mutant in chosen}):
        built = build(folder, "nullscope" if program == "cli" else program)
        if built.returncode != 0 or run_test(folder, program, case):
            print(f"mutate: {program}: {case} fails without any mutant", file=sys.stderr)
            return 1
    bad = 0
    print("| mutant | where | test | |\n|---|---|---|---|", flush=True)
    for mutant in chosen:
        started = time.monotonic()
        verdict = plant(folder, mutant)
        bad += verdict != "caught"
        print(f"| {mutant.what} | {mutant.file} | {': '.join(mutant.test)} | {verdict} |", flush=True)
        print(f"mutate: {mutant.name}: {verdict} ({time.monotonic() - started:.0f} s)", file=sys.stderr, flush=True)
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("--build", default=str(ROOT / "build/release"))
    options = parser.parse_args()
    names = [mutant.name for mutant in MUTANTS]
    if options.list:
        print("\n".join(names))
        return 0
    if options.self_test:
        return self_test()
    if options.check:
        lost = check(ROOT, MUTANTS)
        print("\n".join(lost) or f"mutate: each of {len(MUTANTS)} mutants finds its text once, and its test")
        return 1 if lost else 0
    unknown = [name for name in options.names if name not in names]
    if unknown:
        print(f"mutate: no such mutant: {', '.join(unknown)}", file=sys.stderr)
        return 2
    return run(options.build, [mutant for mutant in MUTANTS if not options.names or mutant.name in options.names])


if __name__ == "__main__":
    sys.exit(main())
