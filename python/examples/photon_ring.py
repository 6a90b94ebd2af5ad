#!/usr/bin/env python3
"""A cut through the photon ring of an accretion disc: brightness and image order against impact parameter: photon_ring.png."""
import sys

import matplotlib
import numpy as np

import nullscope as ns

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SIZE = (1001, 101)   # px
RADIUS, FIELD = 1000.0, 0.9   # of the camera, r_s; degrees across
scene = ns.scene(ns.scene("accretion", sky=None), sky={"kind": "black"}, picture={"samples": 4, "bloom": 0.0},
                 camera={"r": RADIUS, "theta": 20.0, "fov": FIELD, "yaw": 0.0, "pitch": 0.0, "roll": 0.0})
row = SIZE[1] // 2
light = ns.capture(scene, SIZE)[row] @ np.array([0.2126, 0.7152, 0.0722], dtype=np.float32)
rays = ns.raydata(scene, SIZE)[row]

column = np.arange(SIZE[0]) + 0.5 - 0.5 * SIZE[0]
tangent = np.tan(np.radians(0.5 * FIELD)) * column / (0.5 * SIZE[0])
impact = RADIUS * np.sin(np.arctan(tangent)) / np.sqrt(1 - 1 / RADIUS)   # r_s
critical = ns.Spacetime("schwarzschild").critical_impact
print(f"critical impact parameter {critical:.4f} r_s; highest order in the picture {int(rays['order'].max())}")
figure, (above, below) = plt.subplots(2, 1, sharex=True)
above.plot(impact, light)
above.set_ylabel("luminance")
below.step(impact, rays["order"], where="mid")
below.set_ylabel("image order")
below.set_xlabel("impact parameter, $r_s$")
for axes in (above, below):
    for side in (-critical, critical):
        axes.axvline(side, color="grey", linewidth=0.8)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "photon_ring.png", dpi=120)
