#!/usr/bin/env python3
"""Minimax coefficients of atan(t)/t in t^2 on [0, 1] for shaders/core/trig.glsl (Remez exchange, exact arithmetic)."""
import math
from fractions import Fraction as F

DEGREE = 8


def value(z):
    t = math.sqrt(z)
    return math.atan(t) / t if t > 1e-8 else 1.0 - z / 3.0


def solve(matrix, right):
    n = len(right)
    rows = [[F(v) for v in r] + [F(b)] for r, b in zip(matrix, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(n):
            if r != i:
                f = rows[r][i] / rows[i][i]
                rows[r] = [a - f * b for a, b in zip(rows[r], rows[i])]
    return [float(rows[i][n] / rows[i][i]) for i in range(n)]


def main():
    n = DEGREE + 2
    nodes = [0.5 - 0.5 * math.cos(math.pi * i / (n - 1)) for i in range(n)]
    for _ in range(12):
        # Error of t * p(t^2), the angle itself: weight t.
        matrix = [[z**j for j in range(DEGREE + 1)] + [(-1) ** i / max(math.sqrt(z), 1e-3)] for i, z in enumerate(nodes)]
        solution = solve(matrix, [value(z) for z in nodes])
        p = solution[:-1]
        grid = [i / 4000 for i in range(4001)]
        error = [math.sqrt(z) * (sum(c * z**j for j, c in enumerate(p)) - value(z)) for z in grid]
        peaks, start = [], 0
        for i in range(1, len(grid) + 1):
            if i == len(grid) or error[i] * error[start] < 0:
                peaks.append(max(range(start, i), key=lambda q: abs(error[q])))
                start = i
        if len(peaks) != n:
            break
        nodes = [grid[i] for i in peaks]
    for j, c in enumerate(p):
        print(f"z^{j}: {c:.17g}")
    print("largest error in rad:", max(map(abs, error)))


if __name__ == "__main__":
    main()
