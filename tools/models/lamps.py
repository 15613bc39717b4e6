"""What bears light: torch, lantern, chandelier, candle stand. Their flames are sprites."""

from mesh import around, moved, turned
from shapes import ball, band, box, lathe, rod

# Where flames stand, metres from a model's origin: out of it, and up.
TORCH_FLAME = (0.2, 0.46)
LANTERN_FLAME = 0.15
CHANDELIER_FLAMES = (6, 0.42, 0.15)  # how many, from the axis, up
STAND_FLAMES = (3, 0.13, 1.47)


def candle(height, radius=0.02):
    return lathe([(radius, 0), (radius, height - 0.01), (radius * 0.6, height)], 6, "plaster")


def dish(radius, height=0.03):
    return lathe([(radius * 0.4, 0), (radius, height * 0.7), (radius, height)], 8, "iron")


def torch():
    """On a bracket: its back is on the wall at x = 0."""
    out, _ = TORCH_FLAME
    part = box("iron", (0, 0, -0.045), (0.014, 0.3, 0.045), 1)
    part += rod("iron", [(0.01, 0.06, 0), (0.1, 0.07, 0), (out, 0.16, 0)], 0.013)
    part += rod("iron", [(0.01, 0.25, 0), (out, 0.25, 0)], 0.011)
    part += moved(band("iron", 0.03, 0.046, 0.235, 0.265, 8), out, 0, 0)
    upright = lathe([(0, 0.1), (0.032, 0.13), (0.05, 0.19), (0.04, 0.19), (0.04, 0.16)], 8, "iron")
    upright += lathe([(0.024, 0.14), (0.034, 0.4)], 8, "wood")
    upright += lathe([(0.036, 0.37), (0.052, 0.4), (0.056, 0.46), (0.045, 0.5), (0, 0.52)], 8, "ember")
    return part + moved(upright, out, 0, 0)


def lantern():
    """A cage with a candle in it, to be hung up by its ring. It is open above and below."""
    top = 0.34
    part = band("iron", 0.085, 0.1, 0, 0.02, 8)
    part += rod("iron", [(-0.09, 0.01, 0), (0.09, 0.01, 0)], 0.009)
    part += rod("iron", [(0, 0.01, -0.09), (0, 0.01, 0.09)], 0.009)
    part += around(rod("iron", [(0.093, 0.01, 0), (0.093, top - 0.07, 0)], 0.007), 4, 45)
    part += moved(lathe([(0.125, 0), (0.1, 0.03), (0.04, 0.08), (0.02, 0.12), (0, 0.13)], 8, "iron"),
                  0, top - 0.09, 0)
    part += moved(dish(0.04, 0.02), 0, 0.015, 0)
    part += moved(candle(0.1), 0, 0.03, 0)
    part += moved(turned(band("iron", 0.018, 0.027, -0.005, 0.005, 8), 0, 90), 0, top + 0.05, 0)
    return part


def chandelier():
    """An iron wheel of six candles, to be hung up by its ring."""
    count, out, up = CHANDELIER_FLAMES
    part = band("iron", out - 0.012, out + 0.012, 0.01, 0.05, 18, 3)
    part += band("iron", 0.05, 0.07, 0.01, 0.05, 9)
    part += around(rod("iron", [(0.055, 0.03, 0), (out, 0.03, 0)], 0.009), 3, 30)
    part += around(moved(dish(0.045), out, 0.045, 0) + moved(candle(up - 0.07), out, 0.07, 0), count)
    part += around(rod("iron", [(out, 0.05, 0), (0.015, 0.5, 0)], 0.006, 4), 3, 30)
    part += lathe([(0, 0), (0.03, 0.01), (0.03, 0.05), (0, 0.07)], 8, "iron")
    part += moved(ball("iron", 0.03), 0, 0.5, 0)
    part += moved(turned(band("iron", 0.02, 0.03, -0.006, 0.006, 8), 0, 90), 0, 0.55, 0)
    return part


def candle_stand():
    """Chest-high, for three candles."""
    count, out, up = STAND_FLAMES
    part = around(rod("iron", [(0.2, 0.005, 0), (0.19, 0.04, 0), (0.1, 0.11, 0), (0.015, 0.16, 0)],
                      [0.02, 0.016, 0.014, 0.014]), 3)
    part += lathe([(0, 0.12), (0.03, 0.14), (0.03, 0.2), (0.016, 0.24), (0.016, 0.7), (0.03, 0.73),
                   (0.03, 0.76), (0.016, 0.79), (0.016, 1.2), (0.05, 1.24), (0.05, 1.26), (0, 1.27)], 8, "iron")
    part += around(rod("iron", [(0.02, 1.23, 0), (0.09, 1.22, 0), (out, 1.29, 0)], 0.009), count)
    part += around(moved(dish(0.05), out, 1.28, 0) + moved(candle(up - 1.3), out, 1.3, 0), count)
    return part
