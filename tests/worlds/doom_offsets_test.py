"""What doom/offsets.py finds on walls whose images are known.

usage: doom_offsets_test.py
"""

import unittest

import numpy as np

from doom.offsets import difference, is_plain, match

WIDTH, HEIGHT = 64, 48


def random_image():
    return np.random.default_rng(1).integers(0, 256, (HEIGHT, WIDTH, 3))


def seen(image, shift_u, shift_v, columns=40, rows=30):
    """A part of a wall on which an image hangs: where the pixels are, and their colours."""
    u, v = (grid.ravel() + 0.5 for grid in np.meshgrid(np.arange(columns), np.arange(-9, rows - 9)))
    texels = (v.astype(int) - (v < 0) + shift_v) % HEIGHT, (u.astype(int) + shift_u) % WIDTH
    return u, v, image[texels]


def matched(image, shift_u, shift_v):
    return match(image, *seen(image, shift_u, shift_v))


class Offsets(unittest.TestCase):
    def test_a_shift_is_found(self):
        found = matched(random_image(), 13, 47)
        self.assertEqual((found.u, found.v, found.equal), (13, 47, 1))
        self.assertEqual(found.minima.sum(), 1)

    def test_shifts_are_compared_round_the_edges(self):
        image = random_image()
        self.assertEqual(difference(matched(image, 63, 1), matched(image, 1, 46), True, True), (2, 3))

    def test_an_image_that_repeats_ties(self):
        image = np.tile(random_image()[:, :16], (1, 4, 1))
        found = matched(image, 5, 0)
        self.assertEqual(sorted(np.nonzero(found.minima)[1]), [5, 21, 37, 53])
        self.assertEqual(difference(found, matched(image, 16 + 5, 0), True, True), (0, 0))
        self.assertEqual(difference(found, matched(image, 16 + 8, 0), True, True), (3, 0))

    def test_columns_of_one_colour_are_plain_down_and_not_along(self):
        image = np.repeat(random_image()[:1], HEIGHT, axis=0)
        good = matched(image, 7, 0).good
        self.assertFalse(is_plain(good.any(axis=0)))
        self.assertTrue(is_plain(good.any(axis=1)))

    def test_a_direction_that_is_plain_is_not_compared(self):
        image = np.repeat(random_image()[:1], HEIGHT, axis=0)
        self.assertEqual(difference(matched(image, 7, 0), matched(image, 9, 20), True, False), (2, 0))

    def test_another_image_is_not_taken_for_the_one(self):
        u, v, colours = seen(random_image(), 0, 0)
        other = random_image()[::-1, ::-1]
        self.assertLess(match(other, u, v, colours).equal, 0.1)


if __name__ == "__main__":
    unittest.main()
