#!/usr/bin/env bash
# trimesh 5.2.0, meshio 5.3.5 and VTK 9.4.2 (pyvista 0.45.0), Wavefront OBJ files with polylines ("l" elements), as ray tracers write paths of light.
#
# Guessed: trimesh gives paths (it has Path3D), meshio cells of kind "line"; else an error says that there are no faces.
# Seen: without a word,
#   trimesh.load() gives a PointCloud of the vertices: no line is left, nor which ray a vertex belongs to; trimesh.load_path() raises an error of
#       which file and format are no part;
#   meshio.read() gives a mesh with the vertices and no cells (meshio.write() of line cells as OBJ raises an error that says why);
#   only VTK has both polylines, each with its points in the file's order, whose lengths are right to rounding.
# Who hands rays on as OBJ reads them with VTK (or Blender), or gives each ray to trimesh as a Path3D of the CSV's points.
#
# Exit status: 0 as described, 1 something has changed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet trimesh==5.2.0 meshio==5.3.5 networkx==3.4.2 pyvista==0.45.0 vtk==9.4.2 numpy==2.2.6
cd "$folder"
venv/bin/python -W ignore - <<'PYTHON'
import math
import pathlib
import sys

import meshio
import numpy as np
import pyvista
import trimesh

changed = []


def note(name, good):
    print(f"{name}: {'as described' if good else 'CHANGED'}")
    if not good:
        changed.append(name)


def ray(impact, count):
    """A straight ray past the origin."""
    return [(x, impact, 0.1 * x) for x in np.linspace(-5, 5, count)]


RAYS = [ray(3.0, 6), ray(5.0, 9)]
lines, first = [], 1
for number, points in enumerate(RAYS):
    lines += [f"o ray_{number}"] + ["v {:.9g} {:.9g} {:.9g}".format(*point) for point in points]
    lines.append("l " + " ".join(str(first + k) for k in range(len(points))))
    first += len(points)
pathlib.Path("rays.obj").write_text("\n".join(lines) + "\n")
lengths = [math.dist(points[0], points[-1]) for points in RAYS]
vertices = sum(len(points) for points in RAYS)

loaded = trimesh.load("rays.obj")
print("trimesh:", loaded)
note("trimesh's points without lines", isinstance(loaded, trimesh.PointCloud) and len(loaded.vertices) == vertices)
try:
    trimesh.load_path("rays.obj")
    note("trimesh's load_path", False)
except ValueError as error:
    print("trimesh.load_path:", error)
    note("trimesh's load_path", "obj" not in str(error))

mesh = meshio.read("rays.obj")
print("meshio:", len(mesh.points), "points,", sum(len(block.data) for block in mesh.cells), "cells")
note("meshio's points without cells", len(mesh.points) == vertices and not mesh.cells)
try:
    meshio.write("lines.obj", meshio.Mesh(np.array(RAYS[0]), [("line", np.array([(k, k + 1) for k in range(5)]))]))
    note("meshio's error for lines", False)
except meshio.WriteError as error:
    note("meshio's error for lines", "triangle" in str(error))

read = pyvista.read("rays.obj")
print("VTK:", read.n_lines, "polylines of", read.n_points, "points")
parts = [cell.points for cell in read.cell]
lengths_read = [np.linalg.norm(np.diff(points, axis=0), axis=1).sum() for points in parts]
note("VTK's polylines", read.n_lines == 2 and np.allclose(sorted(lengths_read), sorted(lengths), rtol=1e-6))
sys.exit(f"changed: {', '.join(changed)}" if changed else 0)
PYTHON
