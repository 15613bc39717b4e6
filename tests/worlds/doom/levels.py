"""Finds walls of a map in the level that was made from it."""

from .pictures import UNIT

KEYS = {"upper": "upper", "lower": "lower", "middle": "texture"}


def find_texture(level, doom_map, wall):
    """What the level says of the image on a wall; None if it has the wall in pieces, or none there."""
    ends = ends_of(doom_map, wall)
    for sector in level["sectors"].values():
        for loop in sector["loops"].values():
            corners = list(zip(loop["v"][::2], loop["v"][1::2]))
            for own, *own_ends in zip(loop["walls"], corners, corners[1:] + corners[:1]):
                texture = own.get(KEYS[wall.part])
                if own_ends == ends and isinstance(texture, dict):
                    return texture
    return None


def ends_of(doom_map, wall):
    """In the level, from left to right."""
    line = doom_map.lines[wall.line]
    ends = [doom_map.vertices[i] for i in (line.start, line.end)]
    if wall.side != line.right:
        ends.reverse()
    return [(x * UNIT, -y * UNIT) for x, y in ends]
