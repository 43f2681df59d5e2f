"""Do factors add up? Variants in which several are changed at once, against what each of them does alone."""

import dataclasses
import math

import matplotlib.pyplot as plt

from study_charts.accuracy import gravity
from study_charts.colours import FAINT, INK, PAPER
from study_charts.kernels import Kernel
from study_charts.numbers import short
from study_charts.runs import in_order
from study_charts.style import Chart

# What answers the question of a tracer: t and weights, edges included, a miss where there is none.
FULL = {"output": "weights", "edges": "inclusive"}


@dataclasses.dataclass(frozen=True)
class Combined:
    """`expected`: the product of what each change does alone to the time of the same form's base; `found`: what all do together;
    `noise`: what their intervals leave open between the two, as a factor above 1, infinite without intervals."""

    kernel: Kernel
    expected: float
    found: float
    noise: float

    @property
    def gap(self):
        """How far off the expectation is, as a factor above 1."""
        return math.exp(abs(math.log(self.found / self.expected)))


def noise_of(ratios):
    """Of a product of independent ratios: half the widths of their intervals, as logarithms, add up in squares."""
    if any(r.low is None for r in ratios):
        return math.inf
    return math.exp(math.sqrt(sum((math.log(r.high / r.low) / 2) ** 2 for r in ratios)))


def combined_on(kernels, workload):
    """All of one workload whose single changes were timed there too."""
    known = {(k.method, k.precision, frozenset(k.form), frozenset(k.factors)): k for b in (False, True) for k in kernels.kernels(workload, b)}
    found = []
    for kernel in kernels.kernels(workload, combined=True):
        form = (kernel.method, kernel.precision, frozenset(kernel.form))
        base = known.get((*form, frozenset()))
        singles = [known.get((*form, frozenset([change]))) for change in kernel.factors]
        if len(kernel.factors) < 2 or base is None or None in singles:
            continue
        ratios = [kernels.ratio(single, base, workload) for single in singles]
        whole = kernels.ratio(kernel, base, workload)
        if whole and all(ratios):
            found.append(Combined(kernel, math.prod(r.value for r in ratios), whole.value, noise_of([*ratios, whole])))
    return found


def groups_of(kernels):
    """(form, method) → (workload, variants), each form on the headline, or on the first workload where it was timed."""
    groups = {}
    for workload in in_order([kernels.headline(), *kernels.workloads]):
        for one in combined_on(kernels, workload):
            group = groups.setdefault((one.kernel.form, one.kernel.method), (workload, []))
            if group[0] == workload:
                group[1].append(one)
    return dict(sorted(groups.items()))


def form_text(form):
    """ "8 rays at once, avx2": counts of what goes together, else values."""
    words = []
    for factor, value in (change.split("=") for change in form):
        words.append(f"{value} {factor} at once" if factor in ("rays", "triangles") else value)
    return ", ".join(words) or "one ray and triangle"


def quickest(kernels, workload, variants):
    """Of those that give all that a tracer needs."""
    full = [v for v in variants if all(kernels.facts(v.kernel)["variant"][f] == value for f, value in FULL.items())]
    return min(full, key=lambda v: v.found, default=None)


def adding_up(kernels):
    """A sentence a form: how well single changes foretell combined ones, and which combination is the quickest."""
    groups, sentences = groups_of(kernels), []
    for form in in_order(form for form, _ in groups):
        of_form = {method: group for (f, method), group in groups.items() if f == form}
        found = [v for _, variants in of_form.values() for v in variants]
        gaps = sorted(v.gap for v in found)
        beyond = 100 * sum(v.gap > v.noise for v in found) / len(found)
        share = [100 * (gaps[int(q * (len(gaps) - 1))] - 1) for q in (0.5, 0.95)]
        workload = next(iter(of_form.values()))[0]
        text = f"{form_text(form).capitalize()}, {workload}: of {len(gaps):,} combinations half are within {short(share[0], 2)} % of what their changes do alone, 95 in 100 within {short(share[1], 2)} %; in {beyond:.0f} of 100 that is more than their intervals leave open."  # fmt: skip
        for method, (workload, variants) in of_form.items():
            for precision in kernels.precisions:
                best = quickest(kernels, workload, [v for v in variants if v.kernel.precision == precision])
                if best:
                    change = f"{100 * (best.found - 1):+.0f} %".replace("-", "−")
                    text += f" Quickest of {method} in {precision} that gives t and weights: {', '.join(best.kernel.factors)}, {change} to its base."
        sentences.append(text)
    return sentences


def failing_more(accuracy):
    """A sentence on cells in which a combination fails more often than the worst of its single changes and its base; None without any."""
    worse = cells = 0
    for method, change, precision in accuracy.changes():
        kernel = Kernel(method, change, precision)
        if not kernel.combines:
            continue
        for r in accuracy.of(method, precision, change):
            others = [accuracy.find(method, precision, r["case"], r["level"], c) for c in ("base", *kernel.factors)]
            if None in others:
                continue
            cells += 1
            worse += gravity(r) > 2 * max(gravity(other) for other in others) + 10 / max(r["trials"], 1)
    if not cells:
        return None
    return f"Failures: in {worse:,} of {cells:,} cells a combination fails more than twice as often as the worst of its changes alone."


def combined_chart(kernels, looks):
    """A panel a form and method; None where nothing was combined."""
    groups = groups_of(kernels)
    if not groups:
        return None
    forms, methods = in_order(form for form, _ in groups), in_order(method for _, method in groups)
    figure, grid = plt.subplots(len(forms), len(methods), figsize=(5 * len(methods), 4.3 * len(forms)), squeeze=False, layout="constrained")
    for row, form in zip(grid, forms):
        for axes, method in zip(row, methods):
            if (form, method) in groups:
                _panel(axes, *groups[form, method], looks[method], f"{method}: {form_text(form)}")
            else:
                axes.set_axis_off()
    handles = [grid[0, 0].plot([], [], "o", color=FAINT, label="filled: float")[0]]
    handles.append(grid[0, 0].plot([], [], "o", color=FAINT, markerfacecolor=PAPER, label="hollow: double")[0])
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=2)
    gaps = sorted(v.gap for _, variants in groups.values() for v in variants)
    title = f"Half of {len(gaps):,} combined variants take within {short(100 * (gaps[len(gaps) // 2] - 1), 2)} % of what their changes do alone"
    figure.suptitle(title, x=0.01, ha="left")
    text = (
        "Each mark is a variant in which two or more factors of the formula are changed at once. Across: the product of what each change does "
        "alone to the time of the base variant of the same form. Up: what all do together. On the line they add up; below it they help each other."
    )
    return Chart("combined", title, text, figure)


def _panel(axes, workload, variants, look, title):
    for precision in ("float", "double"):
        of_it = [v for v in variants if v.kernel.precision == precision]
        fill = look.colour if precision == "float" else PAPER
        x, y = [v.expected for v in of_it], [v.found for v in of_it]
        axes.plot(x, y, look.marker, color=look.colour, markerfacecolor=fill, markersize=3, alpha=0.7, markeredgewidth=0.6, rasterized=True)
    ends = [min(min(v.expected, v.found) for v in variants) / 1.1, max(max(v.expected, v.found) for v in variants) * 1.1]
    axes.plot(ends, ends, color=INK, linewidth=0.8)
    axes.set_xscale("log")
    axes.set_yscale("log")
    ticks = [t for t in (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 20) if ends[0] <= t <= ends[1]]
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_ticks(ticks, [f"{t:g}" for t in ticks])
        axis.set_minor_locator(plt.NullLocator())
    axes.set_title(f"{title}, {workload}", fontsize=8.5)
    axes.set_xlabel("time by its changes alone, × base")
    axes.set_ylabel("time, × base")
