#!/usr/bin/env python3
"""Light rays in the wormhole of James, von Tunzelmann, Franklin and Thorne (2015), traced in 40 digits with mpmath:
writes tests/vectors/dneg.csv. Needs mpmath; takes some minutes. The integrals are taken over l by the tanh-sinh rule between points
that crowd towards the throat and the turning point; nothing is shared with the program."""
import sys

from mpmath import atan, inf, log, mp, mpf, pi, quad, sqrt

mp.dps = 40


class Wormhole:
    def __init__(self, length, width):
        self.a = mpf(length) / 2
        self.m = mpf(width) / mpf("1.42953")

    def radius(self, l):
        x = 2 * (abs(l) - self.a) / (pi * self.m)
        return 1 + (self.m * (x * atan(x) - log(1 + x * x) / 2) if x > 0 else 0)

    def turn(self, b):
        """l > 0 where R = b."""
        low, high = self.a, self.a + 2 * b + 10 * self.m
        for _ in range(150):
            middle = (low + high) / 2
            low, high = (middle, high) if self.radius(middle) < b else (low, middle)
        return (low + high) / 2

    @staticmethod
    def integral(f, low, high):
        """f has its scale at the distance from `low`, down to nothing, and perhaps a root's pole there: l = low + y^2."""
        if high <= low:
            return mpf(0)
        points = [mpf(0)] + [at for at in (mpf(10) ** k for k in range(-8, 5)) if low + at * at < high]
        points.append(inf if high == inf else sqrt(high - low))
        return quad(lambda y: (2 * y * f(low + y * y)).real if y > 0 else mpf(0), points)

    # Sweep and lag (dt - dl) of a ray of impact parameter b over l in [low, high], all on one side, low nearest to the throat.
    def sweep(self, b, low, high):
        return self.integral(lambda l: b / (self.radius(l) * sqrt((self.radius(l) - b) * (self.radius(l) + b))), low, high)

    def lag(self, b, low, high):
        def f(l):
            r = self.radius(l)
            root = sqrt((r - b) * (r + b))
            return b * b / (root * (r + root))
        return self.integral(f, low, high)


def trace(w, b, l0, s):
    """A camera at l0 >= 0; s = sign of dl along the traced ray."""
    b, l0 = mpf(b), mpf(l0)
    if b > 1:
        t = w.turn(b)
        out_phi, out_t = w.sweep(b, l0, inf), w.lag(b, l0, inf)
        if s > 0:
            return 1, None, out_phi, out_t
        in_phi = w.sweep(b, t, l0)
        return 1, t, out_phi + 2 * in_phi, out_t + 2 * (w.lag(b, t, l0) + (l0 - t))
    slow = 1 / sqrt((1 - b) * (1 + b))
    tube = lambda d: (d * b * slow, d * (slow - 1))
    if s > 0:
        p, t = tube(max(w.a - l0, 0))
        start = max(l0, w.a)
        return 1, None, p + w.sweep(b, start, inf), t + w.lag(b, start, inf)
    p, t = tube(min(l0, w.a) + w.a)
    phi, lag = p + w.sweep(b, w.a, inf), t + w.lag(b, w.a, inf)
    if l0 > w.a:
        phi, lag = phi + w.sweep(b, w.a, l0), lag + w.lag(b, w.a, l0)
    return -1, None, phi, lag


def text(x):
    return "" if x is None else mp.nstr(x, 17, min_fixed=-3, max_fixed=8)


def main():
    rows, number = [], 0
    holes = [(0.01, 0.05), (0.0, 0.05), (2.0, 0.05), (0.5, 1.0), (0.0, 0.02), (0.1, 2.0)]
    cases = [(0.3, 5.0, -1), (0.999999, 0.7, -1), (1.0000001, 3.0, -1), (1.5, 20.0, -1), (1.5, 20.0, 1), (0.9, 0.002, 1),
             (0.9, 0.002, -1), (1.02, 1.0, -1), (0.5, 1e6, -1), (0.99999999, 0.3, 1), (3.0, 1e4, -1), (0.01, 0.0, -1)]
    print("# Wormhole of James, von Tunzelmann, Franklin and Thorne (2015), throat radius 1: rays in 40 digits by scripts/make_dneg_vectors.py.")
    print("# length = 2 a, width = 1.42953 M. h = b = |L|/E; s = sign of dl along the ray traced backward from the camera at l0 >= 0;")
    print("# end +1: l -> +infinity. phi: swept angle to there. T: elapsed time minus the change of l (end +1 and s > 0, or a turn:")
    print("# t - (L - l0); end -1: t - (L + l0)). l_turn: turning point.")
    print("id,length,width,h,l0,s,end,l_turn,phi,T")
    for length, width in holes:
        w = Wormhole(length, width)
        for h, l0, s in cases:
            b = mpf(h)
            if w.radius(mpf(l0)) < b:
                continue
            end, turn, phi, lag = trace(w, h, l0, s)
            print(f"{number},{length!r},{width!r},{h!r},{l0!r},{s},{end},{text(turn)},{text(phi)},{text(lag)}", flush=True)
            number += 1


if __name__ == "__main__":
    sys.exit(main())
