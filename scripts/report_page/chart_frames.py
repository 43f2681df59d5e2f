"""How long frames took: every frame of every launch, as the share that was done by then; of many cells, a row of dots each."""

from report_page.chart import Chart
from report_page.chart_bars import MOST_ROWS, bars_spec, panels_of
from report_page.factors import label, telling
from report_page.layout import layout_of
from report_page.panel import Panel, Point, spread
from report_page.spec import panels_spec
from study_charts.numbers import short

# Of so many points the steps are no wider than a pixel; of more frames every n-th is drawn, the last always.
MOST_POINTS = 120
# With more panels than these nobody sees which of them differ.
MOST_PANELS = 8
MOST_COLUMNS = 3  # of thread counts with a panel each
MOST_DOTS = 60  # a cell
QUANTITY = "milliseconds a frame"


def thinned(ordered, most=MOST_POINTS):
    """Every n-th and the last, so that there are hardly more than `most`."""
    if len(ordered) <= most:
        return ordered
    step = -(-len(ordered) // most)
    return ordered[::step] + ([] if (len(ordered) - 1) % step == 0 else ordered[-1:])


def steps_of(series, seconds):
    """The empirical distribution, in milliseconds."""
    ordered, count = sorted(seconds), len(seconds)
    return thinned([Point(series, value * 1e3, (i + 1) / count, tip=[[series, ""]]) for i, value in enumerate(ordered)])


def steps_spec(layout, of):
    panels = []
    for title, mine in layout.panels[:MOST_PANELS]:
        points = [p for r in mine for p in steps_of(layout.series_of(r), of[r["cell"]])]
        wide = spread([p.x for p in points]) > 8
        panels.append(
            Panel(
                title,
                QUANTITY,
                "share of frames done",
                points,
                y_format="~%",
                y_domain=[0, 1],
                steps=True,
                markers=False,
                from_zero=False,
                log_x=wide,
                width=250,
                height=170,
            )
        )
    return panels_spec(panels, layout.series, layout.legend_title(), min(4, len(panels)), legend=len(layout.series) > 1)


def quantiles(run):
    """{factors that tables/frames.csv has: its line}."""
    lines = run.table("frames")
    names = [n for n in (lines[0] if lines else {}) if any(n in row["factors"] for row in run.report["rows"])]
    return names, {tuple(line[n] for n in names): line for line in lines if line.get("p50")}


def dots_spec(run, rows, of):
    """A row a cell: its frames, their median, and from the 5th to the 95th of a hundred, where tables/frames.csv has them; else None."""
    names, lines = quantiles(run)
    found = []
    for row in rows:
        line = lines.get(tuple(row["factors"].get(n) for n in names))
        if line:
            low, middle, high = (float(line[q]) * 1e3 if line.get(q) else None for q in ("p5", "p50", "p95"))
            frames = [[number, seconds * 1e3] for number, seconds in enumerate(sorted(of[row["cell"]]), 1)]
            estimate = {"value": middle, "low": low, "high": high, "count": len(frames)}
            found.append(row | {"values": {QUANTITY: estimate}, "samples": {QUANTITY: thinned(frames, MOST_DOTS)}})
    if not found:
        return None
    few = len({row["factors"].get("threads") for row in found}) <= MOST_COLUMNS
    panels = panels_of(found, QUANTITY, ("threads",) if few else ())[:MOST_PANELS]
    return bars_spec(panels, QUANTITY, raw=True, sample="frame, from the quickest")


def frames_chart(run):
    """None where no records of frames are beside the report."""
    of = {}
    for cell, seconds in run.frames:
        of.setdefault(cell, []).append(seconds)
    rows = [r for r in run.report["rows"] if len(of.get(r["cell"], [])) > 1]
    if not rows:
        return None
    # A panel holds frames that are meant to be alike: of one picture by as many threads.
    layout = layout_of(rows, outer=("threads",))
    widest = max(rows, key=lambda r: spread(of[r["cell"]]))
    where = label(widest["factors"], telling(rows)) or "this run"
    title = f"The slowest frame of a cell takes at most {short(spread(of[widest['cell']]))} times the quickest ({where})"
    text = f"{sum(len(of[r['cell']]) for r in rows):,} frames of all valid launches, warm-up frames aside. "
    if len(layout.panels) + layout.left_out > MOST_PANELS and (spec := dots_spec(run, rows, of)):
        text += f"Blue: the median, and from the 5th to the 95th of a hundred frames; the quickest {MOST_ROWS} cells of each panel."
        text += f" Of more than {MOST_DOTS} frames every n-th by length is a dot, and the longest."
    else:
        spec = steps_spec(layout, of)
        text += "A steep line is a steady picture; a tail to the right is frames that were held up."
        text += f" The first {MOST_PANELS} panels; records.jsonl has all." if len(layout.panels) > MOST_PANELS else ""
    return Chart("frames", title, text.strip(), spec)
