"""What the grid's file holds, from density, energy, velocity and field in Kerr and Schild's coordinates."""
import math

import numpy as np

GRAM_A_PROTON, ELECTRON_K, LIGHT = 1.67262192e-24, 5.92989658e9, 2.99792458e10   # m_p; m_e c^2/k; cm/s
PROTON_OVER_ELECTRON = 1836.15267
NOTHING = 1e-30
HOTTEST_K = 9.9e13                              # the file may have 1e14


def lowered(r, theta, a, vector):
    """A vector's covariant components; (t, r, theta, phi) first. M = 1."""
    sine2 = np.sin(theta) ** 2
    sigma = r * r + a * a * np.cos(theta) ** 2
    null = vector[0] + vector[1] - a * sine2 * vector[3]      # l_a v^a; g = flat + 2r/Sigma l l
    pulled = 2 * r / sigma * null
    return np.stack([pulled - vector[0], pulled + vector[1] - a * sine2 * vector[3], sigma * vector[2],
                     sine2 * ((r * r + a * a) * vector[3] - a * (vector[1] + pulled))])


def four_vectors(r, theta, a, velocity, field):
    """u and b of the matter, from ut^i and B^i."""
    zero = np.zeros((1,) + velocity.shape[1:])
    pull = 2 * r / (r * r + a * a * np.cos(theta) ** 2)
    lapse = 1 / np.sqrt(1 + pull)
    still = np.concatenate([zero, velocity])
    lorentz = np.sqrt(1 + np.maximum((still * lowered(r, theta, a, still)).sum(axis=0), 0))
    u = still
    u[0] = lorentz / lapse
    u[1] -= lapse * lorentz * pull
    b = np.concatenate([zero, field])
    b_t = (b * lowered(r, theta, a, u)).sum(axis=0)
    b = (b + b_t * u) / u[0]
    b[0] = b_t
    return u, b


def zamo_components(r, theta, a, vector):
    """Of a vector in Kerr and Schild's coordinates: along the zero-angular-momentum observer (ZAMO) and its e_r, e_theta, e_phi."""
    delta, sigma = r * r - 2 * r + a * a, r * r + a * a * np.cos(theta) ** 2
    area = (r * r + a * a) ** 2 - a * a * delta * np.sin(theta) ** 2
    t = vector[0] - 2 * r / delta * vector[1]                 # Boyer and Lindquist's
    phi = vector[3] - a / delta * vector[1]
    return np.stack([np.sqrt(sigma * delta / area) * t, np.sqrt(sigma / delta) * vector[1], np.sqrt(sigma) * vector[2],
                     np.sqrt(area / sigma) * np.sin(theta) * (phi - 2 * a * r / area * t)])


def kelvin(flow, wanted, rho, energy, field2, electrons):
    """Of the electrons."""
    if flow.electrons == "kelvin":
        return electrons
    if flow.electrons == "entropy":
        return PROTON_OVER_ELECTRON * electrons * rho ** (flow.electron_index - 1) * ELECTRON_K
    beta2 = ((flow.gamma - 1) * energy / (0.5 * field2)) ** 2
    ratio = (wanted.r_high * beta2 + wanted.r_low) / (1 + beta2)
    electron, proton = flow.electron_index - 1, flow.proton_index - 1
    return PROTON_OVER_ELECTRON * electron * proton / (electron * ratio + proton) * energy / rho * ELECTRON_K


def matter(flow, wanted, r, theta, phi, numbers, known):
    """The file's eight numbers (place, number) at places r, theta, phi of the file; known: where cells hold anything. numbers: density, energy, velocity
    and field as the chart has them, electrons."""
    velocity, field = (flow.chart.kerr_schild(r, theta, phi, part) for part in (numbers[2:5], numbers[5:8]))
    u, b = (zamo_components(r, theta, flow.spin, part) for part in four_vectors(r, theta, flow.spin, velocity, field))
    rest = b[1:] - u[1:] * (b[0] / (1 + u[0]))                # boosted without a rotation
    field2 = np.maximum((rest * rest).sum(axis=0), NOTHING)
    rho, energy = numbers[0], numbers[1]
    out = np.zeros((len(r), 8))
    out[:, 0] = np.where(field2 / rho > wanted.sigma_cut, 0, rho * wanted.density_unit / GRAM_A_PROTON)
    out[:, 1] = np.clip(kelvin(flow, wanted, rho, energy, field2, numbers[8] if flow.electrons else None), 0, HOTTEST_K)
    out[:, 2:5] = math.sqrt(4 * math.pi * wanted.density_unit) * LIGHT * rest.T
    out[:, 5:8] = u[1:].T
    out[~known] = 0
    if flow.spin < 0:   # turned by half a turn about the x axis: theta -> pi - theta, phi -> -phi
        out[:, [3, 4, 6, 7]] *= -1
    return out
