#!/usr/bin/env python3
"""Light rays about a charge without horizon, Q/M > 1, in 30 digits with mpmath: writes tests/vectors/rn_naked.csv. The roots of P =
q^2 - zeta^2 (1 - zeta + kappa zeta^2) by mpmath's polyroots, the integrals by the tanh-sinh rule between points that crowd about
them; nothing is shared with the program. Needs mpmath; takes a minute."""
from mpmath import exp, linspace, log, mp, mpf, nstr, polyroots, quad, sqrt

mp.dps = 40


def trace(charge, q, zeta0, s):
    """Turning point (None on the way out), swept angle to the sky and delay v_camera - v_infinity, r_s = 1."""
    k, q, zeta0 = mpf(charge) ** 2 / 4, mpf(q), mpf(zeta0)
    roots = polyroots([-k, 1, -1, 0, q * q], maxsteps=500, extraprec=300)
    real = [x.real for x in roots if abs(x.imag) < mpf(10) ** -25 and x.real > 0]
    e = min(x for x in real if x >= zeta0)
    others = [x for x in roots if abs(x - e) > mpf(10) ** -18]
    near = sorted({x.real for x in others if 0 < x.real < e})

    def integral(f, low, high):  # zeta = e - s^2
        start, end = sqrt(e - high), sqrt(e - low)
        points = [start, end]
        for at in near:
            middle = sqrt(e - at)
            points += [t for j in range(8) for t in (middle - mpf(10) ** -j, middle + mpf(10) ** -j, middle) if start < t < end]

        def g(t):
            zeta, root = e - t * t, k
            for x in others:
                root *= zeta - x
            root = sqrt(root.real)
            return 2 * f(zeta, t * root) / root

        return quad(g, sorted(set(points)))

    phi, delay = integral(lambda z, r: mpf(1), mpf(0), zeta0), integral(lambda z, r: 1 / (q + r), mpf(0), zeta0)
    if s < 0:
        return None, phi, delay
    split = min(e, mpf("0.6")) / 2
    inward = integral(lambda z, r: q / (z * z * (1 - z + k * z * z)), max(zeta0, split), e)
    if zeta0 < split:  # in log(zeta)
        inward += quad(lambda y: exp(-y) * q / (1 - exp(y) + k * exp(2 * y)) / sqrt(q * q - exp(2 * y) * (1 - exp(y) + k * exp(2 * y))),
                       linspace(log(zeta0), log(split), 12))
    return e, phi + 2 * integral(lambda z, r: mpf(1), zeta0, e), delay + 2 * inward


def main():
    rays = [(0.3, 0.05, 1), (0.2, 0.01, 1), (0.55, 0.1, 1), (0.7, 1e-6, 1), (5.0, 0.2, 1), (0.3, 0.05, -1), (0.501, 1e-9, -1),
            (0.6, 0.3, 1), (0.9, 1.2, -1), (0.9, 1.2, 1)]
    print("# Reissner-Nordstrom charges without horizon: rays in 30 digits by scripts/make_naked_vectors.py. Columns as in rn_extremal.csv;")
    print("# every ray reaches the sky. charge: Q/M.")
    print("charge,q,zeta0,s,zeta_turn,phi,T")
    for charge in (1.01, 1.05, 1.0606, 1.06067, 1.08, 1.5, 3.0):
        for q, zeta0, s in rays:
            if q * q < zeta0 ** 2 * (1 - zeta0 + charge ** 2 / 4 * zeta0 ** 2):
                continue
            turn, phi, delay = trace(charge, q, zeta0, s)
            print(charge, repr(q), repr(zeta0), s, nstr(turn, 17) if turn else "", nstr(phi, 17), nstr(delay, 17), sep=",", flush=True)


if __name__ == "__main__":
    main()
