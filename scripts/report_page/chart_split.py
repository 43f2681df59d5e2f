"""Where the threads' time went: inside items, in the scheduler, idle; and how much longer the items took than alone."""

from report_page.chart import Chart
from report_page.factors import label, telling
from report_page.marks import intervals, significant, sized

PARTS = {"busy": "inside items", "in_scheduler": "in the scheduler", "idle": "idle"}
ROW, WIDTH, MOST_ROWS = 17, 420, 60


def lines_of(run):
    """(name, shares, inflation) a cell of tables/schedule.csv, as far as it has shares."""
    lines = [line for line in run.table("schedule") if all(line.get(part) for part in PARTS)]
    # What is measured of a cell is not what it is told by.
    factors = {name for row in run.report["rows"] for name in row["factors"]}
    rows = [{"factors": {k: v for k, v in line.items() if k in factors}} for line in lines]
    names = telling(rows)
    return [(label(row["factors"], names) or "this run", line) for row, line in zip(rows, lines)]


def values_of(lines):
    """Stacked shares: from where to where each part goes."""
    values = []
    for name, line in lines:
        start = 0.0
        for part, title in PARTS.items():
            share = float(line[part])
            values.append(
                {"r": name, "s": title, "from": significant(start), "to": significant(start + share), "tip": [[name, ""], [title, f"{share:.1%}"]]}
            )
            start += share
    return values


def inflation_values(lines):
    found = []
    for name, line in lines:
        if line.get("inflation"):
            ends = [float(line[f"inflation_{end}"]) if line.get(f"inflation_{end}") else None for end in ("low", "high")]
            said = f"{float(line['inflation']):.1%}" + ("" if None in ends else f" [{ends[0]:.1%}, {ends[1]:.1%}]")
            found.append(
                {
                    "r": name,
                    "x": significant(float(line["inflation"])),
                    "low": ends[0],
                    "high": ends[1],
                    "tip": [[name, ""], ["work inflation", said]],
                }
            )
    return found


def group(title, x_title, x_scale, height, domain, marks, labels):
    axes = [{"orient": "bottom", "scale": "x", "title": x_title, "grid": True, "format": "%", "tickCount": 5}]
    axes.append({"orient": "left", "scale": "y", "ticks": False, "domain": False, "labelPadding": 6, "labels": labels, "grid": not labels})
    width = x_scale["range"][1]
    return {
        "type": "group", "title": {"text": title, "limit": width + 100}, **sized(width, height),
        "scales": [x_scale, {"name": "y", "type": "band", "domain": domain, "range": [0, height], "padding": 0.15}], "axes": axes, "marks": marks,
    }  # fmt: skip


def split_spec(lines):
    names = [name for name, _ in lines]
    height = ROW * len(names)
    values, inflation = values_of(lines), inflation_values(lines)
    bar = {
        "x": {"scale": "x", "field": "from"}, "x2": {"scale": "x", "field": "to"}, "y": {"scale": "y", "field": "r"}, "height": {"scale": "y", "band": 1},
        "fill": {"scale": "colour", "field": "s"}, "tooltip": {"field": "tip"},
    }  # fmt: skip
    at = {"y": {"scale": "y", "field": "r", "band": 0.5}}
    rule = at | {
        "x": {"scale": "x", "field": "low"},
        "x2": {"scale": "x", "field": "high"},
        "stroke": {"signal": "ink"},
        "strokeWidth": {"value": 2},
    }
    point = at | {"x": {"scale": "x", "field": "x"}, "fill": {"signal": "ink"}, "size": {"value": 45}, "tooltip": {"field": "tip"}}
    shares = group("all threads' time", "share of all threads' time", {"name": "x", "type": "linear", "domain": [0, 1], "range": [0, WIDTH]}, height, names,
                   [{"type": "rect", "name": "point_marks0", "from": {"data": "points0"}, "encode": {"update": bar}}], True)  # fmt: skip
    groups = [shares]
    if inflation:
        ends = [v for row in inflation for v in (row["x"], row["low"], row["high"]) if v is not None] + [0]
        scale = {"name": "x", "type": "linear", "domain": [min(ends), max(ends) * 1.05 or 0.01], "range": [0, 220], "nice": True}
        groups.append(group("work inflation", "busy time over that of one thread − 1", scale, height, names, [
            {"type": "rule", "from": {"data": "intervals1"}, "aria": False, "encode": {"update": rule}},
            {"type": "symbol", "name": "point_marks1", "from": {"data": "points1"}, "encode": {"update": point}},
        ], False))  # fmt: skip
    return {
        "padding": 8, "data": [{"name": "points0", "values": values}, {"name": "points1", "values": inflation}, intervals(1)],
        "scales": [{"name": "colour", "type": "ordinal", "domain": list(PARTS.values()), "range": [{"signal": "first"}, {"signal": "second"}, {"signal": "rail"}]}],
        "legends": [{"fill": "colour", "symbolType": "square", "title": "where time went"}],
        "layout": {"padding": {"column": 24}, "columns": 2, "bounds": "full", "align": "each"}, "marks": groups,
    }  # fmt: skip


def split_chart(run):
    """None where tables/schedule.csv has no shares."""
    every = lines_of(run)
    if not every:
        return None
    lines = every[:MOST_ROWS]
    name, worst = max(every, key=lambda line: 1 - float(line[1]["busy"]))
    title = f"{name} spends the least of its time inside items: {float(worst['busy']):.1%} ({float(worst['idle']):.1%} idle, {float(worst['in_scheduler']):.1%} in the scheduler)"
    text = "Medians over launches. Work inflation: how much longer all items took together than on one thread; threads that share a processor wait inside items too."
    text += f" {len(every) - MOST_ROWS} more rows stand in tables/schedule.csv." if len(every) > MOST_ROWS else ""
    return Chart("overhead", title, text, split_spec(lines))
