"""Finds how far the image on a wall is shifted, from the colours of the wall's pixels alone."""

from collections import namedtuple

import numpy as np

# Of mean squared differences, over three channels: a shift fits as well as the best one within this.
# One by a texel costs a wall that is worth judging tens to hundreds.
NOISE_FACTOR, NOISE = 1.5, 2.0
# Along a wall or down: so many shifts beside one another that fit as well as the best tell nothing.
PLAIN_RUN = 4

# `u`, `v`: the best shift, to the right and down. `count`: pixels. `equal`: the share of them with
# exactly the colour of their texel.
# Images of shifts: `good`, those that fit as well as the best; `minima`, those of them beside which
# none is better: several where the image repeats within itself.
Match = namedtuple("Match", "u v count equal good minima")


def match(image, u, v, colours):
    """Of an image that repeats on a wall and, for some pixels, where on the wall they are and their
    colours: the shift with which they fit best. Texel (floor(v) + shift, floor(u) + shift) counts."""
    height, width, _ = image.shape
    row, column = np.floor(v).astype(int) % height, np.floor(u).astype(int) % width
    differences = mean_squares(image.astype(float), row, column, colours.astype(float))
    best = np.unravel_index(np.argmin(differences), differences.shape)
    expected = image[(row + best[0]) % height, (column + best[1]) % width]
    good = differences <= NOISE_FACTOR * max(differences[best], 0) + NOISE
    return Match(int(best[1]), int(best[0]), len(colours),
                 float((expected == colours).all(axis=1).mean()),
                 good, good & (differences <= least_around(differences)))


def mean_squares(image, row, column, colours):
    """The mean of (colour - texel)^2 for every shift at once: the square is expanded, and each sum
    over pixels is a correlation of what they sum up to in each texel with the image."""
    texels = image.shape[:2]
    total = np.full(texels, (colours ** 2).sum())
    count = np.zeros(texels)
    np.add.at(count, (row, column), 1)
    total += correlation(count, (image ** 2).sum(axis=2))
    for channel in range(3):
        colour = np.zeros(texels)
        np.add.at(colour, (row, column), colours[:, channel])
        total -= 2 * correlation(colour, image[:, :, channel])
    return total / len(colours)


def correlation(a, b):
    """For each shift the sum of a[q] b[q + shift], round the edges."""
    return np.fft.irfft2(np.conj(np.fft.rfft2(a)) * np.fft.rfft2(b), a.shape)


def least_around(values):
    """For each shift the least of its eight neighbours, round the edges; with some room, since sums
    of a Fourier transform are rounded."""
    neighbours = [np.roll(values, (dy, dx), (0, 1))
                  for dy in (-1, 0, 1) for dx in (-1, 0, 1) if (dx, dy) != (0, 0)]
    return np.min(neighbours, axis=0) + 1e-6


def is_plain(good):
    """Of a ring of shifts."""
    if good.all():
        return True
    ring = np.roll(good, -int(np.argmin(good))).astype(int)  # begins with one that is not good
    edges = np.flatnonzero(np.diff(np.concatenate(([0], ring, [0]))))
    return bool((edges[1::2] - edges[::2]).max() >= PLAIN_RUN)


def difference(a, b, judged_along, judged_down):
    """Between the shifts of two matches of the same image, as (along, down): of those that tie, the
    pair that is closest; 0 in a direction that is not judged."""
    height, width = a.good.shape
    (va, ua), (vb, ub) = np.nonzero(a.minima), np.nonzero(b.minima)
    along = ring_difference(ua[:, None], ub[None, :], width) * judged_along
    down = ring_difference(va[:, None], vb[None, :], height) * judged_down
    closest = np.argmin(np.maximum(along, down))
    return int(along.flat[closest]), int(down.flat[closest])


def ring_difference(a, b, size):
    distance = np.abs(a - b) % size
    return np.minimum(distance, size - distance)
