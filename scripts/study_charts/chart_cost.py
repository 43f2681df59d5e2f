"""ns a test against what goes wrong, a facet a class of cases, with the front of what nothing beats."""

import dataclasses
import math

import matplotlib.pyplot as plt

from study_charts.accuracy import CLASSES, Accuracy, class_of, false_misses, missed_rays
from study_charts.colours import FAINT, INK, PAPER, RAIL
from study_charts.kernels import Kernel
from study_charts.labels import place_labels
from study_charts.numbers import pareto_front
from study_charts.style import Chart, powers_on


@dataclasses.dataclass(frozen=True)
class Point:
    kernel: Kernel
    ns: object  # an Estimate
    wrong: float
    low: float
    high: float
    on_rail: bool  # none seen: `wrong` is a bound


def error_point(records):
    """Median and quartiles of the errors of t over cells, in ε; the error is infinite where hits are due and none come."""
    spread = Accuracy.error_spread(records)
    return None if spread is None else (spread.middle, spread.low, spread.high, False)


def miss_point(records):
    """Failures per million with their interval, of all cases together. On meshes a miss may be the neighbour's hit: of cases
    with meshes, rays count that no triangle stops."""
    on_mesh = [r for r in records if r["mesh_rays"]]
    rate = Accuracy.pooled(on_mesh, missed_rays) if on_mesh else Accuracy.pooled(records, false_misses)
    if rate is None:
        return None
    low, high = rate.interval
    return rate.upper * 1e6, low * 1e6, high * 1e6, rate.count == 0


def points_of(accuracy, kernels, workload, class_id, measure):
    """Of kernels that were both timed and judged. Combined changes are not among them: there are too many."""
    points = []
    for method, change, precision in accuracy.changes():
        kernel = Kernel(method, change, precision)
        ns = kernels.ns(kernel, workload)
        if kernel.combines or not ns:
            continue
        found = measure(accuracy.of(method, precision, change, lambda case: class_of(case) == class_id))
        if found:
            points.append(Point(kernel, ns, *found))
    return points


def front_of(points):
    return [points[i] for i in pareto_front([(p.ns.value, p.wrong) for p in points])]


def _error_bars(axes, point, look, top):
    wrong, base = min(point.wrong, top), point.kernel.change == "base"
    if base and not point.on_rail:
        axes.plot([point.ns.value] * 2, [max(point.low, top * 1e-30), min(point.high, top)], color=look.colour, linewidth=0.8, alpha=0.5)
    if base and point.ns.low is not None:
        axes.plot([point.ns.low, point.ns.high], [wrong] * 2, color=look.colour, linewidth=0.8, alpha=0.5)


def _mark(axes, point, look, top):
    base, is_float = point.kernel.change == "base", point.kernel.precision == "float"
    axes.plot(
        point.ns.value, min(point.wrong, top), look.marker, color=look.colour, markersize=6.5 if base else 2.5, zorder=3 if base else 2,
        markerfacecolor=look.colour if is_float else PAPER, markeredgewidth=1.2 if base else 0.5, alpha=1 if base else 0.5, rasterized=not base,
    )  # fmt: skip


def _rails(axes, points, top):
    """Bands at the edges: none seen at the bottom, nothing finite at the top."""
    rails = [p.wrong for p in points if p.on_rail]
    if rails:
        axes.axhspan(min(rails) / 1.7, max(rails) * 1.7, color=RAIL, zorder=0, linewidth=0)
        axes.text(0.01, min(rails) / 1.5, "none seen: ≤ 3/n", transform=axes.get_yaxis_transform(), fontsize=7, color=FAINT)
    if any(p.wrong > top for p in points):
        axes.axhspan(top / 2, top * 2, color=RAIL, zorder=0, linewidth=0)
        axes.text(0.99, top * 0.6, "every hit is missed in half of the cells", transform=axes.get_yaxis_transform(), ha="right", fontsize=7, color=FAINT)  # fmt: skip


def _facet(axes, points, looks, title):
    """Draws the points and their front. Returns the methods that found no place for a label."""
    finite = [p.wrong for p in points if math.isfinite(p.wrong)]
    top = 10 * max(finite, default=1.0)
    axes.set_xscale("log")
    axes.set_yscale("log")
    _rails(axes, points, top)
    for point in points:
        _error_bars(axes, point, looks[point.kernel.method], top)
    for point in points:
        _mark(axes, point, looks[point.kernel.method], top)
    front = front_of(points)
    if finite:
        low, high = min(finite) / 3, top * 2 if any(p.wrong > top for p in points) else max(finite) * 3
        wider = max(1.0, math.sqrt(100 / (high / low)))
        axes.set_ylim(low / wider, high * wider)
    axes.set_title(title)
    axes.set_xlabel("ns a test")
    powers_on(axes.xaxis)
    powers_on(axes.yaxis)
    _few_ticks(axes, points)
    steps = [(p.ns.value, min(p.wrong, top)) for p in front]
    steps.append((axes.get_xlim()[1], steps[-1][1]))
    axes.step(*zip(*steps), where="post", color=INK, linewidth=1, zorder=1)
    return front


def _few_ticks(axes, points):
    values = [p.ns.value for p in points]
    low, high = min(values) / 1.25, max(values) * 1.6
    axes.set_xlim(low, high)
    axes.set_xticks([v * 10**e for e in range(-2, 5) for v in (1, 2, 5) if low <= v * 10**e <= high])
    axes.xaxis.set_minor_locator(plt.NullLocator())


def _legend(figure, axes, looks, methods):
    handles = [looks.handle(axes, m, linestyle="none") for m in methods]
    handles.append(axes.plot([], [], "o", color=FAINT, label="filled: float")[0])
    handles.append(axes.plot([], [], "o", color=FAINT, markerfacecolor=PAPER, label="hollow: double")[0])
    handles.append(axes.plot([], [], color=INK, linewidth=1, label="front: nothing is better in both")[0])
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=6, fontsize=8)


def title_of(fronts):
    """What the fronts of all classes say together."""
    sets = [{(p.kernel.method, p.kernel.precision) for p in front} for front in fronts.values()]
    always = sorted(set.intersection(*sets))
    names = ", ".join(f"{m} ({p})" for m, p in always)
    once = len(set.union(*sets))
    if always:
        return f"On the front in every class: {names}"
    return f"No method is on the front in every class; {once} are in some"


def chart_cost(name, what, unit, accuracy, kernels, looks, measure, text):
    """One figure: `measure` of each class against ns, or None where nothing was both timed and judged."""
    workload = kernels.headline()
    facets = {c: points_of(accuracy, kernels, workload, c, measure) for c in accuracy.classes}
    facets = {c: points for c, points in facets.items() if points}
    if not facets:
        return None
    rows = -(-len(facets) // 3)
    columns = min(3, len(facets))
    figure, grid = plt.subplots(rows, columns, figsize=(5.0 * columns, 4.3 * rows), squeeze=False, layout="constrained")
    for axes in grid.flat[len(facets) :]:
        axes.set_axis_off()
    fronts = {}
    for axes, (class_id, points) in zip(grid.flat, facets.items()):
        fronts[class_id] = _facet(axes, points, looks, f"{class_id}: {CLASSES[class_id]}")
    for row in grid:
        row[0].set_ylabel(f"{what}, {unit}")
    _legend(figure, grid.flat[0], looks, [m for m in looks.methods if m in kernels.methods])
    title = title_of(fronts)
    figure.suptitle(f"{what} against ns a test ({workload}). {title}", x=0.01, ha="left")
    figure.canvas.draw()
    for axes, (class_id, points) in zip(grid.flat, facets.items()):
        _label(axes, points, fronts[class_id])
    return Chart(name, f"{what} against ns a test: {title[0].lower()}{title[1:]}", text.format(workload=workload), figure)


def _label(axes, points, front):
    """The front's names first, then the others' as far as there is place."""
    bases = [p for p in points if p.kernel.change == "base"]
    top = axes.get_ylim()[1] / 2
    ordered = sorted(bases, key=lambda p: (p not in front, p.ns.value))
    place_labels(axes, [(p.ns.value, min(p.wrong, top), p.kernel.method) for p in ordered])


def cost_charts(accuracy, kernels, looks):
    small = " Small marks are variants of the method of their colour. Horizontal bars: 95 % of the median over rounds."
    yield chart_cost(
        "cost-error", "Error of t", "ε of its own precision, 99th percentile", accuracy, kernels, looks, error_point,
        "Down and left is better. Time: {workload}. Error: the 99th percentile of |t − t*|/(ε|t*|) in each case and difficulty "
        "of the class; the mark is the median over these cells, the vertical bar reaches from the lower to the upper "
        "quartile. A cell in which every hit is missed counts as an infinite error." + small,
    )  # fmt: skip
    yield chart_cost(
        "cost-misses", "Misses", "per million", accuracy, kernels, looks, miss_point,
        "Down and left is better. Time: {workload}. W and F, meshes: of all rays at them, over cases and difficulties, those "
        "that no triangle stops. Elsewhere: of all hits by the oracle those that the method misses. Vertical bars: 95 % by "
        "Wilson's score. Where none was missed, the mark stands on the rail at 3/n, the bound at 95 %." + small,
    )  # fmt: skip
