"""Speed against accuracy: kernels' ns a test against the errors of accuracy runs, or pictures' ns a ray against wrong pixels."""

from report_page.chart import Chart, estimate_text
from report_page.chart_sweep import sweep_factors
from report_page.factors import in_order, label, telling, unit
from report_page.layout import layout_of, split
from report_page.panel import Panel, Point, spread
from report_page.spec import panels_spec
from study_charts.numbers import short

ERRORS = ("t_error_p99", "t_error_p50", "uv_error_p99")
WRONG = ("rmse", "flip_mean", "wrong_pixels")
MOST_PANELS = 8


def value(row, name):
    return row["values"][name]["value"] if has(row, name) else None


def has(row, name):
    return name in row["values"]


def subject(row):
    """What both an accuracy and a kernel run know of a row: which formula it is."""
    factors = row["factors"]
    return factors.get("method"), factors.get("change", "base"), factors.get("precision")


def pairs_of(kernel_rows, accuracy_rows, error):
    """(time row, error row) of the same formula; the first of several times is of the first workload in the report."""
    times = {}
    for row in kernel_rows:
        if has(row, "nanoseconds") and row["factors"].get("rays_at_once", "1") == row["factors"].get("triangles_at_once", "1") == "1":
            times.setdefault(subject(row), row)
    return [(times[subject(r)], r) for r in accuracy_rows if has(r, error) and subject(r) in times]


def hardest(rows):
    """A case's rows at the last difficulty that the report has of it."""
    last = in_order(r["factors"].get("difficulty", "-") for r in rows)[-1]
    return [r for r in rows if r["factors"].get("difficulty", "-") == last]


def pair_point(time, wrong, series, error):
    ns = time["values"]["nanoseconds"]
    tip = [[", ".join(v for v in subject(time) if v), ""], ["ns a test", estimate_text(ns)], [unit(error), short(value(wrong, error), 4)]]
    return Point(series, ns["value"], value(wrong, error), tip=tip)


def cheapest_right(points):
    """The quickest of the points with the least error."""
    return min(points, key=lambda p: (p.y, p.x))


def speed_error_chart(kernel_run, accuracy_run):
    """A panel a case at its hardest; None where no formula is in both runs."""
    error = next((e for e in ERRORS if any(has(r, e) for r in accuracy_run.report["rows"])), None)
    pairs = pairs_of(kernel_run.report["rows"], accuracy_run.report["rows"], error) if error else []
    base = [(t, w) for t, w in pairs if subject(w)[1] == "base"]
    panels = []
    for title, mine in split([w for _, w in base], ["case", "precision"]):
        of = {id(w): t for t, w in base}
        points = [pair_point(of[id(w)], w, w["factors"]["method"], error) for w in hardest(mine)]
        points = [p for p in points if p.y > 0]
        if len(points) > 2:
            panels.append(scatter(title, points, "ns a test", unit(error)))
    if not panels:
        return None
    panels.sort(key=lambda p: -spread([q.y for q in p.points]))
    shown, series = panels[:MOST_PANELS], in_order(p.series for panel in panels[:MOST_PANELS] for p in panel.points)
    best = cheapest_right(shown[0].points)
    title = f"{shown[0].title}: the least error has {best.series}, {short(best.x)} ns a test"
    text = "Each case at the hardest difficulty of the accuracy run; to the left is quick, below is right. "
    text += f"The {len(shown)} of {len(panels)} cases and precisions whose errors differ most." if len(shown) < len(panels) else ""
    return Chart("speed-error", title, text.strip(), panels_spec(shown, series, "method", 4))


def scatter(title, points, x_title, y_title, lines=False):
    xs, ys = ([p.x for p in points], [p.y for p in points])
    return Panel(
        title,
        x_title,
        y_title,
        points,
        lines=lines,
        log_x=spread(xs) > 8,
        log_y=spread(ys) > 12,
        from_zero=spread(ys) > 3,
        width=210,
        height=170,
        dodged=False,
    )


def wrong_of(run):
    """What is wrong in pictures of the run, by the first measure of which any is; None where none is."""
    return next((w for w in WRONG if any((value(r, w) or 0) > 0 for r in run.report["rows"])), None)


def pixels_chart(run):
    """ns a ray against what is wrong in pictures; None where a run has not both."""
    wrong = wrong_of(run)
    rows = [r for r in run.report["rows"] if wrong and has(r, "nanoseconds") and has(r, wrong)]
    if not rows:
        return None
    names, joined = telling(rows), sweep_factors(rows)[:1]
    layout = layout_of(rows, apart=joined)
    panels = []
    for title, mine in layout.panels:
        points = [
            Point(layout.series_of(r), value(r, "nanoseconds"), value(r, wrong), tip=[[label(r["factors"], names), ""], ["ns a ray", estimate_text(r["values"]["nanoseconds"])], [unit(wrong), estimate_text(r["values"][wrong])]])
            for r in mine
        ]  # fmt: skip
        panels.append(scatter(title, points, "ns a ray", unit(wrong), lines=bool(joined)))
    worst = max(rows, key=lambda r: value(r, wrong))
    title = f"Most wrong: {label(worst['factors'], names)}, {unit(wrong)} {estimate_text(worst['values'][wrong])}"
    text = f"To the left is quick, below is right. {layout.sentence()}" + (f" Lines join {joined[0].replace('_', ' ')}." if joined else "")
    return Chart(
        "speed-pixels",
        title,
        text.strip(),
        panels_spec(panels, layout.series, layout.legend_title(), min(4, len(panels)), legend=len(layout.series) > 1),
    )
