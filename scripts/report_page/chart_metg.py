"""Efficiency against the size of a task: the smallest that keeps a share of all processors busy is METG (Task Bench)."""

from report_page.chart import Chart
from report_page.layout import layout_of
from report_page.panel import Bound, Panel, Point
from report_page.spec import panels_spec
from study_charts.numbers import short

LEVELS = {"50 %": 0.5, "95 %": 0.95}
NAMES = ("scheduler", "runtime", "wait", "threads")


def rows_of(lines):
    return [{"factors": {n: line[n] or "-" for n in NAMES}, "line": line} for line in lines]


def point_of(row, series):
    line = row["line"]
    size, efficiency = float(line["task_ns"]), float(line["efficiency"])
    return Point(
        series,
        size,
        efficiency,
        tip=[[series, ""], ["task", f"{short(size)} ns"], ["efficiency", f"{efficiency:.1%}"], ["a run", f"{short(float(line['run_ns']) / 1e3)} µs"]],
    )


def metg_chart(run):
    """None without task_sizes.csv."""
    every = rows_of(run.task_sizes)
    most = max((int(r["factors"]["threads"]) for r in every), default=0)
    # Fewer threads than processors leave some of the machine out; the table has them.
    rows = [r for r in every if int(r["factors"]["threads"]) == most and r["line"]["scheduler"] != "serial"]
    if not rows:
        return None
    size = [float(r["line"]["task_ns"]) for r in rows]
    bounds = [Bound(name, [(min(size), level), (max(size), level)]) for name, level in LEVELS.items()]
    wide = [min(size) / 1.5, max(size) * 1.5]
    layout = layout_of(rows, apart=("task_ns",))
    panels = []
    for title, mine in layout.panels:
        points = [point_of(r, layout.series_of(r)) for r in mine]
        panels.append(
            Panel(
                title, "ns a task", "efficiency", points, bounds, log_x=True, y_format="~%", y_domain=[0, 1.1], x_domain=wide, width=210, height=140
            )
        )
    title = f"On {most} threads, {best_sentence(run.overheads, most)}"
    text = "Each point is a run of as many equal tasks, one a chunk. METG(50 %) and METG(95 %) are where a line crosses the dashed levels for good; no interval: sizes are single runs."
    return Chart(
        "metg", title, text, panels_spec(panels, layout.series, layout.legend_title(), 4, legend=len(layout.series) > 1, bounds_title="levels")
    )


def best_sentence(lines, most):
    """Who has the smallest METG(95 %) by overhead.csv, among those of which it could be told."""
    told = [
        line for line in lines if line["scheduler"] != "serial" and int(line["threads"]) == most and line["metg95_kind"] in ("bracketed", "at_most")
    ]
    if not told:
        return "no scheduler's METG(95 %) was found"
    best = min(told, key=lambda line: float(line["metg95_ns"]))
    name = ", ".join(best[n] for n in ("scheduler", "runtime") if best[n])
    at_most = "at most " if best["metg95_kind"] == "at_most" else ""
    return f"the smallest METG(95 %) is {at_most}{short(float(best['metg95_ns']))} ns, by {name}"
