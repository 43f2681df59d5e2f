"""From kernels to pictures: wrong pixels and FLIP against ns a ray."""

import matplotlib.pyplot as plt

from study_charts.labels import place_labels
from study_charts.numbers import Rate, estimate_median
from study_charts.runs import in_order
from study_charts.style import FAINT, INK, PAPER, RAIL, Chart, powers_on, spoken

# Below this a mean FLIP is drawn as this: no difference that could be seen, and a logarithm has no 0.
LEAST_FLIP = 1e-8


def ns_per_ray(record):
    return estimate_median(record["seconds"]).scaled(1e9 / record["rays"])


def wrong_pixels(record):
    return Rate(record["wrong_pixels"], record["pixels"])


def _mark(axes, record, y, look):
    ns = ns_per_ray(record)
    filled = look.colour if record["precision"] == "float" else PAPER
    if ns.low is not None:
        axes.plot([ns.low, ns.high], [y, y], color=look.colour, linewidth=0.8, alpha=0.6)
    axes.plot(ns.value, y, look.marker, color=look.colour, markerfacecolor=filled, markersize=6.5)


def _facet(axes, records, looks, value, title):
    values = [value(r) for r in records]
    axes.set_yscale("log")
    for record, y in zip(records, values):
        _mark(axes, record, y, looks[record["method"]])
    axes.set_ylim(min(values) / 3, max(max(values) * 3, min(values) * 100))
    axes.margins(x=0.18)
    axes.set_title(title)
    axes.set_xlabel("ns a ray")
    powers_on(axes.yaxis)


def _labels(axes, records, value):
    place_labels(axes, [(ns_per_ray(r).value, value(r), spoken(r["method"])) for r in records])


def pixel_chart(records, looks):
    """A column a scene: above wrong pixels per million, below the mean of FLIP. None without records."""
    scenes = in_order(r["scene"] for r in records)
    if not scenes:
        return None
    rows = {"wrong pixels per million": lambda r: wrong_pixels(r).upper * 1e6, "mean FLIP": lambda r: max(r["flip_mean"], LEAST_FLIP)}
    figure, grid = plt.subplots(2, len(scenes), figsize=(max(5.2 * len(scenes), 8), 7.6), squeeze=False, layout="constrained")
    for column, scene in enumerate(scenes):
        of_scene = [r for r in records if r["scene"] == scene]
        for axes, (unit, value) in zip(grid[:, column], rows.items()):
            _facet(axes, of_scene, looks, value, scene)
            axes.set_ylabel(unit if column == 0 else "")
        bounds = [wrong_pixels(r).upper * 1e6 for r in of_scene if not r["wrong_pixels"]]
        if bounds:
            grid[0, column].axhspan(min(bounds) / 1.7, max(bounds) * 1.7, color=RAIL, zorder=0, linewidth=0)
            grid[0, column].text(0.01, min(bounds) / 1.5, "none seen: ≤ 3/n", transform=grid[0, column].get_yaxis_transform(), fontsize=7, color=FAINT)  # fmt: skip
    methods = in_order(r["method"] for r in records)
    handles = [looks.handle(grid[0, 0], m, linestyle="none") for m in methods]
    handles.append(grid[0, 0].plot([], [], "o", color=INK, label="filled: float")[0])
    handles.append(grid[0, 0].plot([], [], "o", color=INK, markerfacecolor=PAPER, label="hollow: double")[0])
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=6, fontsize=8)
    title = title_of(records)
    figure.suptitle(title, x=0.01, ha="left")
    figure.canvas.draw()
    for column, scene in enumerate(scenes):
        for axes, value in zip(grid[:, column], rows.values()):
            _labels(axes, [r for r in records if r["scene"] == scene], value)
    text = (
        "Pixels that differ from those of the exact reference. Where none does, the mark stands on the rail at 3/n. A mean FLIP below "
        f"{LEAST_FLIP:g} is drawn there. Time: the median of the samples; bars: 95 % by order statistics."
    )
    return Chart("pixels", title, text, figure)


def title_of(records):
    right = [m for m in in_order(r["method"] for r in records) if not any(r["wrong_pixels"] for r in records if r["method"] == m and r["precision"] == "float")]  # fmt: skip
    names = ", ".join(map(spoken, right))
    return f"In float, every pixel is right in every scene by: {names}" if names else "In float, every method gets some pixel wrong"
