"""The marks of a panel: samples, lines, intervals, points, bounds and borders."""

from report_page.panel import Panel

INK, FAINT = {"signal": "ink"}, {"signal": "faint"}
COLOUR = {"scale": "colour", "field": "s"}
HIGH_ABOVE = 11  # pixels that the name of a border needs


def significant(value):
    """Six digits are more than is known and less than is written."""
    return None if value is None else float(f"{value:.6g}")


def constant(value):
    return {"value": value}


def mark(kind, update, data=None, **more):
    """A mark of Vega that draws `update` for each row of `data`, or once."""
    found = {"type": kind, "encode": {"update": update}} | more
    return found | {"from": {"data": data}} if data else found


def sized(width, height):
    """The size of a group, for its marks and for what its axes ask of it."""
    signals = [{"name": "width", "value": width}, {"name": "height", "value": height}]
    return {"encode": {"update": {"width": constant(width), "height": constant(height)}}, "signals": signals}


def x_at(field="x"):
    """A little beside the true x, by what `dodge` found."""
    return {"scale": "x", "field": field, "offset": {"field": "d"}}


def y_at(field="y"):
    return {"scale": "y", "field": field}


def sample_mark(number):
    tip = {"signal": "[[datum.s, ''], ['round', datum.r], ['value', format(datum.y, '.4~g')]]"}
    update = {"x": x_at(), "y": y_at(), "fill": COLOUR, "size": constant(9), "opacity": constant(0.4), "tooltip": tip}
    return mark("symbol", update, f"samples{number}", name=f"sample_marks{number}", clip=True, aria=False)


def line_mark(number, panel: Panel):
    """A line a series, from left to right."""
    name = f"series{number}"
    way = "step-after" if panel.steps else "linear"
    update = {"x": x_at(), "y": y_at(), "stroke": COLOUR, "strokeWidth": constant(1.4), "interpolate": constant(way)}
    lines = [mark("line", update, name, sort={"field": "datum.x"}, interactive=False)]
    facet = {"facet": {"name": name, "data": f"points{number}", "groupby": "s"}}
    return {"type": "group", "from": facet, "clip": True, "interactive": False, "marks": lines, "encode": sized(panel.width, panel.height)["encode"]}


def intervals(number):
    """The data set of those points of a panel that have an interval."""
    both = {"type": "filter", "expr": "isValid(datum.low) && isValid(datum.high)"}
    return {"name": f"intervals{number}", "source": f"points{number}", "transform": [both]}


def interval_mark(number):
    update = {"x": x_at(), "y": y_at("low"), "y2": y_at("high"), "stroke": COLOUR, "strokeWidth": constant(1.8)}
    return mark("rule", update, f"intervals{number}", interactive=False, aria=False)


def point_mark(number):
    update = {"x": x_at(), "y": y_at(), "shape": {"scale": "marker", "field": "s"}, "size": constant(48), "fill": COLOUR}
    update |= {"stroke": {"signal": "paper"}, "strokeWidth": constant(0.8), "tooltip": {"field": "tip"}}
    update["description"] = {"signal": "datum.s + ' ' + format(datum.x, '~g') + ': ' + format(datum.y, '.4~g')"}
    found = mark("symbol", update, f"points{number}", name=f"point_marks{number}")
    found["encode"]["hover"] = {"size": constant(110)}
    return found


def tick_mark(number, panel):
    """Short level bars, no longer than what lies between two points."""
    length = min(11.0, 0.8 * panel.width / max(1, len({p.x for p in panel.ticks})))
    update = {"x": x_at(), "y": y_at(), "shape": constant("stroke"), "size": constant(round(length**2, 1)), "stroke": COLOUR}
    return mark("symbol", update | {"strokeWidth": constant(2), "tooltip": {"field": "tip"}}, f"ticks{number}", clip=True)


def border_marks(panel):
    """Vertical lines with the names of what begins there; two names may be longer than what lies between, so each has its own height."""
    found = []
    for number, border in enumerate(panel.borders):
        above = -3 - HIGH_ABOVE * (len(panel.borders) - 1 - number)
        at = {"x": {"scale": "x", "value": border.x}, "y": constant(above)}
        line = {"y2": constant(panel.height), "stroke": FAINT, "strokeWidth": constant(1)}
        text = {"dx": constant(-1), "text": constant(border.text + " →"), "align": constant("left"), "fontSize": constant(9), "fill": INK}
        found += [mark("rule", at | line, aria=False), mark("text", at | text)]
    return found


def bound_marks(panel):
    """Dashed lines, cut off where the panel ends."""
    found = []
    for bound in panel.bounds:
        values = [{"x": significant(x), "y": significant(y)} for x, y in bound.points]
        update = {"x": {"scale": "x", "field": "x"}, "y": y_at(), "stroke": FAINT, "strokeWidth": constant(1.3)}
        line = mark("line", update | {"strokeDash": {"scale": "dash", "value": bound.name}}, "bound")
        group = {"type": "group", "clip": True, "interactive": False, "data": [{"name": "bound", "values": values}], "marks": [line]}
        found.append(group | {"encode": sized(panel.width, panel.height)["encode"]})
    return found


def title_mark(panel):
    """A mark, for Vega's own titles stand higher the more their axes need."""
    above = -12 - (HIGH_ABOVE + 1) * panel.head
    update = {"x": constant(0), "y": constant(above), "limit": constant(panel.width + 70), "text": constant(panel.title), "fill": INK}
    update |= {"fontWeight": constant("bold"), "fontSize": constant(12), "baseline": constant("alphabetic")}
    return mark("text", update, name="panel_title", interactive=False)


def marks_of(number, panel, has_samples):
    """Bounds below, then samples, lines, intervals, and points on top."""
    found = border_marks(panel) + bound_marks(panel)
    found += [sample_mark(number)] if has_samples else []
    found += [line_mark(number, panel)] if panel.lines else []
    found += [interval_mark(number), point_mark(number)] if panel.markers else []
    found += [tick_mark(number, panel)] if panel.ticks else []
    return found + ([title_mark(panel)] if panel.title else [])
