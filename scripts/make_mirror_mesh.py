#!/usr/bin/env python3
"""Makes a warp mesh (camera.warp) for a dome with a spherical mirror: each node of the projector's picture is followed over the mirror to the
dome. Standard library only. After Paul Bourke, "Using a spherical mirror for projection into immersive environments" (2005).

    scripts/make_mirror_mesh.py assets/warp/mirror.data          the mesh that ships

Lengths are radii of the dome, which is a half sphere about (0, 0, 0): x to the audience's right, y ahead, z up. The projector looks away
from the audience, -y, and upward. The input picture is a dome master: fisheye, 180 degrees, the zenith in the middle, ahead at the lower
edge. Nodes whose light misses the mirror or falls far below the dome's rim are not drawn.
"""
import argparse
import math

LEAST = 1e-9
LOWEST = -0.5    # height on the sphere that a node may have: below the rim, which the dome master's circle cuts exactly


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def along(start, direction, length):
    return [p + length * d for p, d in zip(start, direction)]


def sphere(start, direction, centre, radius, far):
    """Length to the sphere, the nearer or the farther; None where it is missed."""
    off = [p - c for p, c in zip(start, centre)]
    half, rest = dot(off, direction), dot(off, off) - radius * radius
    root = half * half - rest
    if root < 0:
        return None
    length = -half + math.sqrt(root) if far else -half - math.sqrt(root)
    return length if length > LEAST else None


def node(x, y, wanted):
    """u, v and the way that the light goes; None: it is not drawn."""
    tangent = math.tan(math.radians(wanted.half_height))
    pitch = math.radians(wanted.pitch)
    ahead, up = [0, -math.cos(pitch), math.sin(pitch)], [0, math.sin(pitch), math.cos(pitch)]
    direction = [-x * tangent, ahead[1] + y * tangent * up[1], ahead[2] + y * tangent * up[2]]   # right of it is -x
    size = math.sqrt(dot(direction, direction))
    direction = [d / size for d in direction]
    there = sphere(wanted.projector, direction, wanted.mirror, wanted.mirror_radius, False)
    if there is None:
        return None
    place = along(wanted.projector, direction, there)
    normal = [(p - c) / wanted.mirror_radius for p, c in zip(place, wanted.mirror)]
    back = along(direction, normal, -2 * dot(direction, normal))
    on = sphere(place, back, [0, 0, 0], 1, True)
    if on is None:
        return None
    seen = along(place, back, on)
    if seen[2] < LOWEST:
        return None
    level = math.hypot(seen[0], seen[1])
    share = 0.5 * math.atan2(level, seen[2]) / (math.pi / 2) / max(level, LEAST)
    return 0.5 + share * seen[0], 0.5 - share * seen[1], there + on


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("output")
    for name, default, what in [("projector", [0, -0.6, -0.14], "place of the projector's lens"),
                                ("mirror", [0, -0.93, -0.14], "middle of the mirror's sphere")]:
        arguments.add_argument(f"--{name}", nargs=3, type=float, default=default, metavar=("X", "Y", "Z"), help=what)
    for name, default, what in [("mirror-radius", 0.13, "its radius"), ("aspect", 16 / 9, "of the projector's picture"),
                                ("half-height", 11.0, "angle from its picture's middle to the upper side, degrees"),
                                ("pitch", 11.5, "by how much its picture's middle lies above the level, degrees")]:
        arguments.add_argument(f"--{name}", type=float, default=default, help=f"{what} (default {default:.4g})")
    arguments.add_argument("--nodes", nargs=2, type=int, default=[65, 37], metavar=("NX", "NY"))
    wanted = arguments.parse_args()
    columns, rows = wanted.nodes
    places = [(wanted.aspect * (2 * i / (columns - 1) - 1), 2 * j / (rows - 1) - 1) for j in range(rows)
              for i in range(columns)]
    nodes = [node(x, y, wanted) for x, y in places]
    farthest = max((n[2] for n in nodes if n), default=1)
    with open(wanted.output, "w") as out:
        print(2, f"{columns} {rows}", sep="\n", file=out)
        for (x, y), n in zip(places, nodes):
            # Light that has come far is spread: nearer parts of the dome are dimmed to it.
            u, v, light = (n[0], n[1], (n[2] / farthest) ** 2) if n else (0.5, 0.5, -1)
            print(f"{x:.6f} {y:.6f} {u:.6f} {v:.6f} {light:.4f}", file=out)


if __name__ == "__main__":
    main()
