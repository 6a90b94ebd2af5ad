#!/usr/bin/env python3
"""Make assets/sky/milky-way.jpg from Axel Mellinger's panorama in Debian's package stellarium-data. Needs numpy and Pillow.

    apt-get download stellarium-data && dpkg-deb -x stellarium-data_*.deb stellarium
    python3 scripts/make_milky_way.py stellarium/usr/share/stellarium/textures/milkyway.png

milky-way.jpg: the light of everything but the stars of stars.bin, 2048 x 1024, equatorial J2000, RA 0 in the middle of the columns and
growing to the left; sRGB-encoded, white is FULL_S10 stars of V = 10 per square degree. The panorama gives the structure, published surface
brightness its scale, the catalogue what must not be there twice. assets/sky/README.md says where the numbers come from.
"""

import os
import struct
import sys

import numpy as np
from PIL import Image

FULL_S10 = 1000.0
# The panorama's codes (0 to 1, as they are encoded, not as light) are linear in surface brightness above what it shows as black.
SCALE_S10 = 880.0
# What is black in it, by galactic latitude: total light fainter than V = 6.5 as published, less the panorama's and the catalogue's.
FLOOR_LATITUDE = (0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 75.0, 90.0)
FLOOR_S10 = (48.0, 42.0, 34.0, 28.0, 24.0, 21.0, 19.0, 17.5, 16.5)
# The panorama's colours are those of a stretched picture: balanced so that the arms are near white and the centre warm, and less saturated.
CHROMA_POWER = 0.70
CHROMA_GAIN = np.array([1.22, 1.0, 0.82])
BROWN = 0.3      # light that dust has reddened is brown, not olive
FLOOR_COLOUR = np.array([0.95, 1.0, 1.07])
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
# Clouds and dust lanes narrower than this many degrees have their contrast raised to this power: the panorama's range is compressed.
LOCAL_DEGREES, LOCAL_POWER = 3.0, 1.4
# Below these codes its noise is smoothed away, over so many pixels (0.18 degrees each).
QUIET, CLEAR, NOISE_PX, CHROMA_PX = 0.02, 0.14, 3.0, 2.0
# Stars of the catalogue to this magnitude are taken out, but not where a nebula or a cluster is what is seen: RA, Dec, radius in degrees.
STAR_LIMIT = 7.0
KEPT = ((83.8, -5.4, 1.2), (85.3, -2.2, 0.8), (10.7, 41.3, 2.0), (161.2, -59.7, 1.5), (271.0, -24.3, 1.0), (201.7, -47.5, 0.7),
        (6.0, -72.1, 0.7), (84.7, -69.1, 1.0), (34.8, 57.1, 0.8), (98.0, 5.0, 1.0), (274.7, -13.8, 0.8), (275.2, -16.2, 0.6),
        (280.2, 6.0, 0.1), (23.5, 30.7, 0.8), (268.5, -34.8, 0.8))

RA_CENTRE, DEC_CENTRE = 266.405, -28.936      # galactic centre, J2000
RA_POLE, DEC_POLE = 192.8595, 27.1284         # north galactic pole, J2000


def unit(ra, dec):
    ra, dec = np.radians(ra), np.radians(dec)
    return np.stack([np.cos(dec) * np.cos(ra), np.cos(dec) * np.sin(ra), np.sin(dec)], -1)


def read_stars(path):
    """RA, Dec in degrees and V of stars.bin."""
    with open(path, "rb") as file:
        data = file.read()
    records = np.frombuffer(data[16:], "<u8", struct.unpack("<I", data[12:16])[0])

    def field(first, bits):
        return (records >> np.uint64(first) & np.uint64((1 << bits) - 1)).astype(float)
    return field(0, 22) / 2**22 * 360.0, (field(22, 21) / (2**21 - 1) - 0.5) * 180.0, field(43, 11) * 0.01 - 2.0


def blur(picture, sigma_px):
    """Gaussian on the sphere: columns clamped, rows periodic and wider towards the poles."""
    height, width = picture.shape
    padded = np.pad(picture, ((height // 4, height // 4), (0, 0)), mode="edge")
    rate = np.fft.rfftfreq(padded.shape[0])[:, None]
    padded = np.fft.irfft(np.fft.rfft(padded, axis=0) * np.exp(-2.0 * (np.pi * rate * sigma_px)**2), padded.shape[0], 0)
    rows = padded[height // 4:height // 4 + height]
    sigma = np.minimum(sigma_px / np.sin((np.arange(height) + 0.5) / height * np.pi), width / 8.0)[:, None]
    rate = np.fft.rfftfreq(width)[None, :]
    return np.fft.irfft(np.fft.rfft(rows, axis=1) * np.exp(-2.0 * (np.pi * rate * sigma)**2), width, 1)


def take_stars_out(codes, stars):
    """Replaces what stands out about a bright star by the median of the ring about it."""
    height, width, _ = codes.shape
    kept = [(unit(ra, dec), np.cos(np.radians(radius))) for ra, dec, radius in KEPT]
    for ra, dec, magnitude in zip(*stars):
        if magnitude > STAR_LIMIT or any(unit(ra, dec) @ middle > least for middle, least in kept):
            continue
        y, reach = int((90.0 - dec) / 180.0 * height), min(int(8.0 / np.cos(np.radians(dec))) + 1, width // 2)
        rows = np.clip(np.arange(y - 8, y + 9), 0, height - 1)
        columns = (int((0.5 - ra / 360.0) * width) + np.arange(-reach, reach)) % width
        places = unit(*np.meshgrid((0.5 - (columns + 0.5) / width) * 360.0, 90.0 - (rows + 0.5) / height * 180.0))
        distance = np.degrees(np.sqrt(np.maximum(2.0 - 2.0 * (places @ unit(ra, dec)), 0.0))) / 180.0 * height
        patch = codes[np.ix_(rows, columns)]
        ring, core = patch[(distance > 4.0) & (distance < 7.0)], distance < 3.0
        level, spread = np.median(ring, 0), np.percentile(ring, 84, 0) - np.median(ring, 0)
        patch[core] = np.minimum(patch[core], level + spread)
        codes[np.ix_(rows, columns)] = patch


def surface_brightness(codes, latitude):
    """S10 and colours of luminance 1 of the panorama's codes."""
    luminance = codes @ LUMINANCE
    smooth = blur(luminance, NOISE_PX)
    share = np.clip((smooth - QUIET) / (CLEAR - QUIET), 0.0, 1.0)
    share = np.maximum(share, np.clip((luminance - smooth) / 0.10 - 0.5, 0.0, 1.0))     # what stands out of it is no noise
    structure = smooth + share * (luminance - smooth)
    floor = np.interp(np.abs(latitude), FLOOR_LATITUDE, FLOOR_S10)
    total = SCALE_S10 * structure + floor
    local = blur(total, LOCAL_DEGREES / 180.0 * codes.shape[0])
    raised = local * (total / local)**LOCAL_POWER
    total = raised * local / blur(raised, LOCAL_DEGREES / 180.0 * codes.shape[0])   # the mean stays
    part = (SCALE_S10 * structure / (SCALE_S10 * structure + floor))[..., None]      # the panorama's of the light
    wide = np.stack([blur(codes[..., c], 3.0 * CHROMA_PX) for c in range(3)], -1)
    fine = np.stack([blur(codes[..., c], 0.5) for c in range(3)], -1)
    chroma = wide + share[..., None] * (fine - wide)
    chroma = ((chroma + 0.004) / (chroma[..., 1:2] + 0.004))**CHROMA_POWER * CHROMA_GAIN
    chroma[..., 0] *= np.maximum(chroma[..., 1] / chroma[..., 2], 1.0)**BROWN
    colour = part * chroma / (chroma @ LUMINANCE)[..., None] + (1.0 - part) * FLOOR_COLOUR / (FLOOR_COLOUR @ LUMINANCE)
    return total, colour


def encode(linear):
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 0.0031308)**(1.0 / 2.4) - 0.055)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = sys.argv[2] if len(sys.argv) == 3 else os.path.join(os.path.dirname(__file__), "..", "assets", "sky")
    codes = np.asarray(Image.open(sys.argv[1]).convert("RGB")).astype(float) / 255.0
    height, width, _ = codes.shape
    codes = np.roll(codes, width // 4, 1)      # it has RA 18h in the middle
    ra, dec = np.meshgrid((0.5 - (np.arange(width) + 0.5) / width) * 360.0, 90.0 - (np.arange(height) + 0.5) / height * 180.0)
    latitude = np.degrees(np.arcsin(np.clip(unit(ra, dec) @ unit(RA_POLE, DEC_POLE), -1.0, 1.0)))
    take_stars_out(codes, read_stars(os.path.join(folder, "stars.bin")))
    total, colour = surface_brightness(codes, latitude)
    picture = encode(total[..., None] * colour / FULL_S10)
    Image.fromarray(np.uint8(np.round(255.0 * picture))).save(os.path.join(folder, "milky-way.jpg"), quality=95, subsampling=0,
                                                            optimize=True)


if __name__ == "__main__":
    main()
