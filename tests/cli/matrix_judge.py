"""What must hold of the files of one scene: tests/cli/test_matrix.py."""
import math

import support

COLOURS = "RGB"
FLOAT_STEP = 2.0 ** -24


def finite(channels, what):
    """No value is NaN or infinite, and no light negative."""
    wrong = [f"{what}: {name} is not finite" for name, rows in channels.items() if not all(math.isfinite(v) for row in rows for v in row)]
    lights = [name for name in channels if name in COLOURS or name.endswith((".R", ".G", ".B", ".A"))]
    return wrong + [f"{what}: {name} is negative, {min(map(min, channels[name])):g}" for name in lights if min(map(min, channels[name])) < 0]


def same(a, b, what, names=COLOURS):
    different = sum(x != y for name in names for p, q in zip(a[name], b[name]) for x, y in zip(p, q))
    return [f"{what}: {different} values differ from the picture alone"] if different else []


def around(rows, x, y):
    """Values of a pixel and its neighbours."""
    return [row[i] for row in rows[max(0, y - 1):y + 2] for i in range(max(0, x - 1), min(len(row), x + 2))]


# Within a thing a pixel is as bright as the exact one; at edges, or where there is more in a pixel than one ray shows, it may have any
# brightness of the exact one's neighbours: the shader covers parts of pixels and averages textures, the reference looks in the middle.
SLACK = 0.03         # of the pixel itself
GROUND = 0.006       # of the brightest pixel
OUTLIERS = 0.05      # share of the pixels: images thinner than a pixel, which the shader widens and the reference meets or misses (0.033 measured)
BIAS = 0.02          # of the mean light of all pixels, beside what edges may add: each by chance up to a half of its height


def inner_pixels(exact, smooth_sky=True):
    """Whether a pixel and its neighbours show the same thing, and one that is even over a pixel: of a picture with ray data."""
    def inner(x, y):
        return all(len(set(around(exact[name], x, y))) == 1 for name in ("fate", "hit", "order")) and (smooth_sky or exact["hit"][y][x] > 0)
    return inner


ROUGH = 4            # times those two, where a thing has a pattern: one ray's mean of it, of 4 x 4 rays 0.3 % from the reference's


def pictures_agree(got, exact, what, inner=lambda x, y: False, rough=False):
    wrong = []
    most = max(1e-3, *(max(map(max, exact[c])) for c in COLOURS))
    for c in COLOURS:
        rows, off, edges = exact[c], 0, 0.0
        for y, row in enumerate(got[c]):
            for x, value in enumerate(row):
                near = [rows[y][x]] if inner(x, y) else around(rows, x, y)
                low, high = min(near), max(near)
                edges += (high - low) ** 2
                off += not (1 - SLACK) * low - GROUND * most <= value <= (1 + SLACK) * high + GROUND * most
        size = len(rows) * len(rows[0])
        sum_, other = sum(map(sum, rows)), sum(map(sum, got[c]))
        if off > OUTLIERS * size * (ROUGH if rough else 1):
            wrong.append(f"{what}: {off} of {size} pixels of {c} are off")
        if abs(other - sum_) > BIAS * sum_ * (ROUGH if rough else 1) + 0.75 * math.sqrt(edges) + 1e-3 * most * size:
            wrong.append(f"{what}: the sum of {c} is {other:.5g}, exact {sum_:.5g}, by edges {math.sqrt(edges):.3g}")
    return wrong


def is_seen(got, without):
    """Whether four pixels of a picture differ from the one without a thing."""
    most = max(1e-3, *(max(map(max, got[c])) for c in COLOURS))
    return max(sum(abs(a - b) > 0.01 * most for p, q in zip(got[c], without[c]) for a, b in zip(p, q)) for c in COLOURS) >= 4


def sums_agree(got, exact, what, most=2.5):
    """Where the sky has more in it than the pixels show: all light, to a factor."""
    sums = {c: (sum(map(sum, got[c])), sum(map(sum, exact[c]))) for c in COLOURS}
    return [f"{what}: the sum of {c} is {a:.5g}, exact {b:.5g}" for c, (a, b) in sums.items() if not b / most <= a <= b * most]


def numbers_agree(got, exact, name, what, outliers=OUTLIERS):
    """Whole numbers of pixels (fate, hit): equal, or as a neighbour of the exact one."""
    off = [(x, y) for y, row in enumerate(got[name]) for x, value in enumerate(row)
           if value != exact[name][y][x] and value not in around(exact[name], x, y)]
    size = len(got[name]) * len(got[name][0])
    return [f"{what}: {name} of {len(off)} of {size} pixels is off, as {got[name][off[0][1]][off[0][0]]:g} instead of "
            f"{exact[name][off[0][1]][off[0][0]]:g} at {off[0]}"] if len(off) > outliers * size else []


def values_agree(got, exact, names, where, most, what, outliers=0.08):
    """Of the pixels that `where` chooses, all but a share of outliers are within `most`."""
    errors = [max(abs(got[name][y][x] - exact[name][y][x]) for name in names)
              for y, row in enumerate(got[names[0]]) for x in range(len(row)) if where(x, y)]
    off = [e for e in errors if not e <= most]
    return [f"{what}: {'/'.join(names)} of {len(off)} of {len(errors)} pixels is off, by up to {max(off):.3g}"] if len(off) > 1 + outliers * len(errors) else []


def rays_agree(got, exact, what):
    got = support.as_ray_data(got)
    wrong = numbers_agree(got, exact, "fate", what) + numbers_agree(got, exact, "hit", what)
    both = lambda name: lambda x, y: got[name][y][x] == exact[name][y][x]
    free = lambda x, y: got["fate"][y][x] in (0, 2) and exact["fate"][y][x] == got["fate"][y][x]
    met = lambda x, y: got["hit"][y][x] == exact["hit"][y][x] != 0
    wrong += values_agree(got, exact, ["sky.x", "sky.y", "sky.z"], free, 2e-3, what)
    wrong += values_agree(got, exact, support.PLACE, met, 0.02, what)
    wrong += values_agree(got, exact, ["ray.shift"], lambda x, y: free(x, y) and got["hit"][y][x] == 0, 2e-3, what)
    longest = max(abs(v) for row in exact["delay"] for v in row)
    if any(v for row in got["delay"] for v in row):
        bound = max(0.05, 8 * FLOAT_STEP * longest)   # single precision, of parts that nearly cancel
        wrong += values_agree(got, exact, ["delay"], lambda x, y: met(x, y) or (free(x, y) and got["hit"][y][x] == 0), bound, what)
    return wrong


def layers_add_up(got, what):
    """R, G and B are those of the layers together."""
    names = sorted({name.rsplit(".", 1)[0] for name in got if name.endswith(".R")})
    worst = 0.0
    for c in COLOURS:
        for y, row in enumerate(got[c]):
            for x, value in enumerate(row):
                worst = max(worst, abs(value - sum(got[f"{name}.{c}"][y][x] for name in names)) / max(1.0, value))
    return [f"{what}: {', '.join(names)} differ from the picture by {worst:.3g}"] if worst > 1e-5 else []


def halves(got, picture):
    """The picture to three digits, and 65504 where it is brighter."""
    off = sum(abs(a - min(b, 65504.0)) > max(1e-7, 6e-4 * b) for c in COLOURS for p, q in zip(got[c], picture[c]) for a, b in zip(p, q))
    return [f"--half: {off} values are off"] if off else []


def maps_agree(got, exact, what):
    sky = lambda x, y: got["B"][y][x] == 1 == exact["B"][y][x] and abs(exact["R"][y][x]) < 10 and abs(exact["G"][y][x]) < 10
    return finite({name + ".": rows for name, rows in got.items()}, what) + numbers_agree(got, exact, "B", what) + \
        values_agree(got, exact, ["R", "G"], sky, 5e-3, what)
