"""The failure atlas: what every method does in every case at every difficulty, as one map."""

import math

import matplotlib.pyplot as plt
import numpy
from matplotlib.colors import LogNorm

from study_charts.accuracy import MEASURES
from study_charts.colours import FAINT, INK, RAIL
from study_charts.style import Chart

# Read from dark to light by anybody, and in grey.
COLOURS = "cividis"


def columns_of(accuracy, measure):
    """(case, level) of all cells in which there is something to fail, in the order of cases and from easy to hard."""
    columns = []
    for case in accuracy.cases:
        for level, _ in accuracy.levels(case):
            found = [accuracy.find(m, p, case, level) for m in accuracy.methods for p in accuracy.precisions]
            if any(r is not None and measure(r).of for r in found):
                columns.append((case, level))
    return columns


def rates_of(accuracy, precision, columns, measure):
    """A row a method: the share, 0 for none seen, NaN for what was not run or cannot fail."""
    rates = numpy.full((len(accuracy.methods), len(columns)), math.nan)
    for row, method in enumerate(accuracy.methods):
        for column, (case, level) in enumerate(columns):
            record = accuracy.find(method, precision, case, level)
            if record is not None and measure(record).of:
                rates[row, column] = measure(record).share
    return rates


def faultless(accuracy, rates):
    """Methods without any failure in their row."""
    return [m for m, row in zip(accuracy.methods, rates) if not numpy.nansum(row) and not numpy.all(numpy.isnan(row))]


def _frame(axes, accuracy, columns):
    """Names of methods and cases, and lines between cases."""
    axes.set_yticks(range(len(accuracy.methods)), [m for m in accuracy.methods])
    axes.grid(False)
    starts = [i for i, (case, _) in enumerate(columns) if i == 0 or columns[i - 1][0] != case]
    for start in starts[1:]:
        axes.axvline(start - 0.5, color=INK, linewidth=0.6)
    ends = starts[1:] + [len(columns)]
    axes.set_xticks([(a + b - 1) / 2 for a, b in zip(starts, ends)], [columns[a][0] for a in starts])
    axes.tick_params(length=0)


def _map(axes, rates, weakest):
    seen = numpy.where(rates > 0, rates, math.nan)
    extent = (-0.5, rates.shape[1] - 0.5, rates.shape[0] - 0.5, -0.5)
    row, column = numpy.nonzero(numpy.isnan(rates))
    axes.scatter(column, row, s=3, marker="x", linewidth=0.5, color=FAINT)
    for y, cells in enumerate(rates):
        for start, end in runs_of(cells == 0):
            axes.add_patch(plt.Rectangle((start - 0.5, y - 0.46), end - start, 0.92, color=RAIL, linewidth=0))
    return axes.imshow(seen, cmap=COLOURS, norm=LogNorm(weakest, 1), aspect="auto", interpolation="none", extent=extent)


def runs_of(flags):
    """(start, end) of each unbroken row of true values."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], flags.astype(int), [0]))))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist()))


def note_of(safe, count):
    if len(safe) == count:
        return "none seen"
    return f"only {', '.join(safe)} without any" if safe else "every method has some"


def failure_chart(accuracy, name):
    """One measure, a panel a precision; None where nothing of it can fail."""
    measure = MEASURES[name]
    columns = columns_of(accuracy, measure)
    if not columns:
        return None
    count = len(accuracy.precisions)
    figure, panels = plt.subplots(count, 1, figsize=(15, 0.6 + count * (0.6 + 0.2 * len(accuracy.methods))), squeeze=False, layout="constrained")
    rates = {p: rates_of(accuracy, p, columns, measure) for p in accuracy.precisions}
    weakest = 10 ** math.floor(math.log10(min((r[r > 0].min() for r in rates.values() if (r > 0).any()), default=0.1)))
    notes = []
    for axes, precision in zip(panels[:, 0], accuracy.precisions):
        image = _map(axes, rates[precision], weakest)
        _frame(axes, accuracy, columns)
        axes.set_title(f"{precision}; within a case from easy to hard")
        notes.append(f"{precision}: {note_of(faultless(accuracy, rates[precision]), len(accuracy.methods))}")
    bar = figure.colorbar(image, ax=panels[:, 0], fraction=0.02, pad=0.01)
    bar.set_label("share that fails")
    ticks = {1e-6: "10⁻⁶", 1e-5: "10⁻⁵", 1e-4: "10⁻⁴", 1e-3: "0.1 %", 1e-2: "1 %", 0.1: "10 %", 1.0: "all"}
    bar.set_ticks([t for t in ticks if t >= weakest], labels=[text for t, text in ticks.items() if t >= weakest])
    bar.ax.minorticks_off()
    bar.outline.set_visible(False)
    title = f"{name[0].upper()}{name[1:]}, every method in every case. {'; '.join(notes)}"
    figure.suptitle(title, x=0.01, ha="left")
    of = {"false misses": "the oracle's hits", "false hits": "the oracle's misses", "missed rays": "rays that meet the mesh"}[name]
    text = f"Share of {of}. Pale: none was seen. A small cross: not run, or nothing there to fail."
    return Chart(f"failures-{name.replace(' ', '-')}", title, text, figure)


def failure_charts(accuracy):
    return [failure_chart(accuracy, name) for name in MEASURES]
