"""Compares how the walls of a place hang in Doom's picture and in Hearth's."""

import math
from collections import namedtuple

import numpy as np

from .offsets import difference, is_plain, match
from .pictures import DOOM_SCREEN, HEARTH_SCREEN, brightened
from .view import View
from .wad import NO_TEXTURE

TOLERANCE = 1  # texels
# Of a wall: fewer pixels, or columns or rows with any, are matched by chance.
MIN_PIXELS = 200
MIN_SIDE = 10
# A picture shows an image where so many of the pixels have exactly the colour of their texel. In 79
# views of walls of E1M1 at least 0.44 of Doom's had; other images reached 0.2 in one view of 100.
SHOWN = 0.33
# In degrees: those that are tried to measure that of a picture.
FIELDS_OF_VIEW = (89, 89.5, 90, 90.5, 91)

# Lines of which Doom moves the image.
SCROLLING = {48, 85, 250, 251, 252, 253, 254, 255}
# The first and last of each series of images that Doom shows in turn:
# https://doomwiki.org/wiki/Animated_wall
ANIMATED = [("BLODGR1", "BLODGR4"), ("SLADRIP1", "SLADRIP3"), ("BLODRIP1", "BLODRIP4"),
            ("FIREWALA", "FIREWALL"), ("GSTFONT1", "GSTFONT3"), ("FIRELAV3", "FIRELAVA"),
            ("FIREMAG1", "FIREMAG3"), ("FIREBLU1", "FIREBLU2"), ("ROCKRED1", "ROCKRED3"),
            ("BFALL1", "BFALL4"), ("SFALL1", "SFALL4"), ("WFALL1", "WFALL4"), ("DBRAIN1", "DBRAIN4")]

# Of one wall in one view: why it is `skipped`, if it is; its matches in both pictures; whether it is
# judged `along` and `down`; whether several shifts tie; and `difference`, texels between the pictures.
Judgement = namedtuple("Judgement", "wall skipped doom hearth along down tied difference",
                       defaults=(None, None, None, False, False, False, (0, 0)))


def is_wrong(judgement):
    """A picture with few pixels of the image may have it yet, rounded: then a single shift fits, and
    that is the same. Where more fit, that would be chance."""
    if judgement.skipped:
        return False
    is_shown = min(judgement.doom.equal, judgement.hearth.equal) >= SHOWN
    is_sure = judgement.along and judgement.down and not judgement.tied
    return max(judgement.difference) > TOLERANCE or not (is_shown or is_sure)


class Scene:
    """A place with what Doom and Hearth draw there."""

    def __init__(self, doom_map, textures, place, doom_picture, hearth_picture):
        self.map, self.textures, self.place = doom_map, textures, place
        self.pictures = {DOOM_SCREEN: doom_picture, HEARTH_SCREEN: hearth_picture}

    def judge(self):
        """Each wall in view."""
        doom, hearth = (Seen(self.map, self.place, screen, picture)
                        for screen, picture in self.pictures.items())
        return [self.judge_wall(wall, doom, hearth) for wall in hearth.walls() if wall in doom.walls()]

    def judge_wall(self, wall, doom, hearth):
        why = self.unfit(wall) or doom.unfit(wall) or hearth.unfit(wall)
        if why:
            return Judgement(wall, why)
        image = self.textures.colours(wall.texture)
        return compare(wall, doom.match(wall, brightened(image)), hearth.match(wall, image))

    def unfit(self, wall):
        """Why a wall cannot be judged whatever is seen of it."""
        if wall.texture == NO_TEXTURE or not self.textures.has(wall.texture):
            return "no texture"
        if self.map.lines[wall.line].special in SCROLLING or is_animated(wall.texture):
            return "moving"
        return "holes" if self.textures.colours(wall.texture) is None else None

    def fields_of_view(self):
        """Degrees in Doom's picture and in Hearth's: that with which most pixels have the colour
        that the map has there."""
        return [max(FIELDS_OF_VIEW, key=lambda degrees: self.fitting_pixels(screen, degrees))
                for screen in self.pictures]

    def fitting_pixels(self, screen, degrees):
        focal = screen.width / 2 / math.tan(math.radians(degrees / 2))
        seen = Seen(self.map, self.place, screen._replace(focal_x=focal), self.pictures[screen])
        brighten = brightened if screen is DOOM_SCREEN else lambda image: image
        return sum(seen.fitting_pixels(wall, brighten(self.textures.colours(wall.texture)))
                   for wall in seen.walls() if not self.unfit(wall) and not seen.unfit(wall))


def is_animated(texture):
    return any(len(texture) == len(first) and first <= texture <= last for first, last in ANIMATED)


def is_large(pixels):
    sides = [pixels.any(axis=axis).sum() for axis in (0, 1)]
    return pixels.sum() >= MIN_PIXELS and min(sides) >= MIN_SIDE


def compare(wall, doom, hearth):
    shown = [found.equal >= SHOWN for found in (doom, hearth)]
    if not any(shown):
        return Judgement(wall, "in neither", doom, hearth)
    along, down = (not any(is_plain(found.good.any(axis=axis)) for found in (doom, hearth))
                   for axis in (0, 1))
    if all(shown) and not along and not down:
        return Judgement(wall, "plain", doom, hearth)
    tied = bool(doom.minima.sum() > 1 or hearth.minima.sum() > 1)
    return Judgement(wall, None, doom, hearth, along, down, tied,
                     difference(doom, hearth, along, down))


class Seen:
    """A picture with what it should show."""

    def __init__(self, doom_map, place, screen, picture):
        self.view = View(doom_map, place, screen)
        self.picture = picture
        self.inside = self.view.insides()
        self.fine = self.inside & self.view.is_fine()
        self.usable = self.fine & ~self.view.covered

    def walls(self):
        """Those of which there are pixels."""
        return [self.view.names[i] for i in np.unique(self.view.walls[self.inside])]

    def unfit(self, wall):
        """Why what is seen of it does not do."""
        own = self.view.walls == self.view.known[wall]
        for pixels, why in ((self.inside, "small"), (self.fine, "far"), (self.usable, "covered")):
            if not is_large(own & pixels):
                return why
        return None

    def match(self, wall, image):
        own = self.usable & (self.view.walls == self.view.known[wall])
        return match(image, self.view.u[own], self.view.v[own], self.picture[own])

    def fitting_pixels(self, wall, image):
        found = self.match(wall, image)
        return found.equal * found.count
