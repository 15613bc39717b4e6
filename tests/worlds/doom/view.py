"""Tells which wall of a map a picture shows in each pixel, and where on the wall.

Walls are found by following a ray through the middle of each column over the plan, from line to
line, as long as something between floor and ceiling stays open. Units are those of Doom."""

import math
from collections import namedtuple

import numpy as np

from .wad import NO_SIDE, NO_TEXTURE, SKY

# A pixel is sampled at (column + phase, row + phase), `turn` radians to the left of there. `focal_x`
# and `focal_y` are how many columns and rows a wall as far away as it is wide and high is wide and
# high.
Screen = namedtuple("Screen", "width height focal_x focal_y phase turn")
Place = namedtuple("Place", "x y eye angle")  # angle in degrees, to the left of east
Wall = namedtuple("Wall", "line side part texture")

# Doom knows so many directions. It looks along the next one for a column, and takes it for the next
# one again, seen from a wall.
DIRECTIONS = 8192

NOTHING = -1


class View:
    """What a picture is expected to show. Arrays of the picture's size: `walls`, an index into
    `names` or NOTHING; `u`, units along the wall from its left end; `v`, units below height 0;
    `depth`, units from the eye in the direction in which it looks; `covered`, whether a middle
    texture hangs before the wall."""

    def __init__(self, doom_map, place, screen):
        self.map, self.place, self.screen = doom_map, place, screen
        shape = (screen.height, screen.width)
        self.walls = np.full(shape, NOTHING)
        self.u = np.zeros(shape)
        self.depth = np.ones(shape)
        self.covered = np.zeros(shape, bool)
        self.names = []
        self.known = {}
        rows = np.arange(screen.height) + screen.phase
        self.drop_per_depth = (rows - screen.height / 2) / screen.focal_y
        self.trace()
        self.v = self.depth * self.drop_per_depth[:, None] - place.eye

    def asides(self):
        """For each column, how far its ray goes to the right while it goes one forward."""
        columns = np.arange(self.screen.width) + self.screen.phase - self.screen.width / 2
        return np.tan(np.arctan(columns / self.screen.focal_x) - self.screen.turn)

    # --- Rays --------------------------------------------------------------------------------------

    def trace(self):
        starts = np.array([self.map.vertices[l.start] for l in self.map.lines], float)
        ends = np.array([self.map.vertices[l.end] for l in self.map.lines], float)
        for column, aside in enumerate(self.asides()):
            depths, alongs, rights = self.crossings(starts, ends, aside)
            hit = np.flatnonzero((depths > 0) & (alongs >= 0) & (alongs < 1))
            self.trace_column(column, [(depths[i], i, alongs[i], rights[i])
                                       for i in hit[np.argsort(depths[hit], kind="stable")]])

    def crossings(self, starts, ends, aside):
        """Where the ray of a column meets each line: how far, after which part of the line, and
        whether on its right side."""
        angle = math.radians(self.place.angle)
        ray = (math.cos(angle) + aside * math.sin(angle), math.sin(angle) - aside * math.cos(angle))
        dx, dy = (ends - starts).T
        x, y = (starts - (self.place.x, self.place.y)).T
        facing = ray[0] * dy - ray[1] * dx
        with np.errstate(divide="ignore", invalid="ignore"):
            return (x * dy - y * dx) / facing, (x * ray[1] - y * ray[0]) / facing, facing < 0

    def trace_column(self, column, crossings):
        top, bottom, is_covered = 0, self.screen.height, np.zeros(self.screen.height, bool)
        for depth, number, along, is_right in crossings:
            line = self.map.lines[number]
            own, other = (line.right, line.left) if is_right else (line.left, line.right)
            if own == NO_SIDE:
                continue
            left_to_right = along if is_right else 1 - along
            stripe = Stripe(self, column, depth, left_to_right * self.length(line), is_covered)
            front = self.map.sectors[self.map.sides[own].sector]
            top, bottom = stripe.narrow(top, bottom, front)
            if other == NO_SIDE:
                stripe.paint(top, bottom, self.index(number, own, "middle"))
                return
            top, bottom = self.paint_steps(stripe, top, bottom, number, own, other)
            if top >= bottom:
                return
            if self.map.sides[own].middle != NO_TEXTURE:
                is_covered[top:bottom] = True

    def paint_steps(self, stripe, top, bottom, number, own, other):
        """Of a line with two sides; returns what stays open."""
        front, back = (self.map.sectors[self.map.sides[side].sector] for side in (own, other))
        open_top, open_bottom = stripe.narrow(top, bottom, back)
        if not (front.ceiling_flat == SKY and back.ceiling_flat == SKY):
            stripe.paint(top, open_top, self.index(number, own, "upper"))
        stripe.paint(max(open_bottom, top), bottom, self.index(number, own, "lower"))
        return open_top, open_bottom

    def length(self, line):
        return math.dist(self.map.vertices[line.start], self.map.vertices[line.end])

    def index(self, line, side, part):
        wall = Wall(line, side, part, getattr(self.map.sides[side], part))
        if wall not in self.known:
            self.known[wall] = len(self.names)
            self.names.append(wall)
        return self.known[wall]

    # --- Pixels ------------------------------------------------------------------------------------

    def insides(self):
        """Pixels whose neighbours show the same wall."""
        inside = np.zeros(self.walls.shape, bool)
        middle = self.walls[1:-1, 1:-1]
        inside[1:-1, 1:-1] = middle != NOTHING
        for dx, dy in ((0, 1), (2, 1), (1, 0), (1, 2)):
            height, width = middle.shape
            inside[1:-1, 1:-1] &= self.walls[dy:dy + height, dx:dx + width] == middle
        return inside

    def is_fine(self):
        """Of pixels that are inside: whether on the wall no more than a unit lies between Doom's
        directions, and no more than two between rows."""
        columns_per_direction = 2 * math.pi / DIRECTIONS * self.screen.focal_x * (1 + self.asides() ** 2)
        along = np.abs(np.gradient(self.u, axis=1)) * columns_per_direction
        return (along <= 1) & (self.depth / self.screen.focal_y <= 2)


class Stripe:
    """The wall that a column shows at one depth."""

    def __init__(self, view, column, depth, u, is_covered):
        self.view, self.column, self.depth, self.u = view, column, depth, u
        self.is_covered = is_covered

    def row(self, z):
        """The first one whose sample lies below a height."""
        screen = self.view.screen
        y = screen.height / 2 - (z - self.view.place.eye) * screen.focal_y / self.depth
        return math.ceil(y - screen.phase)

    def narrow(self, top, bottom, sector):
        top = min(max(top, self.row(sector.ceiling)), bottom)
        return top, max(min(bottom, self.row(sector.floor)), top)

    def paint(self, top, bottom, wall):
        if top >= bottom:
            return
        at = (slice(top, bottom), self.column)
        self.view.walls[at] = wall
        self.view.u[at] = self.u
        self.view.depth[at] = self.depth
        self.view.covered[at] = self.is_covered[top:bottom]
