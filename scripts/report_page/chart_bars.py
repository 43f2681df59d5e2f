"""Estimates by names, from best to worst: a row each, with interval and samples. Nothing is joined, for names have no order."""

import dataclasses

from report_page.chart import Chart, estimate_text, few_enough, main_quantity, samples_sentence, tip_of
from report_page.chart_sweep import LARGER_IS_BETTER
from report_page.factors import label, telling, unit
from report_page.layout import MOST_PANELS, split
from report_page.panel import spread
from report_page.marks import FAINT, intervals, significant, sized

# More rows than these in one panel would be no picture.
MOST_ROWS = 40
ROW = 17  # pixels


@dataclasses.dataclass(frozen=True)
class Bars:
    """A panel: names from best to worst with their rows; `left_out` are behind them."""

    title: str
    named: list
    left_out: int


def bars_of(rows, quantity, title, names):
    def value(row):
        return row["values"][quantity]["value"]

    ordered = sorted(rows, key=value, reverse=quantity in LARGER_IS_BETTER)
    named = [(label(row["factors"], names) or "this run", row) for row in ordered]
    return Bars(title, named[:MOST_ROWS], max(0, len(named) - MOST_ROWS))


def bar_data(number, bars, quantity, raw):
    points, samples = [], []
    for name, row in bars.named:
        estimate = row["values"][quantity]
        low, high = (significant(estimate[end]) for end in ("low", "high"))
        points.append(
            {"s": name, "x": significant(estimate["value"]), "low": low, "high": high, "tip": [list(t) for t in tip_of(row, quantity, name)]}
        )
        samples += [{"s": name, "r": r, "x": significant(v)} for r, v in (row["samples"].get(quantity, []) if raw else [])]
    return [{"name": f"points{number}", "values": points}, {"name": f"samples{number}", "values": samples}, intervals(number)]


def bar_marks(number, sample):
    at = {"x": {"scale": "x", "field": "x"}, "y": {"scale": "y", "field": "s", "band": 0.5}}
    tip = {"signal": f"[[datum.s, ''], ['{sample}', datum.r], ['value', format(datum.x, '.4~g')]]"}
    small = at | {"fill": FAINT, "size": {"value": 9}, "opacity": {"value": 0.55}, "tooltip": tip}
    colour = {"scale": "colour", "value": "value"}
    rule = {
        "x": {"scale": "x", "field": "low"}, "x2": {"scale": "x", "field": "high"}, "y": at["y"], "stroke": colour, "strokeWidth": {"value": 2.2},
    }  # fmt: skip
    point = at | {
        "fill": colour, "stroke": {"signal": "paper"}, "strokeWidth": {"value": 0.8}, "size": {"value": 52}, "tooltip": {"field": "tip"},
        "description": {"signal": "datum.s + ': ' + format(datum.x, '.4~g')"},
    }  # fmt: skip
    return [
        {"type": "symbol", "from": {"data": f"samples{number}"}, "clip": True, "aria": False, "encode": {"update": small}},
        {"type": "rule", "from": {"data": f"intervals{number}"}, "interactive": False, "aria": False, "encode": {"update": rule}},
        {"type": "symbol", "name": f"point_marks{number}", "from": {"data": f"points{number}"}, "encode": {"update": point, "hover": {"size": {"value": 110}}}},
    ]  # fmt: skip


def bar_domain(bars, quantity, raw):
    """(domain, whether it is logarithmic): from 0 where that leaves something to see."""
    xs = []
    for _, row in bars.named:
        estimate = row["values"][quantity]
        xs += [estimate[key] for key in ("value", "low", "high") if estimate.get(key) is not None]
        xs += [v for _, v in row["samples"].get(quantity, [])] if raw else []
    if spread([row["values"][quantity]["value"] for _, row in bars.named]) > 15:
        xs = [x for x in xs if x > 0]
        return [min(xs) / 1.2, max(xs) * 1.2], True
    return [min(0, min(xs) * 1.05), max(xs) * 1.05 or 1], False


def bar_group(number, bars, quantity, raw, width, sample):
    domain, log = bar_domain(bars, quantity, raw)
    height = ROW * len(bars.named)
    return {
        "type": "group", "title": {"text": bars.title, "limit": 420} if bars.title else None,
        **sized(width, height),
        "scales": [
            {"name": "x", "type": "log" if log else "linear", "domain": domain, "range": [0, width], "zero": False},
            {"name": "y", "type": "band", "domain": [name for name, _ in bars.named], "range": [0, height]},
        ],
        "axes": [
            {"orient": "bottom", "scale": "x", "title": unit(quantity), "grid": True, "labelOverlap": "greedy", "tickCount": 6, "format": ".6~g"},
            {"orient": "left", "scale": "y", "grid": True, "ticks": False, "domain": False, "bandPosition": 0.5, "labelPadding": 6},
        ],
        "marks": bar_marks(number, sample),
    }  # fmt: skip


def bars_spec(panels, quantity, raw, sample="round"):
    """The specification; `sample` is what one of the small dots is of."""
    width = 560 if len(panels) == 1 else 320
    data, groups = [], []
    for number, bars in enumerate(panels):
        data += bar_data(number, bars, quantity, raw)
        groups.append({k: v for k, v in bar_group(number, bars, quantity, raw, width, sample).items() if v is not None})
    return {
        "padding": 8, "data": data, "scales": [{"name": "colour", "type": "ordinal", "domain": ["value"], "range": "category"}],
        "layout": {"padding": {"row": 28, "column": 34}, "columns": min(2, len(panels)), "bounds": "full", "align": "each"}, "marks": groups,
    }  # fmt: skip


def panels_of(rows, quantity, apart):
    """One panel where all have place in it; else one for each value of the outermost factor, then of the two outermost, …

    Values of the factors `apart` never share a panel.
    """
    names = sorted(telling(rows), key=lambda name: name not in apart)
    for outer in range(sum(name in apart for name in names), len(names)):
        groups = split(rows, names[:outer]) if outer else [("", rows)]
        if max(len(mine) for _, mine in groups) <= MOST_ROWS or outer == len(names) - 1:
            return [bars_of(mine, quantity, title, names[outer:]) for title, mine in groups]
    return [bars_of(rows, quantity, "", names)]


def bars_chart(run, quantity=None, apart=()):
    """None where fewer than two rows have the quantity."""
    quantity = quantity or main_quantity(run.report["rows"])
    rows = [r for r in run.report["rows"] if quantity in r["values"]]
    if len(rows) < 2:
        return None
    panels, raw = panels_of(rows, quantity, apart), few_enough(rows, quantity)
    shown = panels[:MOST_PANELS]
    name, best = bars_of(rows, quantity, "", telling(rows)).named[0]
    out = sum(bars.left_out for bars in shown)
    text = [f"From {'most' if quantity in LARGER_IS_BETTER else 'least'} down.", samples_sentence(rows, quantity)]
    text += [f"{out} more rows stand in the tables alone."] if out else []
    text += [f"{len(panels) - MOST_PANELS} more panels would follow; the tables hold them."] if len(panels) > MOST_PANELS else []
    title = f"{'Most' if quantity in LARGER_IS_BETTER else 'Least'} {unit(quantity)}: {name}, {estimate_text(best['values'][quantity])}"
    return Chart(f"bars-{quantity.replace('_', '-')}", title, " ".join(t for t in text if t), bars_spec(shown, quantity, raw))
