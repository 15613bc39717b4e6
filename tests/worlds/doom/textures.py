"""Composes wall textures from the patches of a WAD, as Doom does:
https://doomwiki.org/wiki/TEXTURE1_and_TEXTURE2, https://doomwiki.org/wiki/Picture_format."""

import struct

import numpy as np

from .wad import name_of


class Textures:
    def __init__(self, wad):
        self.wad = wad
        self.palette = np.frombuffer(wad.lump("PLAYPAL")[:768], np.uint8).reshape(256, 3)
        names = wad.lump("PNAMES")
        self.patches = [name_of(names[i:i + 8]) for i in range(4, len(names), 8)]
        self.definitions = {}
        self.composed = {}
        for lump in filter(None, map(wad.lump, ("TEXTURE1", "TEXTURE2"))):
            count, = struct.unpack_from("<i", lump)
            for begin in struct.unpack_from(f"<{count}i", lump, 4):
                self.definitions.setdefault(name_of(lump[begin:begin + 8]), lump[begin:])

    def has(self, name):
        return name in self.definitions

    def colours(self, name):
        """Rows of columns of red, green and blue; None of a texture with holes in it."""
        if name not in self.composed:
            indices = self.indices(name)
            self.composed[name] = None if (indices < 0).any() else self.palette[indices]
        return self.composed[name]

    def indices(self, name):
        """The same in numbers of the palette; -1 where there is a hole."""
        definition = self.definitions[name]
        width, height, _, count = struct.unpack_from("<hhih", definition, 12)
        placed = []
        for i in range(count):
            left, top, number = struct.unpack_from("<hhh", definition, 22 + 10 * i)
            placed.append((left, top, self.wad.lump(self.patches[number])))
        image = np.full((height, width), -1)
        is_alone = patches_by_column(placed, width) == 1
        for left, top, patch in placed:
            draw_patch(patch, left, np.where(is_alone, 0, top), image)
        return image


def patches_by_column(placed, width):
    counts = np.zeros(width, int)
    for left, _, patch in placed:
        counts[max(0, left):max(0, left + width_of(patch))] += 1
    return counts


def width_of(patch):
    return struct.unpack_from("<h", patch)[0]


def draw_patch(patch, left, tops, image):
    """`tops` are rows, for each column of the image: a patch that is alone in a column is drawn at its
    top, wherever it is placed."""
    for column, begin in enumerate(struct.unpack_from(f"<{width_of(patch)}i", patch, 8)):
        x = left + column
        if 0 <= x < image.shape[1]:
            draw_column(patch[begin:], tops[x], image[:, x])


def draw_column(posts, top, column):
    """Posts are a row, how many pixels, one that is not used, the pixels, and one more. Of one that
    begins above the image the first pixels are shown, and as many as lie above are left out."""
    row, at = -1, 0
    while posts[at] != 255:
        row = posts[at] if posts[at] > row else row + posts[at]  # of patches taller than 254
        first, count = top + row, posts[at + 1]
        shown = column[max(first, 0):max(first + count, 0)]
        shown[:] = np.frombuffer(posts, np.uint8, len(shown), at + 3)
        at += count + 4
