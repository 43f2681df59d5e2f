"""A panel of a chart: points of series with intervals and raw samples over an axis of numbers, with bounds and borders."""

import dataclasses
import math


@dataclasses.dataclass(frozen=True)
class Point:
    """One estimate. `tip` holds (name, text) pairs for whoever points at it."""

    series: str
    x: float
    y: float
    low: float | None = None
    high: float | None = None
    tip: list = dataclasses.field(default_factory=list)
    samples: list = dataclasses.field(default_factory=list)  # (round, value) pairs


@dataclasses.dataclass(frozen=True)
class Bound:
    """A line that nothing was measured of: where it comes from is its name."""

    name: str
    points: list  # (x, y) pairs, from left to right


@dataclasses.dataclass(frozen=True)
class Border:
    """A vertical line at x; `text` names what begins on its right."""

    x: float
    text: str


@dataclasses.dataclass
class Panel:
    title: str
    x_title: str
    y_title: str
    points: list
    bounds: list = dataclasses.field(default_factory=list)
    borders: list = dataclasses.field(default_factory=list)
    ticks: list = dataclasses.field(default_factory=list)  # Points drawn as short bars: bounds of single points
    lines: bool = True  # between points of a series
    steps: bool = False  # lines go level, then up
    markers: bool = True
    dodged: bool = True  # series stand a little beside each other, for they share their x
    log_x: bool = False
    log_y: bool = False
    from_zero: bool = True
    x_values: list | None = None  # where the axis has ticks
    y_format: str | None = None  # d3's
    x_format: str | None = None
    y_domain: list | None = None
    x_domain: list | None = None
    head: int = 0  # rows of names of borders above it; as many in all panels of a chart, so that their titles stand level
    width: int = 250
    height: int = 210


# Of an axis, beyond its first and last point: series stand a little beside each other.
MARGIN = 0.08


def spread(values):
    """How many times the largest is the smallest; 1 where one of them is not above 0."""
    values = [v for v in values if v is not None]
    return max(values) / min(values) if values and min(values) > 0 else 1.0


def x_domain(panel):
    """A little wider than the points."""
    if panel.x_domain:
        return panel.x_domain
    xs = [p.x for p in panel.points]
    if panel.log_x:
        edge = max(1.12, (max(xs) / min(xs)) ** MARGIN)
        return [min(xs) / edge, max(xs) * edge]
    margin = max((max(xs) - min(xs)) * MARGIN, 0.3 if panel.lines and panel.markers else 0)
    return [min(xs) - margin, max(xs) + margin]


def y_domain(panel):
    """All points with their intervals and samples; bounds are cut off where they leave these behind."""
    if panel.y_domain:
        return panel.y_domain
    marks = panel.points + panel.ticks
    ys = [y for p in marks for y in [p.y, p.low, p.high, *[v for _, v in p.samples]] if y is not None and math.isfinite(y)]
    if panel.log_y:
        ys = [y for y in ys if y > 0]
        return [min(ys) / 1.15, max(ys) * 1.15]
    low, high = min(ys), max(ys)
    if panel.from_zero:
        return [min(0, low * 1.08), high * 1.08 if high > 0 else 0]
    margin = (high - low) * 0.06 or abs(high) * 0.05 or 1
    return [low - margin, high + margin]


def round_values(values):
    """Where an axis of counts has its ticks: all of a few, else the first and multiples of a step."""
    if len(values) <= 8:
        return values
    step = -(-max(values) // 6)
    return [values[0], *(step * n for n in range(1, 7) if values[0] < step * n <= max(values))]


def dodge(panel, series):
    """(pixels by which each series stands beside the true x, pixels between two), so that none hides another."""
    xs = sorted({p.x for p in panel.points})
    there = [s for s in series if any(p.series == s for p in panel.points)]
    if len(xs) < 2 or len(there) < 2 or not (panel.markers and panel.dodged):
        return dict.fromkeys(series, 0), 12.0
    low, high = x_domain(panel)
    if panel.log_x:
        gap = min(math.log(b / a) for a, b in zip(xs, xs[1:])) / math.log(high / low)
    else:
        gap = min(b - a for a, b in zip(xs, xs[1:])) / (high - low)
    step = min(6.0, 0.6 * gap * panel.width / len(there))
    return {s: round((there.index(s) - (len(there) - 1) / 2) * step, 2) if s in there else 0 for s in series}, step
