"""Misses and extra hits side by side: what each method does to rays at the edges of meshes."""

import matplotlib.pyplot as plt
from matplotlib.patches import Patch

from study_charts.accuracy import extra_rays, missed_rays
from study_charts.colours import FAINT, INK, PAPER
from study_charts.numbers import power, short
from study_charts.style import Chart

COLUMNS = 3
MISSED, EXTRA = "#cc3311", "#0077bb"


def failing_level(accuracy, case):
    """The level with the most missed and extra rays of all methods together, which need not be the hardest."""

    def missed(level):
        return sum(r["missed_rays"] + r["extra"] for r in accuracy.records if (r["case"], r["level"], r["change"]) == (case, level, "base"))

    return max(accuracy.levels(case), key=lambda pair: (missed(pair[0]), pair[0]))


def anything_wrong(accuracy, case):
    return any(r["missed_rays"] or r["extra"] for r in accuracy.records if (r["case"], r["change"]) == (case, "base"))


def percent(rate):
    """As in "12.3 %"; "0" for none seen."""
    return f"{short(100 * rate.share)} %" if rate.count else "0"


def _bar(axes, y, rate, sign, colour, filled, height):
    length = sign * 100 * (rate.share if rate.count else 0)
    axes.barh(y, length, height, color=colour if filled else PAPER, edgecolor=colour, linewidth=0.8)
    low, high = rate.interval
    if rate.count:
        axes.plot([sign * 100 * low, sign * 100 * high], [y, y], color=INK, linewidth=0.8)
    axes.annotate(
        percent(rate), (sign * 100 * (high if rate.count else 0), y), (3 * sign, 0), textcoords="offset points",
        ha="left" if sign > 0 else "right", va="center", fontsize=5.6, color=INK if rate.count else FAINT,
    )  # fmt: skip


def _facet(axes, accuracy, case, level):
    height = 0.8 / len(accuracy.precisions)
    widest = 0.0
    for row, method in enumerate(accuracy.methods):
        for number, precision in enumerate(accuracy.precisions):
            record = accuracy.find(method, precision, case, level)
            if record is None:
                continue
            y = row - 0.4 + height * (number + 0.5)
            for rate, sign, colour in ((missed_rays(record), -1, MISSED), (extra_rays(record), 1, EXTRA)):
                if rate.of:
                    _bar(axes, y, rate, sign, colour, precision == "float", height * 0.85)
                    widest = max(widest, 100 * rate.interval[1])
    axes.axvline(0, color=INK, linewidth=0.7)
    axes.set_xlim(-1.35 * widest, 1.35 * widest)
    axes.xaxis.set_major_locator(plt.MaxNLocator(5))
    axes.set_xticks([t for t in axes.get_xticks() if abs(t) <= 100])
    axes.xaxis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{abs(value):g} %"))
    axes.set_xlim(-1.35 * widest, 1.35 * widest)
    axes.set_yticks(range(len(accuracy.methods)), [m for m in accuracy.methods])
    axes.set_ylim(len(accuracy.methods) - 0.5, -0.5)
    axes.grid(False, axis="y")


def watertight(accuracy, precision):
    """Methods that let no ray through any mesh, whatever the case."""
    records = {m: accuracy.of(m, precision, only=lambda case: case in accuracy.mesh_cases) for m in accuracy.methods}
    return [m for m, rs in records.items() if rs and not any(r["missed_rays"] for r in rs)]


def mesh_chart(accuracy):
    """Of each case with a mesh, at the difficulty at which most goes wrong; None where nothing does in any."""
    cases = [case for case in accuracy.mesh_cases if anything_wrong(accuracy, case)]
    if not cases:
        return None
    columns, rows = min(COLUMNS, len(cases)), -(-len(cases) // COLUMNS)
    size = (5.2 * columns, rows * (0.9 + 0.27 * len(accuracy.methods)))
    figure, grid = plt.subplots(rows, columns, figsize=size, squeeze=False, sharey=True, layout="constrained")
    for axes in grid.flat[len(cases) :]:
        axes.set_axis_off()
    for axes, case in zip(grid.flat, cases):
        level, difficulty = failing_level(accuracy, case)
        _facet(axes, accuracy, case, level)
        axes.set_title(f"{case} at {power(difficulty)}: {accuracy.units[case]}", fontsize=8)
    handles = [Patch(color=MISSED, label="to the left: no hit"), Patch(color=EXTRA, label="to the right: more hits than the oracle")]
    handles += [Patch(color=FAINT, label="filled: float"), Patch(facecolor=PAPER, edgecolor=FAINT, label="hollow: double")]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=4)
    title = title_of(accuracy)
    figure.suptitle(title, x=0.01, ha="left")
    text = (
        "Rays at edges and corners of closed meshes, at the difficulty of each case at which most goes wrong. Left: rays that meet the "
        "mesh by the oracle and that no triangle stops. Right: rays with more hits than the oracle has hits and boundaries. "
        "Lines: 95 % by Wilson's score. A pale 0: none seen in n rays, at most 3/n at 95 %."
    )
    quiet = [case for case in accuracy.mesh_cases if case not in cases]
    text += f" Nothing goes wrong in: {', '.join(quiet)}." if quiet else ""
    return Chart("mesh", title, text, figure)


def title_of(accuracy):
    found = {p: ", ".join(m for m in watertight(accuracy, p)) for p in accuracy.precisions}
    if len(set(found.values())) == 1:
        found = {" and ".join(found): next(iter(found.values()))}
    return "; ".join(
        f"In {precision} only {names} lets no ray through any mesh" if names else f"In {precision} every method lets rays through a mesh"
        for precision, names in found.items()
    )
