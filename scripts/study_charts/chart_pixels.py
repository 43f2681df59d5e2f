"""From kernels to pictures: wrong pixels and FLIP against ns a ray."""

import dataclasses

import matplotlib.pyplot as plt

from study_charts.colours import FAINT, INK, PAPER, RAIL
from study_charts.labels import place_labels
from study_charts.numbers import Estimate, Rate, estimate_median, median
from study_charts.runs import in_order
from study_charts.style import Chart, powers_on

# Below this a mean FLIP is drawn as this: no difference that could be seen, and a logarithm has no 0.
LEAST_FLIP = 1e-8


@dataclasses.dataclass(frozen=True)
class Way:
    """One way to make a picture, over all rounds in which it was timed."""

    picture: str  # the scene, and how far it is moved
    core: str
    method: str
    precision: str
    wrong: Rate
    flip: float
    ns: Estimate  # a ray


def picture_of(record):
    return record["scene"] + (f" + {record['offset']:g}" if record["offset"] else "")


def ways(records):
    """Pictures are the same in every round; time is the median over rounds of the medians in them."""
    cells = {}
    for record in records:
        key = (picture_of(record), record["core"], record["method"], record["precision"])
        cells.setdefault(key, []).append(record)
    return [
        Way(*key, Rate(of[0]["wrong_pixels"], of[0]["pixels"]), of[0]["flip_mean"],
            estimate_median([median(r["seconds"]) * 1e9 / r["rays"] for r in of]))
        for key, of in cells.items()
    ]  # fmt: skip


def _mark(axes, way, y, look):
    filled = look.colour if way.precision == "float" else PAPER
    if way.ns.low is not None:
        axes.plot([way.ns.low, way.ns.high], [y, y], color=look.colour, linewidth=0.8, alpha=0.6)
    axes.plot(way.ns.value, y, look.marker, color=look.colour, markerfacecolor=filled, markersize=6.5)


def _facet(axes, of_facet, looks, value):
    axes.set_yscale("log")
    for way in of_facet:
        _mark(axes, way, value(way), looks[way.method])
    values = [value(way) for way in of_facet]
    axes.set_ylim(min(values) / 3, max(max(values) * 3, min(values) * 100))
    axes.margins(x=0.22)
    powers_on(axes.yaxis)


def _rail(axes, of_facet):
    """Where marks stand of what has no wrong pixel."""
    bounds = [way.wrong.upper * 1e6 for way in of_facet if not way.wrong.count]
    if bounds:
        axes.axhspan(min(bounds) / 1.7, max(bounds) * 1.7, color=RAIL, zorder=0, linewidth=0)
        axes.text(0.01, min(bounds) / 1.5, "none seen: ≤ 3/n", transform=axes.get_yaxis_transform(), fontsize=7, color=FAINT)


def _chart(name, title, text, unit, all_ways, looks, value, rail=False):
    """A column a picture, a row a core."""
    pictures, cores = in_order(w.picture for w in all_ways), in_order(w.core for w in all_ways)
    size = (max(3.6 * len(pictures), 8), 3.4 * len(cores) + 0.8)
    figure, grid = plt.subplots(len(cores), len(pictures), figsize=size, squeeze=False, layout="constrained")
    facets = []
    for axes, core, picture in ((grid[i, k], c, p) for i, c in enumerate(cores) for k, p in enumerate(pictures)):
        of_facet = [w for w in all_ways if w.core == core and w.picture == picture]
        axes.set_title(f"{picture}, {core}")
        axes.set_xlabel("ns a ray")
        if not of_facet:
            continue
        _facet(axes, of_facet, looks, value)
        if rail:
            _rail(axes, of_facet)
        facets.append((axes, of_facet))
    for axes in grid[:, 0]:
        axes.set_ylabel(unit)
    handles = [looks.handle(grid[0, 0], m, linestyle="none") for m in in_order(w.method for w in all_ways)]
    handles.append(grid[0, 0].plot([], [], "o", color=INK, label="filled: float")[0])
    handles.append(grid[0, 0].plot([], [], "o", color=INK, markerfacecolor=PAPER, label="hollow: double")[0])
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=6, fontsize=8)
    figure.suptitle(title, x=0.01, ha="left")
    figure.canvas.draw()
    for axes, of_facet in facets:
        place_labels(axes, [(w.ns.value, value(w), w.method) for w in of_facet])
    return Chart(name, title, text, figure)


def pixel_charts(records, looks):
    """Wrong pixels, and FLIP, of what has its reference's samples: rounding alone. None without records."""
    all_ways = ways([r for r in records if r["valid"] and r["subpixels"] == r["reference_subpixels"]])
    if not all_ways:
        return []
    time = "Time: the median over rounds; bars: 95 % by order statistics. The reference is the watertight method in doubles."
    return [
        _chart("pixels-wrong", title_of(all_ways), f"Pixels that differ by more than 1 of 255 in a channel; none at all stands on the rail at 3/n. {time}",
               "wrong pixels per million", all_ways, looks, lambda w: w.wrong.upper * 1e6, rail=True),
        _chart("pixels-flip", flip_title_of(all_ways), f"How visible the differences are (0: not, 1: as black from white), the mean over the picture. Below {LEAST_FLIP:g} it is drawn there. {time}",
               "mean FLIP", all_ways, looks, lambda w: max(w.flip, LEAST_FLIP)),
    ]  # fmt: skip


def title_of(all_ways):
    floats = [w for w in all_ways if w.precision == "float"]
    right = [m for m in in_order(w.method for w in floats) if not any(w.wrong.count for w in floats if w.method == m)]
    if right:
        return f"In float, every pixel is right in every picture by: {', '.join(right)}"
    doubles = [w for w in all_ways if w.precision == "double"]
    rest = ", in double none does" if doubles and not any(w.wrong.count for w in doubles) else ""
    return f"In float, every method gets some pixel wrong{rest}"


def flip_title_of(all_ways):
    worst = max(all_ways, key=lambda w: w.flip)
    return f"The most visible difference: {worst.flip:.2g}, {worst.method} in {worst.precision} on {worst.picture}"
