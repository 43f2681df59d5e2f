"""Who worked when: a bar a chunk, a row a worker, from a trace of `raysweep render --trace`."""

from report_page.chart import Chart
from report_page.marks import significant

WIDTH, ROW = 860, 22
# A bar narrower than a pixel shows nothing; neighbours are drawn as one above this count of chunks.
MOST_BARS = 4000


def named_rows(events):
    """{tid: name} of the trace's rows."""
    return {e["tid"]: e["args"]["name"] for e in events if e["ph"] == "M" and e["name"] == "thread_name"}


def bars_of(events):
    """Bars in milliseconds, in the order of their workers; the frames' own row first."""
    names = named_rows(events)
    bars = []
    for event in sorted((e for e in events if e["ph"] == "X"), key=lambda e: (e["tid"], e["ts"])):
        start, end = event["ts"] / 1e3, (event["ts"] + event["dur"]) / 1e3
        tip = [[names.get(event["tid"], str(event["tid"])), ""], [event["name"], f"{end - start:.3g} ms"]]
        if "processor" in event["args"]:
            tip.append(["on processor", str(event["args"]["processor"])])
        bars.append(
            {
                "r": names.get(event["tid"], str(event["tid"])),
                "from": significant(start),
                "to": significant(end),
                "n": event["args"].get("items", 0),
                "tip": tip,
            }
        )
    return bars


def merged(bars):
    """Neighbours of a worker that are less than a pixel long become one bar, so that long traces stay light."""
    if len(bars) <= MOST_BARS:
        return bars
    pixel = max(bar["to"] for bar in bars) / WIDTH
    found = []
    for bar in bars:
        last = found[-1] if found else None
        if last and last["r"] == bar["r"] and bar["to"] - last["from"] < pixel:
            found[-1] = last | {"to": bar["to"], "n": last["n"] + bar["n"], "tip": [[bar["r"], ""], ["items", str(last["n"] + bar["n"])]]}
        else:
            found.append(dict(bar))
    return found


def timeline_spec(bars, rows):
    height = ROW * len(rows)
    at = {
        "x": {"scale": "x", "field": "from"}, "x2": {"scale": "x", "field": "to"}, "y": {"scale": "y", "field": "r"}, "height": {"scale": "y", "band": 1},
        "fill": [{"test": "datum.n == 0", "signal": "rail"}, {"scale": "colour", "value": "items"}], "stroke": {"signal": "paper"}, "strokeWidth": {"value": 0.4},
        "tooltip": {"field": "tip"},
    }  # fmt: skip
    return {
        "padding": 8, "width": WIDTH, "height": height, "data": [{"name": "points0", "values": bars}],
        "scales": [
            {"name": "x", "type": "linear", "domain": {"data": "points0", "field": "to"}, "zero": True, "range": "width"},
            {"name": "y", "type": "band", "domain": rows, "range": "height", "padding": 0.15},
            {"name": "colour", "type": "ordinal", "domain": ["items"], "range": "category"},
        ],
        "axes": [
            {"orient": "bottom", "scale": "x", "title": "milliseconds since the first frame was asked for", "grid": True},
            {"orient": "left", "scale": "y", "ticks": False, "domain": False, "labelPadding": 6},
        ],
        "marks": [{"type": "rect", "name": "point_marks0", "from": {"data": "points0"}, "encode": {"update": at, "hover": {"stroke": {"signal": "ink"}}}}],
    }  # fmt: skip


def timeline_chart(name, trace):
    """None where nothing was worked on."""
    events = trace["traceEvents"]
    bars = bars_of(events)
    workers = [bar for bar in bars if bar["n"]]
    if not workers:
        return None
    names = named_rows(events)
    rows = [names[tid] for tid in sorted(names) if any(bar["r"] == names[tid] for bar in bars)]
    busy = {r: sum(b["to"] - b["from"] for b in workers if b["r"] == r) for r in rows if any(b["r"] == r for b in workers)}
    least, most = min(busy, key=busy.get), max(busy, key=busy.get)
    told = f": {most} is in items for {busy[most]:.3g} ms, {least} for {busy[least]:.3g} ms" if len(busy) > 1 else ""
    title = f"{name}: {len(workers):,} chunks on {len(busy)} worker{'s' if len(busy) > 1 else ''}{told}"
    text = (
        f"A blue bar is a chunk, a gap is time in the scheduler or idle, grey is a frame. Cell: {trace.get('otherData', {}).get('cell', 'not told')}"
    )
    return Chart(f"timeline-{name}", title, text, timeline_spec(merged(bars), rows))
