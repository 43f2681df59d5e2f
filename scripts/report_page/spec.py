"""Panels as one Vega specification: the page draws it so that it answers, the files draw the same."""

from report_page.panel import dodge, x_domain, y_domain

DASHES = [[6, 3], [2, 2], [8, 2, 2, 2], [1, 4], [10, 4]]
SHOWN = "!indata('hidden', 'value', datum.s)"
INK, FAINT = {"signal": "ink"}, {"signal": "faint"}


def sized(width, height):
    """The size of a group, for its marks and for what its axes ask of it."""
    signals = [{"name": "width", "value": width}, {"name": "height", "value": height}]
    return {"encode": {"update": {"width": {"value": width}, "height": {"value": height}}}, "signals": signals}


def significant(value):
    """Six digits are more than is known and less than is written."""
    return None if value is None else float(f"{value:.6g}")


def toggling():
    """Signals and data by which a click on the legend hides a series and shows it again."""
    click = {"events": "@legend_symbols:click, @legend_labels:click", "update": "{value: datum.value}", "force": True}
    signals = [{"name": "toggled", "value": None, "on": [click]}]
    return signals, [{"name": "hidden", "on": [{"trigger": "toggled", "toggle": "toggled"}]}]


def series_legend(title, lines=True):
    """The legend whose entries can be clicked."""
    dim = [{"test": "indata('hidden', 'value', datum.value)", "value": 0.25}, {"value": 1}]
    part = {"interactive": True, "update": {"opacity": dim, "cursor": {"value": "pointer"}}}
    symbols = part | {"name": "legend_symbols"}
    return {
        "fill": "colour", "shape": "marker", "title": title, "encode": {"symbols": symbols, "labels": part | {"name": "legend_labels"}},
    }  # fmt: skip


def bounds_legend(names, title):
    return {"strokeDash": "dash", "title": title, "symbolType": "stroke", "symbolSize": 250, "symbolStrokeColor": FAINT, "labelLimit": 300, "values": names}


def series_scales(series, bounds):
    scales = [
        {"name": "colour", "type": "ordinal", "domain": series, "range": "category"},
        {"name": "marker", "type": "ordinal", "domain": series, "range": "symbol"},
    ]
    if bounds:
        scales.append({"name": "dash", "type": "ordinal", "domain": bounds, "range": DASHES})
    return scales


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
    return [{"name": name, "values": values, "transform": shown} for name, values in named if values or name.startswith("points")]


def x_at(field="x"):
    return {"scale": "x", "field": field, "offset": {"field": "d"}}


def point_marks(number, panel, has_samples):
    """Samples below, intervals and lines above them, points on top."""
    data, colour = f"points{number}", {"scale": "colour", "field": "s"}
    y = {"scale": "y", "field": "y"}
    marks = []
    if has_samples:
        tip = {"signal": "[[datum.s, ''], ['round', datum.r], ['value', format(datum.y, '.4~g')]]"}
        update = {"x": x_at(), "y": y, "fill": colour, "size": {"value": 9}, "opacity": {"value": 0.4}, "tooltip": tip}
        marks.append({"type": "symbol", "name": f"sample_marks{number}", "from": {"data": f"samples{number}"}, "clip": True, "aria": False, "encode": {"update": update}})  # fmt: skip
    if panel.lines:
        line = {"x": x_at(), "y": y, "stroke": colour, "strokeWidth": {"value": 1.4}, "interpolate": {"value": "step-after" if panel.steps else "linear"}}
        marks.append({
            "type": "group", "from": {"facet": {"name": f"series{number}", "data": data, "groupby": "s"}}, "clip": True, "interactive": False,
            "marks": [{"type": "line", "from": {"data": f"series{number}"}, "sort": {"field": "datum.x"}, "interactive": False, "encode": {"update": line}}],
            "encode": {"update": {"width": {"value": panel.width}, "height": {"value": panel.height}}},
        })  # fmt: skip
    if not panel.markers:
        return marks
    rule = {"x": x_at(), "y": {"scale": "y", "field": "low"}, "y2": {"scale": "y", "field": "high"}, "stroke": colour, "strokeWidth": {"value": 1.8}}
    rule["opacity"] = [{"test": "isValid(datum.low)", "value": 1}, {"value": 0}]
    marks.append({"type": "rule", "from": {"data": data}, "interactive": False, "aria": False, "encode": {"update": rule}})
    symbol = {
        "x": x_at(), "y": y, "shape": {"scale": "marker", "field": "s"}, "size": {"value": 48}, "fill": colour, "stroke": {"signal": "paper"},
        "strokeWidth": {"value": 0.8}, "tooltip": {"field": "tip"}, "description": {"signal": "datum.s + ' ' + format(datum.x, '~g') + ': ' + format(datum.y, '.4~g')"},
    }  # fmt: skip
    marks.append({"type": "symbol", "name": f"point_marks{number}", "from": {"data": data}, "encode": {"update": symbol, "hover": {"size": {"value": 110}}}})
    return marks


def tick_marks(number, panel):
    """Short bars, no longer than what lies between two points."""
    size = min(11.0, 0.8 * panel.width / max(1, len({p.x for p in panel.ticks})))
    update = {
        "x": x_at(), "y": {"scale": "y", "field": "y"}, "shape": {"value": "stroke"}, "size": {"value": round(size * size, 1)},
        "stroke": {"scale": "colour", "field": "s"}, "strokeWidth": {"value": 2}, "tooltip": {"field": "tip"},
    }  # fmt: skip
    return [{"type": "symbol", "from": {"data": f"ticks{number}"}, "clip": True, "encode": {"update": update}}]


def bound_marks(panel):
    """Lines of bounds, and borders with what begins there."""
    marks = []
    for number, border in enumerate(panel.borders):
        at = {"x": {"scale": "x", "value": border.x}}
        marks.append({"type": "rule", "aria": False, "encode": {"update": at | {"y": {"value": -3 - 11 * (len(panel.borders) - 1 - number)}, "y2": {"value": panel.height}, "stroke": FAINT, "strokeWidth": {"value": 1}}}})  # fmt: skip
        # Two names are longer than what is between two lines: each has a height of its own.
        above = -3 - 11 * (len(panel.borders) - 1 - number)
        text = at | {"y": {"value": above}, "dx": {"value": -1}, "text": {"value": border.text + " →"}, "align": {"value": "left"}, "fontSize": {"value": 9}, "fill": {"signal": "ink"}}  # fmt: skip
        marks.append({"type": "text", "encode": {"update": text}})
    for bound in panel.bounds:
        values = [{"x": significant(x), "y": significant(y)} for x, y in bound.points]
        line = {"x": {"scale": "x", "field": "x"}, "y": {"scale": "y", "field": "y"}, "stroke": FAINT, "strokeWidth": {"value": 1.3}, "strokeDash": {"scale": "dash", "value": bound.name}}  # fmt: skip
        marks.append({
            "type": "group", "clip": True, "interactive": False, "data": [{"name": "bound", "values": values}],
            "encode": {"update": {"width": {"value": panel.width}, "height": {"value": panel.height}}},
            "marks": [{"type": "line", "from": {"data": "bound"}, "encode": {"update": line}}],
        })  # fmt: skip
    return marks


def panel_title(panel):
    """A mark, for Vega's own titles stand higher the more their axes need."""
    at = {"x": {"value": 0}, "y": {"value": -12 - 12 * len(panel.borders)}, "limit": {"value": panel.width + 40}}
    text = {"text": {"value": panel.title}, "fontWeight": {"value": "bold"}, "fontSize": {"value": 12}, "fill": INK, "baseline": {"value": "alphabetic"}}
    return {"type": "text", "name": "panel_title", "interactive": False, "encode": {"update": at | text}}


def axes_of(panel):
    x = {"orient": "bottom", "scale": "x", "title": panel.x_title, "grid": False, "labelOverlap": "greedy", "tickCount": 6}
    y = {"orient": "left", "scale": "y", "title": panel.y_title, "grid": True, "tickCount": 5, "labelOverlap": "greedy", "format": panel.y_format or ".6~g"}
    if panel.x_values:
        x["values"] = panel.x_values
    x["format"] = panel.x_format or ("~s" if max(p.x for p in panel.points) >= 1e5 else ".6~g")
    return [x, y]


def panel_group(number, panel, series):
    """(data, group mark) of a panel."""
    data = panel_data(number, panel, series)
    marks = bound_marks(panel) + point_marks(number, panel, any(d["name"].startswith("samples") for d in data))
    marks += tick_marks(number, panel) if panel.ticks else []
    scales = [
        {"name": "x", "type": "log" if panel.log_x else "linear", "domain": x_domain(panel), "range": [0, panel.width], "zero": False},
        {"name": "y", "type": "log" if panel.log_y else "linear", "domain": y_domain(panel), "range": [panel.height, 0], "zero": False, "nice": not panel.log_y and not panel.y_domain},
    ]  # fmt: skip
    if panel.log_x:
        scales[0] |= {"base": 2 if panel.x_values and all(float(v).is_integer() for v in panel.x_values) else 10}
    group = {"type": "group", **sized(panel.width, panel.height), "scales": scales, "axes": axes_of(panel), "marks": marks}
    if panel.title:
        group["marks"].append(panel_title(panel))
    return data, group


def panels_spec(panels, series, legend_title, columns=3, legend=True, bounds_title="bounds"):
    """The specification of panels side by side, `columns` in a row, with one legend for all."""
    signals, data = toggling()
    groups = []
    for number, panel in enumerate(panels):
        more, group = panel_group(number, panel, series)
        data += more
        groups.append(group)
    bounds = list(dict.fromkeys(b.name for panel in panels for b in panel.bounds))
    legends = ([series_legend(legend_title)] if legend else []) + ([bounds_legend(bounds, bounds_title)] if bounds else [])
    return {
        "padding": 8, "signals": signals, "data": data, "scales": series_scales(series, bounds),
        "layout": {"padding": {"row": 28, "column": 30}, "columns": columns, "bounds": "full", "align": "each"},
        "legends": legends, "marks": groups,
    }  # fmt: skip
