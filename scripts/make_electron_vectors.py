#!/usr/bin/env python3
"""Writes tests/vectors/electrons.csv: what isotropic electrons of a power law or a kappa distribution emit and absorb of I, Q, V, by direct sums over the
harmonics of their gyration and integrals over energy and pitch angle, without the approximations of ultrarelativistic electrons (Bekefi 1966; Leung,
Gammie and Noble 2011, ApJ 737, 21, equations 1 to 12). Needs numpy and scipy; a minute.

    scripts/make_electron_vectors.py > tests/vectors/electrons.csv
"""
import numpy as np
from scipy.integrate import quad
from scipy.special import jv

POINTS, LAST_POINTS = np.polynomial.legendre.leggauss(400), np.polynomial.legendre.leggauss(24)
FIRST = 100   # harmonics that are summed one by one; beyond, they are integrated


class PowerLaw:
    """gamma^-p from gamma_min to gamma_max."""

    def __init__(self, p, low, high):
        self.p, self.low, self.high = p, low, high
        self.norm = (p - 1) / (low ** (1 - p) - high ** (1 - p))

    def number(self, gamma):
        return np.where((gamma >= self.low) & (gamma <= self.high), self.norm * gamma ** -self.p, 0)

    def falls(self, gamma):
        """-gamma^2 beta d/dgamma of N/(gamma^2 beta), without its jumps at both ends: N/(gamma^2 beta) is gamma^-(p+1)/sqrt(gamma^2 - 1)."""
        return self.number(gamma) * ((self.p + 1) / gamma + gamma / (gamma ** 2 - 1))

    jumps = property(lambda self: ((self.low, -float(self.number(self.low))), (self.high, float(self.number(self.high)))))


class Kappa:
    """gamma sqrt(gamma^2 - 1) (1 + (gamma - 1)/(kappa w))^-(kappa + 1)."""
    jumps = ()

    def __init__(self, kappa, w):
        self.kappa, self.w, self.norm = kappa, w, 1.0
        self.low, self.high = 1.0, 1e4 * max(1.0, w)
        self.norm = 1 / quad(lambda y: np.exp(y) * self.number(1 + np.exp(y)), -30, 60, limit=500)[0]

    def number(self, gamma):
        return self.norm * gamma * np.sqrt(gamma ** 2 - 1) * (1 + (gamma - 1) / (self.kappa * self.w)) ** (-self.kappa - 1)

    def falls(self, gamma):
        return self.number(gamma) * (self.kappa + 1) / (self.kappa * self.w + gamma - 1)


def kernels(n, x, gamma, beta, mu, cosine, sine):
    """I, Q (positive across the field), V of harmonic n at x = nu/nu_B, of pitch angle arccos(mu)."""
    across = np.sqrt(np.maximum(1 - mu * mu, 0))
    z = x * gamma * beta * sine * across
    bessel, slope = jv(n, z), 0.5 * (jv(n - 1, z) - jv(n + 1, z))
    m, p = (cosine - beta * mu) / sine * bessel, beta * across * slope
    return np.array([m * m + p * p, p * p - m * m, 2 * m * p]) / (beta * abs(cosine)) * np.pi * x


def squeezed(middle, half, narrow, low=0.0, high=np.inf):
    """Places and weights on what of middle -+ half is between low and high, close to each other about the middle."""
    begin, end = (np.arcsinh(np.clip((edge - middle) / half, -1, 1) / narrow) for edge in (low, high))
    u, w = POINTS
    at = 0.5 * (begin + end) + 0.5 * (end - begin) * u
    return middle + half * narrow * np.sinh(at), 0.5 * (end - begin) * w * half * narrow * np.cosh(at)


def of_harmonic(n, x, electrons, cosine, sine):
    q = n / x
    room = q * q - sine * sine
    if room <= 0:
        return np.zeros(6)
    half = abs(cosine) * np.sqrt(room) / sine ** 2
    gamma, weight = squeezed(q / sine ** 2, half, min(1.0, sine ** 2 / q), electrons.low, electrons.high)
    keep = gamma > 1 + 1e-12
    gamma, weight = gamma[keep], weight[keep]
    beta = np.sqrt(1 - 1 / gamma ** 2)
    mu = np.clip((gamma - q) / (gamma * beta * cosine), -1, 1)
    k = kernels(n, x, gamma, beta, mu, cosine, sine) * weight
    return np.concatenate([k @ electrons.number(gamma), k @ electrons.falls(gamma)])


def summed(f, first, last, spacing):
    """Sum of f(n) over whole n, beyond the first ones as an integral over ln n."""
    total = sum(f(n) for n in range(first, first + FIRST))
    low, high = first + FIRST - 0.5, last
    if high > low:
        edges = np.linspace(np.log(low), np.log(high), max(2, int(np.log(high / low) / spacing) + 2))
        for a, b in zip(edges[:-1], edges[1:]):
            for u, w in zip(*LAST_POINTS):
                n = np.exp(0.5 * (a + b) + 0.5 * (b - a) * u)
                total = total + f(n) * n * w * 0.5 * (b - a)
    return total


def of_energy(gamma, x, cosine, sine):
    """I, Q, V of electrons of one energy: an integral over the pitch angle."""
    beta = np.sqrt(1 - 1 / gamma ** 2)
    n, weight = squeezed(gamma * x * (1 - beta * cosine ** 2), gamma * x * beta * abs(cosine) * sine ** 2 * 0.999, min(1.0, 1 / gamma))
    mu = (gamma - n / x) / (gamma * beta * cosine)
    return kernels(n, x, gamma, beta, mu, cosine, sine) @ weight


def vector(electrons, x, theta):
    cosine, sine = np.cos(theta), np.sin(theta)
    if electrons.jumps:   # its ends are sharp: energies outside, pitch angles (of harmonics above 500, which are many) inside
        edges = np.linspace(np.log(electrons.low), np.log(electrons.high), 12)
        total = np.zeros(6)
        for a, b in zip(edges[:-1], edges[1:]):
            for u, w in zip(*LAST_POINTS):
                gamma = np.exp(0.5 * (a + b) + 0.5 * (b - a) * u)
                one = of_energy(gamma, x, cosine, sine) * gamma * w * 0.5 * (b - a)
                total += np.concatenate([one * electrons.number(gamma), one * electrons.falls(gamma)])
        for gamma, jump in electrons.jumps:
            total[3:] += jump * of_energy(gamma, x, cosine, sine)
        return total
    first = int(np.ceil(max(x * sine, 1)))
    last = 1.2 * x * min(electrons.high, 300 * np.sqrt(x) * max(1.0, getattr(electrons, "w", 1.0)))
    return summed(lambda n: of_harmonic(n, x, electrons, cosine, sine), first, last, 0.7)


def main():
    print("# Synchrotron light of isotropic electrons at nu = x nu_B, theta from the field, by scripts/make_electron_vectors.py: emissivities of I, Q (positive across the")
    print("# field), V an electron in e^2 nu_B/c, and absorptivities in that over 2 m nu^2. kappa: 0 of a power law.")
    print("p,gamma_min,gamma_max,kappa,w,x,theta,j_I,j_Q,j_V,a_I,a_Q,a_V")
    for i in range(20):
        p, low, high = (2.0, 2.5, 3.0, 3.5)[i % 4], (10, 30, 20)[i % 3], (300, 1000)[i % 2]
        x, theta = 10 ** (2 + 0.18 * i), 0.4 + 0.055 * i
        print(f"{p},{low},{high},0,0,{x:.17g},{theta:.17g}," + ",".join(f"{v:.9g}" for v in vector(PowerLaw(p, low, high), x, theta)), flush=True)
    for i in range(20):
        kappa, w = (3.5, 4.0, 5.0, 7.0)[i % 4], (3, 10, 30)[i % 3]
        x, theta = 10 ** (2 + 0.18 * i), 0.4 + 0.055 * i
        print(f"0,0,0,{kappa},{w},{x:.17g},{theta:.17g}," + ",".join(f"{v:.9g}" for v in vector(Kappa(kappa, w), x, theta)), flush=True)


if __name__ == "__main__":
    main()
