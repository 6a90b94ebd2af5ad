"""Coordinates of GRMHD files: where a place of Kerr and Schild's coordinates is in them, and what their vectors are there.

A chart's vectors are interpolated as three numbers that are smooth where the matter is: `smooth` makes them at cells, `kerr_schild` makes v^r, v^theta,
v^phi of them (M = 1).
"""
import math

import numpy as np

STEP = 1e-5     # of a native coordinate, for derivatives by central differences
HALVINGS = 60


def inverted(function, low, high, wanted):
    """Where a growing function has these values, between low and high."""
    wanted = np.asarray(wanted, dtype=float)
    low, high = np.full(wanted.shape, float(low)), np.full(wanted.shape, float(high))
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        below = function(middle) < wanted
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return 0.5 * (low + high)


class Spherical:
    """r = radius(x1) in M, theta = theta(x1, x2), phi = x3. plain: vectors are along r, theta, phi and not along x1, x2, x3; length: of the unit of
    length of such vectors, in M."""
    spherical = True

    def __init__(self, radius, theta, plain=False, length=1.0):
        self.radius, self.theta, self.plain, self.length = radius, theta, plain, length

    def slopes(self, x1, x2):
        """dr/dx1, dtheta/dx1, dtheta/dx2."""
        return ((self.radius(x1 + STEP) - self.radius(x1 - STEP)) / (2 * STEP), (self.theta(x1 + STEP, x2) - self.theta(x1 - STEP, x2)) / (2 * STEP),
                (self.theta(x1, x2 + STEP) - self.theta(x1, x2 - STEP)) / (2 * STEP))

    def volume(self, x1, x2, a):
        """sqrt(-g) of the native coordinates."""
        r, theta = self.radius(x1), self.theta(x1, x2)
        slopes = self.slopes(x1, x2)
        return slopes[0] * slopes[2] * (r * r + a * a * np.cos(theta) ** 2) * np.sin(theta)

    def smooth(self, x, vector):
        """v^r, r v^theta, r sin(theta) v^phi of a vector of the shape (3, ...)."""
        x1, x2 = x[0], x[1]
        r, theta = self.radius(x1), self.theta(x1, x2)
        along_r, along_theta = vector[0], vector[1]
        if self.plain:
            r = r * self.length
        else:
            r_1, theta_1, theta_2 = self.slopes(x1, x2)
            along_r, along_theta = r_1 * vector[0], theta_1 * vector[0] + theta_2 * vector[1]
        return np.stack([along_r, r * along_theta, r * np.sin(theta) * vector[2]])

    def kerr_schild(self, r, theta, phi, smooth):
        return np.stack([smooth[0], smooth[1] / r, smooth[2] / (r * np.sin(theta))])

    def ruler(self, axis, x):
        """In which numbers are interpolated linearly."""
        return np.log(np.maximum(self.radius(x), 1e-300)) if axis == 0 else x


class Cartesian:
    """Kerr and Schild's x, y, z, in units of length M: x + i y = (r + i a) sin(theta) exp(i phi), z = r cos(theta)."""
    spherical = False

    def __init__(self, a, length=1.0):
        self.a, self.length = a, length

    def radius_of(self, x):
        x, y, z = (side / self.length for side in x)
        flat = x * x + y * y + z * z - self.a ** 2
        return np.sqrt(0.5 * (flat + np.sqrt(flat * flat + 4 * self.a ** 2 * z * z)))

    def place(self, r, theta, phi):
        ring = (r + 1j * self.a) * np.sin(theta) * np.exp(1j * phi)
        return ring.real * self.length, ring.imag * self.length, r * np.cos(theta) * self.length

    def smooth(self, x, vector):
        return vector

    def kerr_schild(self, r, theta, phi, smooth):
        """By the inverse of d(x, y, z)/d(r, theta, phi): its rows are cross products of the columns over the determinant."""
        turn = np.exp(1j * phi)
        columns = [np.stack([ring.real, ring.imag, height]) for ring, height in
                   ((np.sin(theta) * turn, np.cos(theta)), ((r + 1j * self.a) * np.cos(theta) * turn, -r * np.sin(theta)),
                    (1j * (r + 1j * self.a) * np.sin(theta) * turn, np.zeros_like(r)))]
        rows = [np.cross(columns[(i + 1) % 3], columns[(i + 2) % 3], axis=0) for i in range(3)]
        determinant = (columns[0] * rows[0]).sum(axis=0)
        return np.stack([(row * smooth).sum(axis=0) / determinant for row in rows])

    def ruler(self, axis, x):
        return x


def mks_theta(hslope):
    return lambda x1, x2: math.pi * x2 + 0.5 * (1 - hslope) * np.sin(2 * math.pi * x2) + 0 * x1


def fmks_theta(hslope, smooth, xt, alpha, start):
    """MKS's theta, and near x1 = start that of a polynomial that is wide at the poles."""
    plain = mks_theta(hslope)
    norm = 0.5 * math.pi / (1 + xt ** -alpha / (1 + alpha))
    def theta(x1, x2):
        y = 2 * x2 - 1
        straight = norm * y * (1 + (y / xt) ** alpha / (1 + alpha)) + 0.5 * math.pi
        geometric = plain(x1, x2)
        return geometric + np.exp(smooth * (start - x1)) * (straight - geometric)
    return theta


def theta_itself(x1, x2):
    return x2 + 0 * x1


def tabled(ln_r, theta):
    """radius and theta of a table at the middles of cells, x1 = i + 1/2, x2 = j + 1/2: linear between them and beyond the last."""
    def spot(x, count):
        low = np.clip(np.floor(np.asarray(x) - 0.5).astype(int), 0, count - 2)
        return low, x - 0.5 - low
    def radius(x1):
        i, part = spot(x1, len(ln_r))
        return np.exp(ln_r[i] * (1 - part) + ln_r[i + 1] * part)
    def angle(x1, x2):
        (i, p), (j, q) = spot(x1, theta.shape[0]), spot(x2, theta.shape[1])
        return (theta[i, j] * (1 - p) + theta[i + 1, j] * p) * (1 - q) + (theta[i, j + 1] * (1 - p) + theta[i + 1, j + 1] * p) * q
    return radius, angle
