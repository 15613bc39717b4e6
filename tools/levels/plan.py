"""Writes level files from plans: rooms as outlines with floors and ceilings, whose walls are found.

A `Plan` is told where air is. Where the borders of two sectors run along one another and their
heights overlap, it makes them portals, or stacks of portals where several sectors lie above one
another; everything else is solid. So neighbours agree by construction, and textures are anchored to
the world: they run on from sector to sector and from storey to storey.

Coordinates are metres, y runs down the map, outlines may be given in either sense.
"""

import json
import math

SKY = 24.0  # the height of all skies: steps between them would show sky where towers stand behind
IMAGE = 128  # pixels of a side of all images that lie on slopes


def rounded(value, digits=3):
    value = round(value, digits)
    return int(value) if value == int(value) else value


def clockwise(points):
    """The outline with its air on the right of each wall, as the format wants it."""
    points = [(rounded(x), rounded(y)) for x, y in points]
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))
    return points if area > 0 else points[::-1]


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def ring(x, y, apothem, sides):
    """Corners of a regular polygon; side k faces 90 + k * 360 / sides degrees (side 0: south)."""
    radius = apothem / math.cos(math.pi / sides)
    turns = [(2 * k - 1) * math.pi / sides + math.pi / 2 for k in range(sides)]
    return [(x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns]


def edges(points):
    return list(zip(points, points[1:] + points[:1]))


def along(edge, point):
    """How far along the edge a point lies that is on it, in metres; None beside it."""
    (x0, y0), (x1, y1) = edge
    length = math.hypot(x1 - x0, y1 - y0)
    dx, dy = (x1 - x0) / length, (y1 - y0) / length
    if abs(dx * (point[1] - y0) - dy * (point[0] - x0)) > 0.0015:
        return None
    return dx * (point[0] - x0) + dy * (point[1] - y0)


class Sector:
    """Air between two heights. `wall` is what its solids wear, `skin` what its own mass (below its
    floor, above its ceiling) shows to its neighbours; None takes that of what lies above it.
    `floor_rise` and `ceiling_drop` are wedges: heights by (x, y), with `sidewall` on their sides.
    `foot` lists other stones that the masses around it stand on, (texture, up to z) from the ground
    up. `surround` = (texture, metres) is a frame around it on the walls of those that it opens into.
    `opening` names the sectors above and below of the flat portal that it belongs to. `floors` and
    `ceilings` are the heights that a flat has: two where it moves."""

    def __init__(self, name, outline, floor, ceiling, **other):
        self.name = name
        self.outline = clockwise(outline)
        self.holes = [clockwise(hole)[::-1] for hole in other.pop("holes", [])]
        self.floor, self.floor_texture = floor
        self.ceiling, self.ceiling_texture = ceiling
        self.floors, self.ceilings = {self.floor}, {self.ceiling}
        self.light = other.pop("light", None)
        self.wall = other.pop("wall", None)
        self.skin = other.pop("skin", None)
        self.foot = other.pop("foot", [])
        self.surround = other.pop("surround", None)
        self.opening = other.pop("opening", None)
        self.floor_rise = other.pop("floor_rise", None)
        self.ceiling_drop = other.pop("ceiling_drop", None)
        self.sidewall = other.pop("sidewall", None) or (self.skin if self.floor_rise else self.wall)
        assert not other, other

    def is_sky(self):
        return self.ceiling_texture == "sky"

    def loops(self):
        return [self.outline, *self.holes]

    def shares_air_with(self, other):
        (low, high), (other_low, other_high) = self.reach(), other.reach()
        is_open = min(high, other_high) - max(low, other_low) > 1e-9
        # A closed one was put there on purpose.
        return is_open or low == high or other_low == other_high

    def reach(self):
        """From its lowest to its highest, wherever what moves stands."""
        return min(self.floors), max(self.ceilings)


class Plan:
    def __init__(self, textures, sky, directed, pictures):
        self.sky = sky  # as the format writes it
        self.directed = directed  # textures that have a sense: turned, they have a suffix
        self.textures = textures  # by name: the size of one repeat, and whether it hangs from a mass
        self.pictures = pictures  # by name: where along its wall the image begins, and the height of its top
        self.sectors = []
        self.things = []  # each a dictionary, as the format names it
        self.movers = {}  # by name, likewise
        self.headings = {}  # by the name of the sector that each stands above
        self.pending = None  # the heading of the next sector

    def heading(self, text):
        self.pending = text

    def add(self, name, outline, floor, ceiling, **other):
        assert all(sector.name != name for sector in self.sectors), name
        if self.pending:
            self.headings[name], self.pending = self.pending, None
        self.sectors.append(Sector(name, outline, floor, ceiling, **other))

    def move(self, name, part, to, sectors, **how):
        """The floor or ceiling (`part`) of the sectors named moves from where it is to another height."""
        for sector in self.sectors:
            if sector.name in sectors:
                {"floor": sector.floors, "ceiling": sector.ceilings}[part].add(to)
        self.movers[name] = {"sectors": sectors, "part": part, "to": rounded(to), **how}

    # --- Neighbours

    def neighbours(self, sector):
        """For each loop: its pieces (a, b, sectors across from bottom to top, those that frame it)."""
        return [[piece for edge in edges(loop) for piece in self.pieces(sector, edge)]
                for loop in sector.loops()]

    def pieces(self, sector, edge):
        length = math.dist(*edge)
        spans = []
        for other in self.sectors:
            if other is sector or not sector.shares_air_with(other):
                continue
            for p, q in (piece for loop in other.loops() for piece in edges(loop)):
                begin, end = along(edge, q), along(edge, p)
                if begin is not None and end is not None and min(end, length) - max(begin, 0) > 0.01:
                    spans.append((begin, end, p, q, other))
        frames = [(begin - other.surround[1], end + other.surround[1], other)
                  for begin, end, _, _, other in spans if other.surround and not sector.surround]
        corners = {0: edge[0], length: edge[1]}

        def cut(at, point):
            if all(abs(at - known) > 0.005 for known in corners) and 0 < at < length:
                corners[at] = point

        for begin, end, p, q, _ in spans:
            cut(begin, q)
            cut(end, p)
        for begin, end, _ in frames:
            for at in (begin, end):
                cut(at, tuple(rounded(p + (q - p) * at / length) for p, q in zip(*edge)))
        places = sorted(corners)
        for a, b in zip(places, places[1:]):
            across = {other.name: other for begin, end, _, _, other in spans
                      if begin < (a + b) / 2 < end}
            framing = [other for begin, end, other in frames if begin < (a + b) / 2 < end]
            yield (corners[a], corners[b],
                   sorted(across.values(), key=lambda other: (other.floor, other.ceiling)), framing)

    def outline_of_skies(self):
        """The loops around all open air: where nothing but the void is left."""
        skies = [sector for sector in self.sectors if sector.is_sky()]
        nexts = {}
        for sector in skies:
            for piece in (piece for loop in sector.loops() for edge in edges(loop)
                          for piece in self.pieces(sector, edge)):
                a, b, across, _ = piece
                if not any(other.is_sky() for other in across):
                    assert a not in nexts, f"gaps in the open air meet at {a} ({sector.name})"
                    nexts[a] = b
        loops = []
        while nexts:
            start, here = next(iter(nexts.items()))
            loop = [start]
            del nexts[start]
            while here != start:
                loop.append(here)
                here = nexts.pop(here)
            loops.append(loop)
        return loops

    # --- Writing

    def texture(self, name, a=None, b=None, top=0.0):
        """As the format writes it; on a wall from a to b, anchored to the world. Without a `top` it goes with
        the edge of its step."""
        if name is None:
            return None
        if name.startswith("#"):
            return json.dumps(name)
        su, sv, hangs = self.textures[name]
        if a is None:
            return json.dumps(f"{name} {su},{sv}")
        length = math.dist(a, b)
        begin, anchor = self.pictures.get(name, (0, 0))
        start = (((b[0] - a[0]) * a[0] + (b[1] - a[1]) * a[1]) / length - begin) % su
        parts = [f'"name": "{name}", "scale": [{su}, {sv}]']
        if rounded(start) % su:
            parts.append(f'"along": {rounded(start)}')
        if top is not None:
            parts.append(f'"zref": {rounded(top + hangs) if hangs else anchor}')
        return "{ " + ", ".join(parts) + " }"

    def wall(self, sector, a, b, across, framing):
        def painted(name, top):
            return self.texture(name or sector.wall, a, b, top)

        def hung(heights, top):
            return top if len(heights) == 1 else None

        foot = [] if across and across[0].floor <= max((z for _, z in sector.foot), default=0) else sector.foot
        skins = [next((upper.skin for upper in across[i:] if upper.skin), None)
                 for i in range(len(across))]
        if foot or framing:
            bands = [(other.floor - other.surround[1], other.ceiling + other.surround[1], other.surround[0])
                     for other in framing]
            below = [sector.floor] + [z for _, z in foot]
            bands += [(low, z, texture) for low, (texture, z) in zip(below, foot)]
            return self.stack(self.clad(sector, across, skins, bands, painted), sector)
        if not across:
            return f'{{ "texture": {painted(sector.wall, sector.ceiling)} }}'
        rows = []
        for i, other in enumerate(across):
            is_last = i + 1 == len(across)
            top = max(sector.ceilings) if is_last else across[i + 1].floor
            row = [] if is_last else [f'"z": {rounded(top - sector.floor)}']
            row.append(f'"next": "{other.name}"')
            if i == 0 and max(other.floors) > min(sector.floors) and other.floor_texture != "sky":
                row.append(f'"lower": {painted(skins[i], hung(other.floors, other.floor))}')
            if min(other.ceilings) < top and not (is_last and sector.is_sky() and other.is_sky()):
                above = other.skin if is_last else skins[i + 1]
                row.append(f'"upper": {painted(above, hung(other.ceilings, top))}')
            rows.append(self.row(row))
        return self.listed(rows)

    def clad(self, sector, across, skins, bands, painted):
        """The pieces (top, what it is) of a wall whose masses wear `bands` (low, high, texture) of other
        stuff, the first that is found at a height."""
        def mass(low, high, skin):
            heights = sorted({low, high, *(z for band in bands for z in band[:2] if low < z < high)})
            for z0, z1 in zip(heights, heights[1:]):
                worn = [(texture, top) for begin, top, texture in bands if begin <= z0 and z1 <= top]
                texture, top = worn[0] if worn else (skin, high)
                yield z1, f'"texture": {painted(texture, top)}'

        z = sector.floor
        for skin, other in zip(skins, across):
            if other.floor - z > 0.001:
                yield from mass(z, other.floor, skin)
            z = min(other.ceiling, sector.ceiling)
            yield z, f'"next": "{other.name}"'
        if sector.ceiling - z > 0.001:
            yield from mass(z, sector.ceiling, across[-1].skin if across else None)

    def stack(self, pieces, sector):
        *below, (_, last) = pieces
        return self.listed([self.row([f'"z": {rounded(z - sector.floor)}', piece]) for z, piece in below] +
                           [self.row([last])])

    @staticmethod
    def listed(rows):
        if len(rows) == 1:
            return rows[0]
        return f'{{ "walls": [{", ".join(rows)}] }}'

    @staticmethod
    def row(parts):
        return "{ " + ", ".join(parts) + " }"

    def flat(self, z, texture, opening, rise=None, start=None):
        parts = [f'"z": {rounded(z)}']
        if opening:
            parts.append(f'"next": {{ "up": "{opening[0]}", "down": "{opening[1]}" }}')
        elif texture == "sky":
            parts.append(f'"texture": {json.dumps(self.sky)}, "parallax": true')
        else:
            parts.append(f'"texture": {self.sloped(texture, rise, start) if rise else self.texture(texture)}')
        return "{ " + ", ".join(parts) + " }"

    def sloped(self, name, rise, start):
        """The texture of a slope, turned to fall with it. Images lie on slopes as seen from above: where
        they shall not look drawn out, they are to be shorter by its steepness. They start at the border's
        first corner, `start`: right for tiles, whose rows go round a roof at one height; others are shifted
        to where they would lie from (0, 0), so that they run on however the slope is cut."""
        su, sv, _ = self.textures[name]
        fall = [rise(0, 0) - rise(1, 0), rise(0, 0) - rise(0, 1)]
        cosine = 1 / math.hypot(1, *fall)
        east, south = (0 if abs(part) < 0.01 else math.copysign(1, part) for part in fall)
        directed = name in self.directed
        if directed:
            suffix = {1: "s", -1: "n", 0: ""}[south] + {1: "e", -1: "w", 0: ""}[east]
            name += "" if suffix == "s" else f"-{suffix}"
            if east and south:  # painted aslant, and for a steep roof
                su, sv, cosine = su * math.sqrt(2), sv * math.sqrt(2), 1
        scale = (su * cosine, sv) if east else (su, sv * cosine)
        scale = [rounded(size) for size in scale]
        text = f"{name} {scale[0]},{scale[1]}"
        if not directed:
            shifts = [rounded(-IMAGE * at / size % IMAGE) for at, size in zip(start, scale)]
            text += f" {shifts[0]},{shifts[1]}"
        return json.dumps(text)

    def slope(self, heights, corners, texture):
        su, sv, _ = self.textures[texture]
        listed = ", ".join(str(rounded(max(heights(x, y), 0), 5)) for x, y in corners)
        sidewall = f'{{ "name": "{texture}", "scale": [{su}, {sv}], "zref": 0 }}'
        return f'{{ "z": [{listed}], "sidewall": {sidewall} }}'

    def loop(self, name, sector, pieces):
        corners = ", ".join(f"{a[0]},{a[1]}" for a, *_ in pieces)
        walls = [self.wall(sector, *piece) for piece in pieces]
        listed = walls[0] if len(set(walls)) == 1 else f'[{", ".join(walls)}]'
        return f'"{name}": {{ "v": [{corners}], "walls": {listed} }}'

    def sector(self, sector):
        loops = self.neighbours(sector)
        corners = [a for a, *_ in loops[0]]
        up = sector.opening if sector.opening and sector.name == sector.opening[0] else None
        down = sector.opening if sector.opening and not up else None
        members = []
        if sector.name in self.headings:
            members.append(f'"//": "--- {self.headings[sector.name]}"')
        if sector.light is not None:
            members.append(f'"light": {sector.light}')
        floor = self.flat(sector.floor, sector.floor_texture, up, sector.floor_rise, corners[0])
        members.append(f'"floor": {floor}')
        ceiling = self.flat(sector.ceiling, sector.ceiling_texture, down, sector.ceiling_drop, corners[0])
        members.append(f'"ceiling": {ceiling}')
        if sector.floor_rise:
            members.append('"slopeFloor": ' + self.slope(sector.floor_rise, corners, sector.sidewall))
        if sector.ceiling_drop:
            members.append('"slopeCeil": ' + self.slope(sector.ceiling_drop, corners, sector.sidewall))
        names = ["border"] + [f"hole-{i + 1}" for i in range(len(loops) - 1)]
        loops = [self.loop(name, sector, loop) for name, loop in zip(names, loops)]
        members.append(f'"loops": {{ {", ".join(loops)} }}')
        return f'"{sector.name}": {{ {", ".join(members)} }}'

    def text(self, head):
        """The level file, to be laid out by `hearth fmt`: `head` is the text of everything above the
        movers, things and sectors."""
        things = ",\n".join(json.dumps(thing) for thing in self.things)
        body = ",\n\n".join(self.sector(sector) for sector in self.sectors)
        movers = ",\n".join(f'"{name}": {json.dumps(mover)}' for name, mover in self.movers.items())
        return head + '\n"movers": {\n' + movers + '\n},\n\n"things": [\n' + things + '\n],\n\n"sectors": {\n\n' + body + "\n}}\n"
