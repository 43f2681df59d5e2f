"""What goes wrong against difficulty: a facet a case, a line a method."""

import math

import matplotlib.pyplot as plt

from study_charts.accuracy import NO_HIT, false_misses, t_error
from study_charts.colours import FAINT, RAIL
from study_charts.numbers import power
from study_charts.style import Chart, powers_on, thinned

COLUMNS = 5
# A method stands out in a facet where it is somewhere this many times better or worse than the middle one.
APART = 3.0


def error_value(record):
    """Infinite where every hit is missed; an error of 0 is drawn as a hundredth of ε, below what can be seen."""
    error = t_error(record)
    return None if error is None else max(error, 0.01)


def miss_value(record):
    rate = false_misses(record)
    return rate.upper * 1e6 if rate.of else None


def line_of(accuracy, method, precision, case, value):
    """Values level by level; None where there is none."""
    found = [accuracy.find(method, precision, case, level) for level, _ in accuracy.levels(case)]
    return [None if record is None else value(record) for record in found]


def middle_line(lines):
    """The median over methods, level by level."""
    middle = []
    for values in zip(*lines.values()):
        there = sorted(v for v in values if v is not None)
        middle.append(there[(len(there) - 1) // 2] if there else None)
    return middle


def distance(line, middle):
    """How far a line is from the middle one at most, in decades; infinite from infinity."""
    apart = [0.0]
    for a, b in zip(line, middle):
        if a is not None and b is not None and a != b:
            apart.append(math.inf if math.isinf(a) or math.isinf(b) else abs(math.log10(a / b)))
    return max(apart)


def standing_out(lines):
    """The methods whose lines are apart from the middle, the farthest first."""
    middle = middle_line(lines)
    apart = {method: distance(line, middle) for method, line in lines.items()}
    return sorted((m for m in apart if apart[m] > math.log10(APART)), key=lambda m: -apart[m])


def _draw(axes, line, top, **how):
    places = [i for i, value in enumerate(line) if value is not None]
    axes.plot(places, [min(line[i], top) for i in places], **how)


def _facet(axes, accuracy, case, lines, looks):
    finite = [v for line in lines.values() for v in line if v is not None and math.isfinite(v)]
    lost = any(v == NO_HIT for line in lines.values() for v in line)
    top = max(finite, default=1.0) * (10 if lost else 1)
    apart = standing_out(lines)
    axes.set_yscale("log")
    for method, line in lines.items():
        if method not in apart:
            _draw(axes, line, top, color=FAINT, linewidth=1, alpha=0.8)
    for method in reversed(apart):
        look = looks[method]
        _draw(axes, line=lines[method], top=top, color=look.colour, marker=look.marker, markersize=4, linewidth=1.1)
    if lost:
        axes.axhspan(top / 2, top * 2.5, color=RAIL, zorder=0, linewidth=0)
    if finite:
        axes.set_ylim(min(min(finite) / 2, 0.5 * top), top * 2.5)
    levels = accuracy.levels(case)
    axes.set_xticks(range(len(levels)), thinned([power(d) for _, d in levels], 5))
    axes.set_xlim(-0.3, len(levels) - 0.7)
    axes.set_title(wrapped(f"{case}: {accuracy.units[case]}"), fontsize=8)
    powers_on(axes.yaxis)
    axes.tick_params(labelsize=7)
    return apart


def _label_ends(axes, lines, apart):
    """Names over or under the right ends of lines, where no other line or name is."""
    top = axes.get_ylim()[1] / 2.5
    ends = {}
    for method, line in lines.items():
        places = [i for i, value in enumerate(line) if value is not None][-2:]
        ends[method] = [axes.transData.transform((i, min(line[i], top))) for i in places]
    taken = []
    for method in apart:
        x, y = ends[method][-1]
        others = [point[1] for other in lines if other != method for point in ends[other]] + taken
        others += [point[1] for point in ends[method][:-1]]
        for low, high, offset in ((4, 17, 4), (-17, -4, -11)):
            inside = axes.bbox.y0 < y + low and y + high < axes.bbox.y1
            if inside and not any(y + low < other < y + high for other in others):
                at = axes.transData.inverted().transform((x, y))
                axes.annotate(method, at, (3, offset), textcoords="offset points", ha="right", fontsize=6.5)
                taken += [y + low + 2, y + (low + high) / 2, y + high - 2]
                break


def wrapped(text, width=38):
    """At most two lines, the second ended by "…" if need be."""
    if len(text) <= width:
        return text
    cut = text.rfind(" ", 0, width)
    rest = text[cut + 1 :]
    return text[:cut] + "\n" + (rest if len(rest) <= width + 5 else rest[: width + 4] + "…")


def _cases(accuracy, precision, value):
    """Cases with values of two difficulties or more that are not all the same, and their lines."""
    for case in accuracy.cases:
        lines = {m: line_of(accuracy, m, precision, case, value) for m in accuracy.methods}
        lines = {m: line for m, line in lines.items() if any(v is not None for v in line)}
        levels = max((sum(v is not None for v in line) for line in lines.values()), default=0)
        if levels >= 2 and len({v for line in lines.values() for v in line if v is not None}) >= 2:
            yield case, lines


def _chart(name, what, unit, accuracy, precision, looks, value, text):
    facets = dict(_cases(accuracy, precision, value))
    if not facets:
        return None
    rows = -(-len(facets) // COLUMNS)
    figure, grid = plt.subplots(rows, COLUMNS, figsize=(15.5, 2.75 * rows + 0.4), squeeze=False, layout="constrained")
    for axes in grid.flat[len(facets) :]:
        axes.set_axis_off()
    outstanding = {c: _facet(axes, accuracy, c, lines, looks) for axes, (c, lines) in zip(grid.flat, facets.items())}
    for row in grid:
        row[0].set_ylabel(unit, fontsize=8)
    shown = [m for m in looks.methods if any(m in apart for apart in outstanding.values())]
    handles = [looks.handle(grid.flat[0], m) for m in shown]
    handles.append(grid.flat[0].plot([], [], color=FAINT, label=f"the others, within {APART:g}× of the middle one")[0])
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=6, fontsize=8)
    figure.canvas.draw()
    for axes, (case, lines) in zip(grid.flat, facets.items()):
        _label_ends(axes, lines, outstanding[case])
    title = title_of(outstanding)
    flat = [case for case in accuracy.cases if case not in facets]
    text += f" Left out, as nothing changes there: {', '.join(flat)}." if flat else ""
    figure.suptitle(f"{what}, {precision}, from easy (left) to hard (right). {title}", x=0.01, ha="left")
    return Chart(name, f"{what} against difficulty, {precision}. {title}", text, figure)


def title_of(outstanding):
    """Where methods go together, and which are apart most often."""
    together = [case for case, apart in outstanding.items() if not apart]
    counts = {}
    for apart in outstanding.values():
        for method in apart:
            counts[method] = counts.get(method, 0) + 1
    if not counts:
        return "All methods go together"
    most = max(counts.values())
    names = ", ".join(m for m in sorted(counts) if counts[m] == most)
    return f"All methods go together in {len(together)} of {len(outstanding)} cases; most often apart: {names} ({most})"


def difficulty_charts(accuracy, looks):
    for precision in accuracy.precisions:
        yield _chart(
            f"difficulty-error-{precision}", "Error of t", "p99, ε", accuracy, precision, looks, error_value,
            "99th percentile of |t − t*|/(ε|t*|) of the hits that method and oracle share; none is drawn at 0.01. In the band at the top: every "
            f"hit is missed. Coloured: apart from the middle method by more than {APART:g}× somewhere in the facet.",
        )  # fmt: skip
        yield _chart(
            f"difficulty-misses-{precision}", "False misses", "per million hits", accuracy, precision, looks, miss_value,
            "Hits by the oracle that the method misses. None seen is drawn at its bound of 3/n, so the lowest level of a facet "
            f"means none. Coloured: apart from the middle method by more than {APART:g}× somewhere in the facet.",
        )  # fmt: skip
