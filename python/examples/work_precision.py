#!/usr/bin/env python3
"""Error of where a frame's rays end on the sky against what a pixel costs, for the shader's methods: work_precision.png."""
import resource
import sys

import matplotlib
import numpy as np

import nullscope as ns

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

SCENE, SIZE, REPEATS = "sky-only", (640, 360), 5   # px
METHODS = ("strip", "strip:cubic", "table:32", "table:128", "table:512", "closed-form", "integrate:4:0.2", "integrate:6:0.6",
           "integrate:6:0.1", "euler:100", "euler:1000")


def directions(rays):
    return np.stack([rays["sky.x"], rays["sky.y"], rays["sky.z"]])


def core_seconds():
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


exact = ns.raydata(SCENE, SIZE, renderer="reference")
escaped = exact["fate"] == ns.Fate.ESCAPED
for method in METHODS:
    rays = ns.raydata(SCENE, SIZE, method=method)   # compiles the shader
    costs = []
    for _ in range(REPEATS):
        begun = core_seconds()
        ns.raydata(SCENE, SIZE, method=method)
        costs.append((core_seconds() - begun) / exact.size)
    both = escaped & (rays["fate"] == ns.Fate.ESCAPED)
    errors = np.linalg.norm(directions(rays) - directions(exact), axis=0)[both]
    median, most = np.quantile(errors, [0.5, 0.999])   # near the critical ray any error is magnified
    cost = 1e9 * np.median(costs)
    print(f"{method:16} {cost:8.1f} ns a pixel, error {median:.1e} rad, 99.9 % within {most:.1e} rad")
    plt.loglog(cost, median, "o")
    plt.annotate(method, (cost, median), xytext=(4, 4), textcoords="offset points", fontsize=8)
plt.xlabel("processor time a pixel, ns (tables and reading back with it)")
plt.ylabel("median error of the direction, rad")
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "work_precision.png", dpi=120)
