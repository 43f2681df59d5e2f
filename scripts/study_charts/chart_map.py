"""False misses over two difficulties, a map a method, with the triangles of scenes where they lie on it."""

import math

import matplotlib.pyplot as plt
import numpy
from matplotlib.colors import LogNorm

from study_charts.colours import INK, RAIL
from study_charts.runs import in_order
from study_charts.style import Chart, powers_on

COLOURS = "cividis"
COLUMNS = 5
SCENE_MARKS = {"color": "#ee3377", "s": 3, "linewidth": 0, "alpha": 0.6}


def edges_of(values):
    """Borders of cells whose middles are `values`, in the order of a logarithmic axis."""
    logs = numpy.log10(numpy.asarray(values, float))
    between = (logs[1:] + logs[:-1]) / 2
    first, last = logs[0] - (between[0] - logs[0]), logs[-1] + (logs[-1] - between[-1])
    return 10 ** numpy.concatenate(([first], between, [last]))


def shares_of(record):
    hits = numpy.asarray(record["hits"], float)
    with numpy.errstate(invalid="ignore", divide="ignore"):
        return numpy.where(hits > 0, numpy.asarray(record["false_misses"], float) / hits, math.nan)


def share_beyond(record, scene, least=0.01):
    """The share of a scene's triangles that lie where more than `least` of the hits are missed."""
    shares, inside = shares_of(record), 0
    x, y = (numpy.sort(edges_of(record[axis])) for axis in "xy")
    columns, rows = (numpy.argsort(record[axis]) for axis in "xy")
    for px, py in zip(scene["x"], scene["y"]):
        i, j = numpy.searchsorted(x, px) - 1, numpy.searchsorted(y, py) - 1
        if 0 <= i < len(columns) and 0 <= j < len(rows):
            inside += shares[rows[j], columns[i]] > least
    return inside / max(len(scene["x"]), 1)


def _facet(axes, record, scenes, weakest):
    shares = shares_of(record)
    seen = numpy.where(shares > 0, shares, math.nan)
    x, y = edges_of(record["x"]), edges_of(record["y"])
    none = numpy.where(shares == 0, 1.0, math.nan)
    axes.pcolormesh(x, y, none, cmap=plt.matplotlib.colors.ListedColormap([RAIL]), rasterized=True)
    image = axes.pcolormesh(x, y, seen, cmap=COLOURS, norm=LogNorm(weakest, 1), rasterized=True)
    for scene in scenes:
        axes.scatter(scene["x"], scene["y"], rasterized=True, **SCENE_MARKS)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(min(x), max(x))
    axes.set_ylim(min(y), max(y))
    axes.grid(False)
    axes.set_title(f"{record['method']}, {record['precision']}", fontsize=8.5)
    axes.tick_params(labelsize=7)
    axes.minorticks_off()
    powers_on(axes.xaxis)
    powers_on(axes.yaxis)
    return image


def map_chart(name, records, scenes):
    """All methods on one map; `scenes` have triangles on it."""
    rows = -(-len(records) // COLUMNS)
    columns = min(COLUMNS, len(records))
    shares = numpy.concatenate([shares_of(r).ravel() for r in records])
    weakest = 10 ** math.floor(math.log10(min(shares[shares > 0], default=0.1)))
    figure, grid = plt.subplots(rows, columns, figsize=(3.05 * columns + 0.6, 2.8 * rows + 0.6), squeeze=False, sharex=True, sharey=True, layout="constrained")  # fmt: skip
    for axes in grid.flat[len(records) :]:
        axes.set_axis_off()
    for axes, record in zip(grid.flat, records):
        image = _facet(axes, record, scenes, weakest)
    bar = figure.colorbar(image, ax=grid, fraction=0.02, pad=0.01)
    bar.set_label("share of hits that is missed")
    bar.outline.set_visible(False)
    bar.ax.minorticks_off()
    powers_on(bar.ax.yaxis)
    figure.supxlabel(records[0]["x_of"], fontsize=9, color=INK)
    figure.supylabel(records[0]["y_of"], fontsize=9, color=INK)
    title = title_of(records, scenes)
    figure.suptitle(title, x=0.01, ha="left")
    named = ", ".join(scene["scene"] for scene in scenes)
    points = f" Points: triangles of {named}, drawn at random from all of theirs." if scenes else " No scene's triangles were recorded."
    text = "Share of the oracle's hits that the method misses, over two difficulties. Pale: none was seen; blank: nothing to hit. Where a precision is too coarse for such triangles, it is what it makes of them that is judged." + points
    return Chart(f"map-{name}", title, text, figure)


def title_of(records, scenes):
    if not scenes:
        return f"False misses over {records[0]['x_of']} and {records[0]['y_of']}"
    drawn = f"triangles drawn from {' and '.join(scene['scene'] for scene in scenes)}"
    worst = {f"{r['method']}, {r['precision']},": max(share_beyond(r, s) for s in scenes) for r in records}
    method = max(worst, key=worst.get)
    if not worst[method]:
        return f"None of the {sum(len(s['x']) for s in scenes):,} {drawn} lies where a method misses more than 1 % of its hits"
    return f"Up to {100 * worst[method]:.2g} % of the {drawn} lie where {method} misses more than 1 % of its hits"


def map_charts(records):
    """One figure a map that was recorded."""
    for name in in_order(r["map"] for r in records):
        grids = [r for r in records if r["map"] == name and r["part"] == "grid"]
        scenes = [r for r in records if r["map"] == name and r["part"] == "scene"]
        if grids:
            yield map_chart(name, grids, scenes)
