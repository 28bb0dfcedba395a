#!/usr/bin/python3
"""Turns published elevations, or a 16-bit PGM, into the 16-bit grey PNGs of this folder.

    convert_dem.py jacksboro jacksboro_fault_dem.npz  jacksboro.png
    convert_dem.py finland   topography.png           finland.png
    convert_dem.py pgm       stone_wall.pgm           stone_wall.png

Needs numpy. README.md says where the inputs come from and what the numbers below mean.
"""
import struct
import sys
import zlib

import numpy as np

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def write_png(path, stored):
    """16-bit greyscale, rows as they are (filter 0)."""

    def chunk(kind, data):
        checksum = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)

    height, width = stored.shape
    rows = b"".join(b"\0" + row.astype(">u2").tobytes() for row in stored)
    with open(path, "wb") as out:
        out.write(SIGNATURE)
        out.write(chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 0, 0, 0, 0)))
        out.write(chunk(b"IDAT", zlib.compress(rows, 9)))
        out.write(chunk(b"IEND", b""))


def read_rgba8_png(path):
    """8-bit RGBA without interlacing, the one kind that is needed here."""
    data = open(path, "rb").read()
    if data[:8] != SIGNATURE:
        sys.exit(f"{path}: is not a PNG file")
    at, idat = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", body)
            if form != [8, 6, 0, 0, 0]:
                sys.exit(f"{path}: is not 8-bit RGBA without interlacing")
        elif kind == b"IDAT":
            idat += body
        at += length + 12
    raw = np.frombuffer(zlib.decompress(idat), np.uint8).reshape(height, 1 + 4 * width)
    above, rows = [0] * (4 * width), []
    for line in raw.tolist():
        kind, now = line[0], line[1:]
        for k in range(4 * width):
            a = now[k - 4] if k >= 4 else 0
            b = above[k]
            c = above[k - 4] if k >= 4 else 0
            if kind == 4:  # Paeth: whichever of a, b, c is nearest to a + b - c.
                guess = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            else:
                guess = (0, a, b, (a + b) // 2)[kind]
            now[k] = (now[k] + guess) & 255
        rows.append(now)
        above = now
    return np.array(rows, np.int64).reshape(height, width, 4)


def quantized(heights_m, low_m, metres_per_unit):
    stored = np.rint((heights_m - low_m) / metres_per_unit)
    assert stored.min() >= 0 and stored.max() <= 65535
    error_m = np.abs(low_m + metres_per_unit * stored - heights_m).max()
    print(f"{heights_m.min()} to {heights_m.max()} m, largest rounding error {error_m:.4f} m")
    return stored


def jacksboro(path):
    return quantized(np.load(path)["elevation"].astype(float), 236.0, 1 / 64)


def finland(path):
    rgba = read_rgba8_png(path)
    packed = 65536 * rgba[:, :, 0] + 256 * rgba[:, :, 1] + rgba[:, :, 2]
    return quantized(packed / 11983.0, 180.0, 1 / 128)


def pgm(path):
    kind, size, greatest, body = open(path, "rb").read().split(b"\n", 3)
    if (kind, greatest) != (b"P5", b"65535"):
        sys.exit(f"{path}: is not a binary PGM of 16 bits")
    width, height = map(int, size.split())
    return np.frombuffer(body, ">u2").reshape(height, width)


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[1] not in ("jacksboro", "finland", "pgm"):
        sys.exit(__doc__)
    read = {"jacksboro": jacksboro, "finland": finland, "pgm": pgm}[sys.argv[1]]
    write_png(sys.argv[3], read(sys.argv[2]))
