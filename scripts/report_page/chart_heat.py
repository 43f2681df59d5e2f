"""Schedulers × chunks, or × items: which pairs are fast, by colour and by number."""

from report_page.chart import Chart, estimate_text, tip_of
from report_page.factors import in_order, label, telling
from report_page.layout import combinations, split
from report_page.marks import significant, sized

CELL, ROW = 68, 24  # pixels
COLUMNS = ("chunk", "item")


def heat_names(rows):
    """(names of rows, name of columns); None where nothing is crossed."""
    for column in COLUMNS:
        if len({r["factors"].get(column, "-") for r in rows} - {"-"}) < 2:
            continue
        names = ["scheduler", "runtime"]
        if len(combinations(rows, names)) > 1:
            return names, column
    return None


def heat_group(number, title, rows, names, column, best):
    """(data, group mark): a cell is written in per cent of the best of the panel."""
    row_names = [label(dict(zip(names, key)), names) for key in combinations(rows, names)]
    column_names = in_order(r["factors"].get(column, "-") for r in rows)
    values = [
        {"r": label(r["factors"], names), "c": r["factors"].get(column, "-"), "v": significant(r["values"]["fps"]["value"] / best),
         "tip": [list(t) for t in tip_of(r, "fps", label(r["factors"], names), (column, "threads"))]}
        for r in rows
    ]  # fmt: skip
    width, height = CELL * len(column_names), ROW * len(row_names)
    at = {"x": {"scale": "x", "field": "c"}, "y": {"scale": "y", "field": "r"}}
    box = at | {
        "width": {"scale": "x", "band": 1},
        "height": {"scale": "y", "band": 1},
        "fill": {"scale": "heat", "field": "v"},
        "stroke": {"signal": "paper"},
        "tooltip": {"field": "tip"},
    }
    light = {"test": "luminance(scale('heat', datum.v)) > 0.35", "value": "#1b1f24"}
    text = {
        "x": {"scale": "x", "field": "c", "band": 0.5}, "y": {"scale": "y", "field": "r", "band": 0.5}, "align": {"value": "center"}, "baseline": {"value": "middle"},
        "text": {"signal": "format(datum.v, '.0%')"}, "fill": [light, {"value": "#ffffff"}],
    }  # fmt: skip
    axis = {"ticks": False, "domain": False, "grid": False}
    return {"name": f"points{number}", "values": values}, {
        "type": "group", "title": {"text": title, "limit": 420} if title else {"text": ""}, **sized(width, height),
        "scales": [
            {"name": "x", "type": "band", "domain": column_names, "range": [0, width]},
            {"name": "y", "type": "band", "domain": row_names, "range": [0, height]},
        ],
        "axes": [axis | {"orient": "bottom", "scale": "x", "title": column}, axis | {"orient": "left", "scale": "y", "labelPadding": 6}],
        "marks": [
            {"type": "rect", "name": f"point_marks{number}", "from": {"data": f"points{number}"}, "encode": {"update": box}},
            {"type": "text", "from": {"data": f"points{number}"}, "interactive": False, "aria": False, "encode": {"update": text}},
        ],
    }  # fmt: skip


def best_of(rows):
    return max(rows, key=lambda r: r["values"]["fps"]["value"])


def panels_of(rows, names, column):
    """(title, rows) of what else varies, of that only which crosses schedulers with columns."""
    others = [n for n in telling(rows) if n not in (*names, column)]
    groups = split(rows, others) if others else [("", rows)]
    return [(title, mine) for title, mine in groups if len({r["factors"].get(column) for r in mine}) > 1]


def heat_chart(run):
    """None where not at least two schedulers were run with two chunks or items."""
    rows = [r for r in run.report["rows"] if r["factors"].get("scheduler") not in (None, "serial") and "fps" in r["values"]]
    if not (found := heat_names(rows)) or not (panels := panels_of(rows, *found)[:6]):
        return None
    names, column = found
    data, groups = zip(
        *(heat_group(i, title, mine, names, column, best_of(mine)["values"]["fps"]["value"]) for i, (title, mine) in enumerate(panels))
    )
    lowest = min(v["v"] for d in data for v in d["values"])
    spec = {
        "padding": 8, "data": list(data), "marks": list(groups),
        "scales": [{"name": "heat", "type": "linear", "domain": [min(lowest, 0.9), 1], "range": "ramp"}],
        "legends": [{"fill": "heat", "title": "fps / best", "type": "gradient", "format": ".0%", "gradientLength": 120}],
        "layout": {"padding": {"row": 28, "column": 34}, "columns": 2, "bounds": "full", "align": "each"},
    }  # fmt: skip
    title, mine = panels[0]
    best = best_of(mine)
    head = f"{title}: " if title else ""
    said = f"{head}{label(best['factors'], names)} is fastest with {column} {best['factors'][column]}: fps {estimate_text(best['values']['fps'])}"
    return Chart(f"heat-{column}", said, "Each cell is its fps over that of the panel's best; differences below the noise floor mean nothing.", spec)
