#!/usr/bin/env python3
"""Angular radius of the shadow against the camera's radius, by formula and as the rays have it: shadow_radius.png."""
import sys

import matplotlib
import numpy as np

import nullscope as ns

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

hole = ns.Spacetime("schwarzschild")
radii = np.geomspace(1.02, 100.0, 60)   # r_s
by_formula = np.array([hole.shadow(r) for r in radii])


def by_rays(r, steps=40):
    """Halves the interval of angles from straight inward between a captured and an escaping ray."""
    low, high = np.zeros_like(r), np.full_like(r, np.pi)
    for _ in range(steps):
        angle = 0.5 * (low + high)
        rays = {"r": r, "theta": np.pi / 2, "phi": 0.0, "n_r": -np.cos(angle), "n_theta": 0.0, "n_phi": np.sin(angle)}
        captured = ns.trace("sky-only", rays)["fate"] == ns.Fate.CAPTURED
        low, high = np.where(captured, angle, low), np.where(captured, high, angle)
    return 0.5 * (low + high)


traced = by_rays(radii)
print(f"largest difference: {np.abs(traced - by_formula).max():.1e} rad")
plt.semilogx(radii, np.degrees(by_formula), label="formula")
plt.semilogx(radii, np.degrees(traced), ".", label="rays of the reference")
plt.axvline(hole.photon_orbit, color="grey", linewidth=0.8)
plt.xlabel("radius of the camera, $r_s$")
plt.ylabel("angular radius of the shadow, degrees")
plt.legend()
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "shadow_radius.png", dpi=120)
