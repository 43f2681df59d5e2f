"""How fast each method is: against the hit rate, and as the bars of Havel's comparison of 2008."""

import dataclasses

import matplotlib.pyplot as plt

from study_charts.kernels import Kernel
from study_charts.numbers import short
from study_charts.style import Chart


def rate_chart(kernels, looks):
    """ns a test against the share of tests that hit, a panel a precision; None where no hit rate was asked for."""
    workloads = kernels.of_protocol("hit-rate")
    if len(workloads) < 2:
        return None
    figure, panels = plt.subplots(1, len(kernels.precisions), figsize=(7.5 * len(kernels.precisions), 5.2), squeeze=False, layout="constrained")
    firsts = []
    for axes, precision in zip(panels[0], kernels.precisions):
        for method in kernels.methods:
            _line(axes, kernels, Kernel(method, "base", precision), workloads, looks[method])
        axes.set_yscale("log")
        axes.set_xlabel("share of tests that hit")
        axes.set_ylabel("ns a test")
        axes.set_title(precision)
        _ticks(axes)
        fastest = [kernels.base(precision, w)[0][0].method for w in workloads if kernels.base(precision, w)]
        firsts.append(f"{precision}: {' → '.join(dict.fromkeys(fastest))}")
    handles = [looks.handle(panels[0, 0], m) for m in kernels.methods]
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=6, fontsize=8)
    title = f"Fastest as the hit rate grows: {'; '.join(firsts)}"
    figure.suptitle(title, x=0.01, ha="left")
    text = "Each method's base variant, one ray with one triangle. Bars: 95 % of the median over rounds by order statistics."
    return Chart("speed-hit-rate", title, text, figure)


def _ticks(axes):
    low, high = axes.get_ylim()
    axes.set_yticks([v * 10**e for e in range(-2, 5) for v in (1, 2, 3, 5, 7) if low <= v * 10**e <= high])
    axes.yaxis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_locator(plt.NullLocator())


def _line(axes, kernels, kernel, workloads, look):
    found = [(w.parameter, kernels.ns(kernel, w)) for w in workloads]
    found = [(x, ns) for x, ns in found if ns]
    axes.plot([x for x, _ in found], [ns.value for _, ns in found], color=look.colour, marker=look.marker, markersize=5)
    for x, ns in found:
        if ns.low is not None:
            axes.plot([x, x], [ns.low, ns.high], color=look.colour, linewidth=2.5, alpha=0.35)


@dataclasses.dataclass(frozen=True)
class Bar:
    name: str
    method: str
    value: float
    low: float | None = None
    high: float | None = None


def time_bars(kernels, workload, chosen, with_change=False):
    """ns a test of the kernels that `chosen(kernel, record)` is true of, the fastest first."""
    bars = []
    for kernel in kernels.kernels(workload):
        if chosen(kernel, kernels.facts(kernel)):
            ns = kernels.ns(kernel, workload)
            name = kernel.method + (f", {kernel.change.split('=')[1]}" if with_change and kernel.change != "base" else "")
            bars.append(Bar(name, kernel.method, ns.value, ns.low, ns.high))
    return sorted(bars, key=lambda bar: bar.value)


# What errors are told of where one case has to speak for all: triangles of size 1 at the origin, else edges of a mesh.
ERROR_CASES = ("F1", "W1")


def error_case(accuracy):
    return next((case for case in ERROR_CASES if case in accuracy.cases), accuracy.cases[0])


def error_bars(accuracy, precision, error):
    """The mean relative error in millionths at the easiest level of `error_case`; `error` is t_error or weight_error."""
    case = error_case(accuracy)
    epsilon = {"float": 2.0**-23, "double": 2.0**-52}[precision]
    records = [accuracy.find(m, precision, case, accuracy.levels(case)[0][0]) for m in accuracy.methods]
    found = [(r["method"], r[error]["mean"]) for r in records if r and r[error]["count"]]
    return sorted((Bar(m, m, mean * epsilon * 1e6) for m, mean in found), key=lambda bar: bar.value)


def without_early_outs(kernels, workload):
    """The kernels that end no test early, by their change; where there are none, as where all tests are hits, the base kernels."""
    bars = time_bars(kernels, workload, _is("float", "early_out=no"))
    return bars or time_bars(kernels, workload, _is("float"))


def _is(precision, change="base", **variant):
    def chosen(kernel, record):
        same = all(record["variant"][factor] == value for factor, value in variant.items())
        return kernel.precision == precision and kernel.change == change and same

    return chosen


def groups_of(kernels, accuracy):
    """Title and unit → bars, in the order of the comparison's figures."""
    plain = kernels.headline()
    groups = {}
    # Of methods with both, one is the base and the other a change.
    for title, value in (("no precomputation", "bare"), ("precomputed", "precomputed")):

        def chosen(kernel, record, value=value):
            return kernel.precision == "float" and kernel.change.split("=")[0] in ("base", "data") and record["variant"]["data"] == value

        groups[f"{title}, float, {plain}"] = time_bars(kernels, plain, chosen)
    for protocol, words in (("packet-common", "packets of a common origin"), ("packet-general", "packets of any rays")):
        for workload in kernels.of_protocol(protocol):
            wide = time_bars(kernels, workload, lambda k, r: k.precision == "float" and r["rays_at_once"] > 1, True)
            groups[f"{words}, float; name, rays at once"] = wide
    for value in ("early", "late"):

        def placed(kernel, record, value=value):
            return kernel.precision == "float" and kernel.change.split("=")[0] in ("base", "division") and record["variant"]["division"] == value

        groups[f"division {value}, float, {plain}"] = time_bars(kernels, plain, placed)
    for workload in kernels.of_protocol("worst-case"):
        groups[f"no early out, float, {workload}"] = without_early_outs(kernels, workload)
    groups[f"double, {plain}"] = time_bars(kernels, plain, _is("double"))
    groups = {(title, "ns a test"): bars for title, bars in groups.items()}
    if accuracy:
        for precision in accuracy.precisions:
            groups[(f"mean error of t, {precision}", "millionths of t")] = error_bars(accuracy, precision, "t_error")
            weights = error_bars(accuracy, precision, "weight_error")
            groups[(f"mean error of β and γ, {precision}", "millionths of them")] = weights
    return {key: bars for key, bars in groups.items() if bars}


def bar_chart(kernels, accuracy, looks):
    """Horizontal bars, a panel a group; None without any group."""
    groups = groups_of(kernels, accuracy)
    if not groups:
        return None
    columns = min(3, len(groups))
    rows = -(-len(groups) // columns)
    heights = [max(len(bars) for bars in list(groups.values())[r * columns : (r + 1) * columns]) for r in range(rows)]
    figure, grid = plt.subplots(
        rows, columns, figsize=(5 * columns, sum(heights) * 0.2 + 0.9 * rows), squeeze=False, layout="constrained",
        gridspec_kw={"height_ratios": [h + 2 for h in heights]},
    )  # fmt: skip
    for axes in grid.flat[len(groups) :]:
        axes.set_axis_off()
    for axes, ((title, unit), bars) in zip(grid.flat, groups.items()):
        _panel(axes, bars, looks, title, unit)
    spreads = {title: bars[-1].value / bars[0].value for (title, unit), bars in groups.items() if unit == "ns a test"}
    widest = max(spreads, key=spreads.get)
    title = f"From the fastest to the slowest it is a factor of {short(spreads[widest])} at most ({widest.split(';')[0]})"
    figure.suptitle(title, x=0.01, ha="left")
    text = (
        "The groups of Havel 2008, each from the fastest to the slowest. Lines: 95 % of the median over rounds."
    )
    if accuracy:
        text += f" Errors are those of {error_case(accuracy)} at its easiest difficulty."
    return Chart("speed-bars", title, text, figure)


def _panel(axes, bars, looks, title, unit):
    colours = [looks[bar.method].colour for bar in bars]
    axes.barh(range(len(bars)), [bar.value for bar in bars], 0.72, color=colours, alpha=0.85, linewidth=0)
    for y, bar in enumerate(bars):
        if bar.low is not None:
            axes.plot([bar.low, bar.high], [y, y], color="#1b1f24", linewidth=1)
        end = bar.value if bar.high is None else bar.high
        axes.annotate(short(bar.value), (end, y), (3, 0), textcoords="offset points", va="center", fontsize=6.5)
    axes.set_yticks(range(len(bars)), [bar.name for bar in bars], fontsize=7)
    axes.set_ylim(len(bars) - 0.4, -0.6)
    axes.set_xlim(0, 1.12 * max(bar.high or bar.value for bar in bars))
    axes.grid(False, axis="y")
    axes.set_title(title, fontsize=8.5)
    axes.set_xlabel(unit, fontsize=8)
