#!/usr/bin/env python3
"""What flip_test.cpp expects of its pictures, by another way: the formulas of Andersson et al. 2020 over whole
two-dimensional kernels, with NumPy. Prints, of each pair, pixels per degree, mean, largest value and two pixels."""

import numpy as np

PAPER_PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * np.pi / 180
# Linear RGB to XYZ with the white (0.31271, 0.32902) and the primaries of sRGB, from the two defining equations.
PRIMARIES = np.array([[0.64, 0.33, 0.03], [0.30, 0.60, 0.10], [0.15, 0.06, 0.79]]).T
WHITE = np.array([0.31271, 0.32902, 1 - 0.31271 - 0.32902]) / 0.32902
TO_XYZ = PRIMARIES @ np.diag(np.linalg.solve(PRIMARIES, WHITE))


def convolve(plane, kernel):
    """Each pixel as the sum over its neighbours one by one; beyond an edge, the edge's pixel."""
    radius = kernel.shape[0] // 2
    padded = np.pad(plane, radius, mode="edge")
    height, width = plane.shape
    result = np.zeros_like(plane)
    for y in range(kernel.shape[0]):
        for x in range(kernel.shape[1]):
            result += kernel[y, x] * padded[y : y + height, x : x + width]
    return result


def sensitivity(ppd, terms):
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi**2)) * ppd))
    x, y = np.meshgrid(np.arange(-radius, radius + 1) / ppd, np.arange(-radius, radius + 1) / ppd)
    kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-(np.pi**2) * (x * x + y * y) / b) for a, b in terms)
    return kernel / kernel.sum()


def relative_xyz(rgb):
    return (rgb @ TO_XYZ.T) / WHITE


def hunt_lab(rgb):
    t = relative_xyz(rgb)
    delta = 6 / 29
    f = np.where(t > delta**3, np.cbrt(t), t / (3 * delta**2) + 4 / 29)
    light = 116 * f[..., 1] - 16
    return np.stack([light, 5 * light * (f[..., 0] - f[..., 1]), 2 * light * (f[..., 1] - f[..., 2])], axis=-1)


def perceived(rgb, ppd):
    t = relative_xyz(rgb)
    planes = [116 * t[..., 1] - 16, 500 * (t[..., 0] - t[..., 1]), 200 * (t[..., 1] - t[..., 2])]
    terms = [[(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)]]
    light, red, blue = (convolve(p, sensitivity(ppd, s)) for p, s in zip(planes, terms))
    y = (light + 16) / 116
    xyz = np.stack([(y + red / 500), y, (y - blue / 200)], axis=-1) * WHITE
    return hunt_lab(np.clip(np.linalg.solve(TO_XYZ, xyz.reshape(-1, 3).T).T.reshape(xyz.shape), 0, 1))


def hyab(a, b):
    return np.abs(a[..., 0] - b[..., 0]) + np.sqrt(((a - b)[..., 1:] ** 2).sum(axis=-1))


def signs_to_one(kernel):
    return np.where(kernel > 0, kernel / kernel[kernel > 0].sum(), -kernel / kernel[kernel < 0].sum())


def strengths(rgb, ppd):
    deviation = 0.5 * 0.082 * ppd
    radius = int(np.ceil(3 * deviation))
    x, y = np.meshgrid(np.arange(-radius, radius + 1), np.arange(-radius, radius + 1))
    gauss = np.exp(-(x * x + y * y) / (2 * deviation**2))
    light = relative_xyz(rgb)[..., 1]
    result = []
    for kernel in (signs_to_one(-x * gauss), signs_to_one((x * x / deviation**2 - 1) * gauss)):
        result.append(np.sqrt(convolve(light, kernel) ** 2 + convolve(light, kernel.T) ** 2))
    return result


def flip(a, b, ppd):
    green, blue = hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1]))
    largest = hyab(green, blue) ** 0.7
    colour = hyab(perceived(a, ppd), perceived(b, ppd)) ** 0.7
    knee = 0.4 * largest
    colour = np.where(colour < knee, 0.95 / knee * colour, 0.95 + 0.05 * (colour - knee) / (largest - knee))
    feature = np.maximum(*(np.abs(p - q) for p, q in zip(strengths(a, ppd), strengths(b, ppd))))
    return colour ** (1 - np.sqrt(feature / np.sqrt(2)))


def stripes(at):
    picture = np.zeros((16, 24, 3))
    picture[:, at:] = 1
    return picture


def colours(shift):
    y, x = np.meshgrid(np.arange(20), np.arange(30), indexing="ij")
    return np.stack([(x + shift) % 30 / 29, y / 19, (7 * x + 3 * y) % 11 / 10], axis=-1)


def dot_on_grey():
    picture = np.full((21, 21, 3), 0.25)
    picture[10, 10] = (1, 0.5, 0)
    return picture


def show(name, a, b, ppd):
    # The program's pictures are floats: where features hardly differ, the root of the difference shows it.
    values = flip(*(np.float32(picture).astype(float) for picture in (a, b)), ppd)
    middle = values[values.shape[0] // 2, values.shape[1] // 2]
    print(f"{name} {ppd:.4f} mean {values.mean():.8f} max {values.max():.8f} first {values[0, 0]:.8f} middle {middle:.8f}")


if __name__ == "__main__":
    for ppd in (PAPER_PIXELS_PER_DEGREE, 20):
        show("edge moved by a pixel", stripes(12), stripes(13), ppd)
        show("colours moved by a pixel", colours(0), colours(1), ppd)
        show("dot on grey", dot_on_grey(), np.full((21, 21, 3), 0.25), ppd)
    black, white = np.zeros((1, 1, 3)), np.ones((1, 1, 3))
    show("black and white", black, white, PAPER_PIXELS_PER_DEGREE)
    show("red and grey", np.array([[[1.0, 0, 0]]]), np.full((1, 1, 3), 0.25), PAPER_PIXELS_PER_DEGREE)
