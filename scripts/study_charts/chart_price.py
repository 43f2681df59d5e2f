"""What each fix costs: pairs of kernels that differ in one thing, compared round by round, in percent."""

import dataclasses

import matplotlib.pyplot as plt

from study_charts.colours import FAINT, INK, PAPER
from study_charts.kernels import Kernel
from study_charts.numbers import short
from study_charts.style import Chart


@dataclasses.dataclass(frozen=True)
class Fix:
    """What a value of a factor of the variant costs more than another one."""

    factor: str
    dear: str
    cheap: str
    title: str


FIXES = (
    Fix("division", "late", "early", "late division against early"),
    Fix("reciprocal", "exact", "newton", "exact reciprocal against Newton"),
    Fix("edges", "inclusive", "strict", "edges inclusive against strict"),
    Fix("contraction", "off", "on", "contraction off against on"),
)


@dataclasses.dataclass(frozen=True)
class Price:
    name: str
    precision: str
    percent: object  # an Estimate


def value_of(record, factor):
    return record[factor] if factor == "contraction" else record["variant"][factor]


def factor_prices(kernels, workload, fix):
    """Of each method with both values, one of them its base."""
    prices = []
    for kernel in kernels.kernels(workload):
        base = Kernel(kernel.method, "base", kernel.precision)
        if kernel.change.split("=")[0] != fix.factor or base not in kernels.kernels(workload):
            continue
        of = {value_of(kernels.facts(k), fix.factor): k for k in (kernel, base)}
        if fix.dear in of and fix.cheap in of:
            prices.append(Price(kernel.method, kernel.precision, kernels.price(of[fix.dear], of[fix.cheap], workload)))
    return [p for p in prices if p.percent]


def precision_prices(kernels, workload):
    """Double against float, of each method's base."""
    prices = []
    for method in kernels.methods:
        of, to = Kernel(method, "base", "double"), Kernel(method, "base", "float")
        prices.append(Price(method, "double", kernels.price(of, to, workload)))
    return [p for p in prices if p.percent]


def watertight_prices(kernels, workload, safe):
    """Each method that lets nothing through against the fastest one that does, of the same precision."""
    prices, plains = [], {}
    for precision in kernels.precisions:
        base = [k for k, _ in kernels.base(precision, workload)]
        plain = next((k for k in base if k.method not in safe), None)
        plains[precision] = plain
        for kernel in base:
            if plain and kernel.method in safe:
                prices.append(Price(kernel.method, precision, kernels.price(kernel, plain, workload)))
    return [p for p in prices if p.percent], plains


def groups_of(kernels, workload, safe):
    """Title → prices of all fixes of which there is one."""
    watertight, plains = watertight_prices(kernels, workload, safe)
    against = " / ".join(k.method for k in dict.fromkeys(plains.values()) if k)
    groups = {f"watertight against the fastest that is not ({against})": watertight}
    groups |= {fix.title: factor_prices(kernels, workload, fix) for fix in FIXES}
    groups["double against float"] = precision_prices(kernels, workload)
    return {title: prices for title, prices in groups.items() if prices}


def middle(prices):
    ordered = sorted(p.percent.value for p in prices)
    return ordered[len(ordered) // 2]


def _facet(axes, prices, looks, title):
    names = list(dict.fromkeys(p.name for p in prices))
    for price in prices:
        look, y = looks[price.name], names.index(price.name) + (0.17 if price.precision == "double" else -0.17)
        if price.percent.low is not None:
            axes.plot([price.percent.low, price.percent.high], [y, y], color=look.colour, linewidth=1.4, alpha=0.6)
        filled = look.colour if price.precision == "float" else PAPER
        axes.plot(price.percent.value, y, look.marker, color=look.colour, markerfacecolor=filled, markersize=5)
        end = price.percent.high if price.percent.high is not None else price.percent.value
        axes.annotate(f"{price.percent.value:+.1f}".replace("-", "−"), (end, y), (5, 0), textcoords="offset points", va="center", fontsize=6.5)
    axes.axvline(0, color=INK, linewidth=0.8)
    axes.set_yticks(range(len(names)), [n for n in names])
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.margins(x=0.12)
    axes.set_title(f"{title}\nmiddle of all: {middle(prices):+.1f} %".replace("-", "−"), fontsize=8.5)
    axes.set_xlabel("more time, %")


def price_chart(kernels, looks, safe):
    """`safe`: the methods that let no ray through a mesh. None where no pair was measured."""
    workload = kernels.headline()
    groups = groups_of(kernels, workload, safe)
    if not groups:
        return None
    columns = min(3, len(groups))
    rows = -(-len(groups) // columns)
    heights = [max(len({p.name for p in prices}) for prices in list(groups.values())[r * columns : (r + 1) * columns]) for r in range(rows)]
    figure, grid = plt.subplots(
        rows, columns, figsize=(5 * columns, sum(heights) * 0.3 + 1.3 * rows), squeeze=False, layout="constrained",
        gridspec_kw={"height_ratios": [h + 2 for h in heights]},
    )  # fmt: skip
    for axes in grid.flat[len(groups) :]:
        axes.set_axis_off()
    for axes, (title, prices) in zip(grid.flat, groups.items()):
        _facet(axes, prices, looks, title)
    handles = [grid.flat[0].plot([], [], "o", color=FAINT, label="filled: float")[0]]
    handles.append(grid.flat[0].plot([], [], "o", color=FAINT, markerfacecolor=PAPER, label="hollow: double")[0])
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=2)
    dearest = max(groups, key=lambda title: middle(groups[title]))
    title = f"The price of each fix: the dearest is {dearest}, {short(middle(groups[dearest]))} % in the middle"
    figure.suptitle(title, x=0.01, ha="left")
    text = (
        f"Extra time of the first of two kernels over the second, {workload}, as the median of ratios of the same rounds; lines: 95 % by "
        "order statistics, where there are six rounds or more. Below 0 the fix is faster than what it replaces."
    )
    return Chart("price", title, text, figure)
