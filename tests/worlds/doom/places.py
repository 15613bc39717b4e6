"""Chooses places on a map from which to look."""

import math
import random

import numpy as np

from .view import Place
from .wad import NO_SIDE

EYE = 41  # above the floor
BODY_HEIGHT = 56
CLEARANCE = 24  # from lines: no part of the body, 32 wide, stands on another sector's floor
PLAYER = 1
ANGLES = range(0, 360, 45)  # Doom turns a player's to one of these


def places_of(doom_map, count, seed):
    """Where the player begins, and where things stand, looking anywhere."""
    chooser = random.Random(f"{seed} {doom_map.name}")
    things = [thing for thing in doom_map.things if thing.type == PLAYER][:1]
    things += chooser.sample(doom_map.things, len(doom_map.things))
    places = []
    for i, thing in enumerate(things):
        angle = thing.angle // 45 * 45 if i == 0 else chooser.choice(ANGLES)
        sector = sector_with_room(doom_map, thing.x, thing.y)
        if sector and len(places) < count:
            places.append(Place(thing.x, thing.y, sector.floor + EYE, angle))
    return places


def sector_with_room(doom_map, x, y):
    """The one at a point; None where a body does not fit."""
    starts = np.array([doom_map.vertices[line.start] for line in doom_map.lines], float) - (x, y)
    ends = np.array([doom_map.vertices[line.end] for line in doom_map.lines], float) - (x, y)
    if nearest_distance(starts, ends) < CLEARANCE:
        return None
    sector = sector_at(doom_map, starts, ends)
    return sector if sector and sector.ceiling - sector.floor >= BODY_HEIGHT else None


def nearest_distance(starts, ends):
    """From the origin to any of the lines."""
    along = ends - starts
    squares = np.maximum((along ** 2).sum(axis=1), 1)
    part = np.clip(-(starts * along).sum(axis=1) / squares, 0, 1)
    return np.hypot(*(starts + part[:, None] * along).T).min()


def sector_at(doom_map, starts, ends):
    """The sector of the side of the first line that a ray from the origin meets. Its direction is
    one in which no corner lies."""
    angle = math.radians(17.3)
    ray = np.array([math.cos(angle), math.sin(angle)])
    along = ends - starts
    facing = ray[0] * along[:, 1] - ray[1] * along[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        depth = (starts[:, 0] * along[:, 1] - starts[:, 1] * along[:, 0]) / facing
        part = (starts[:, 0] * ray[1] - starts[:, 1] * ray[0]) / facing
    hit = np.flatnonzero((depth > 0) & (part >= 0) & (part < 1))
    if not len(hit):
        return None
    first = hit[np.argmin(depth[hit])]
    line = doom_map.lines[first]
    side = line.right if facing[first] < 0 else line.left
    return None if side == NO_SIDE else doom_map.sectors[doom_map.sides[side].sector]
