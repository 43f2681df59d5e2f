"""Panels as one Vega specification: the page draws it so that it answers, the files draw the same."""

import dataclasses

from report_page.marks import FAINT, intervals, marks_of, significant, sized
from report_page.panel import dodge, x_domain, y_domain

DASHES = [[6, 3], [2, 2], [8, 2, 2, 2], [1, 4], [10, 4]]
SHOWN = "!indata('hidden', 'value', datum.s)"


def toggling():
    """Signals and data by which a click on the legend hides a series and shows it again."""
    click = {"events": "@legend_symbols:click, @legend_labels:click", "update": "{value: datum.value}", "force": True}
    signals = [{"name": "toggled", "value": None, "on": [click]}]
    return signals, [{"name": "hidden", "on": [{"trigger": "toggled", "toggle": "toggled"}]}]


def series_legend(title):
    """The legend whose entries can be clicked."""
    dim = [{"test": "indata('hidden', 'value', datum.value)", "value": 0.25}, {"value": 1}]
    part = {"interactive": True, "update": {"opacity": dim, "cursor": {"value": "pointer"}}}
    encode = {"symbols": part | {"name": "legend_symbols"}, "labels": part | {"name": "legend_labels"}}
    return {"fill": "colour", "shape": "marker", "title": title, "encode": encode}


def bounds_legend(names, title):
    look = {"symbolType": "stroke", "symbolSize": 250, "symbolStrokeColor": FAINT, "labelLimit": 300}
    return {"strokeDash": "dash", "title": title, "values": names} | look


def series_scales(series, bounds):
    scales = [
        {"name": "colour", "type": "ordinal", "domain": series, "range": "category"},
        {"name": "marker", "type": "ordinal", "domain": series, "range": "symbol"},
    ]
    return scales + ([{"name": "dash", "type": "ordinal", "domain": bounds, "range": DASHES}] if bounds else [])


def value_of(point, dx):
    row = {"s": point.series, "x": significant(point.x), "y": significant(point.y), "d": dx, "tip": [list(t) for t in point.tip]}
    if point.low is not None and point.high is not None:
        row |= {"low": significant(point.low), "high": significant(point.high)}
    return row


def panel_data(number, panel, series):
    """The data sets of a panel: estimates; samples, beside them; bounds of points."""
    moved, step = dodge(panel, series)
    aside = round(min(5.0, step / 2), 2)
    points = [value_of(p, moved[p.series]) for p in panel.points]
    samples = [
        {"s": p.series, "x": significant(p.x), "y": significant(v), "d": moved[p.series] + aside, "r": r} for p in panel.points for r, v in p.samples
    ]
    ticks = [value_of(p, moved[p.series]) for p in panel.ticks]
    shown = [{"type": "filter", "expr": SHOWN}]
    named = [(f"points{number}", points), (f"samples{number}", samples), (f"ticks{number}", ticks)]
    found = [{"name": name, "values": values, "transform": shown} for name, values in named if values or name.startswith("points")]
    return [*found, intervals(number)]


def axes_of(panel):
    x = {"orient": "bottom", "scale": "x", "title": panel.x_title, "grid": False, "labelOverlap": "greedy", "tickCount": 6}
    y = {"orient": "left", "scale": "y", "title": panel.y_title, "grid": True, "labelOverlap": "greedy", "tickCount": 5}
    if panel.x_values:
        x["values"] = panel.x_values
    # Powers of two and ten read better in full than as 1e+03; what is longer is shortened by k and M.
    x["format"] = panel.x_format or ("~s" if max(p.x for p in panel.points) >= 1e5 else ".6~g")
    return [x, y | {"format": panel.y_format or ".6~g"}]


def scales_of(panel):
    x = {"name": "x", "type": "log" if panel.log_x else "linear", "domain": x_domain(panel), "range": [0, panel.width], "zero": False}
    y = {"name": "y", "type": "log" if panel.log_y else "linear", "domain": y_domain(panel), "range": [panel.height, 0], "zero": False}
    if panel.log_x:
        x["base"] = 2 if panel.x_values and all(float(v).is_integer() for v in panel.x_values) else 10
    return [x, y | {"nice": not panel.log_y and not panel.y_domain}]


def panel_group(number, panel, series):
    """(data, group mark) of a panel."""
    data = panel_data(number, panel, series)
    marks = marks_of(number, panel, any(d["name"].startswith("samples") for d in data))
    return data, {"type": "group", **sized(panel.width, panel.height), "scales": scales_of(panel), "axes": axes_of(panel), "marks": marks}


def panels_spec(panels, series, legend_title, columns=3, legend=True, bounds_title="bounds"):
    """The specification of panels side by side, `columns` in a row, with one legend for all."""
    signals, data = toggling()
    groups = []
    head = max((len(panel.borders) for panel in panels), default=0)
    for number, panel in enumerate(panels):
        more, group = panel_group(number, dataclasses.replace(panel, head=head), series)
        data += more
        groups.append(group)
    bounds = list(dict.fromkeys(b.name for panel in panels for b in panel.bounds))
    legends = ([series_legend(legend_title)] if legend else []) + ([bounds_legend(bounds, bounds_title)] if bounds else [])
    layout = {"padding": {"row": 28, "column": 30}, "columns": columns, "bounds": "full", "align": "each"}
    return {
        "padding": 8, "signals": signals, "data": data, "scales": series_scales(series, bounds), "layout": layout, "legends": legends, "marks": groups,
    }  # fmt: skip
