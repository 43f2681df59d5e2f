"""Which charts a run has: by what its report, its tables and its folder hold."""

from report_page.chart_bars import bars_chart
from report_page.chart_frames import frames_chart
from report_page.chart_heat import heat_chart
from report_page.chart_metg import metg_chart
from report_page.chart_published import published_chart
from report_page.chart_speed_error import pixels_chart, speed_error_chart, wrong_of
from report_page.chart_split import split_chart
from report_page.chart_sweep import sweep_charts
from report_page.chart_threads import threads_chart
from report_page.chart_timeline import timeline_chart
from report_page.layout import longest_line


def picture_charts(run):
    threads = threads_chart(run)
    sweeps = sweep_charts(run)
    yield threads
    yield from sweeps
    if not threads and not sweeps:
        # Where threads are an axis, but of too many lines, they are panels.
        yield bars_chart(run, "fps", apart=("threads",) if longest_line(run.report["rows"], "threads") > 1 else ())
    yield heat_chart(run)
    yield split_chart(run)
    yield frames_chart(run)


def other_charts(run):
    sweeps = sweep_charts(run, wrong_of(run) if run.kind == "pixels" else None)
    yield from sweeps
    yield pixels_chart(run) if run.kind == "pixels" else None
    if not sweeps:
        yield bars_chart(run)


def charts_of(run):
    """All charts of a run, in the order of its section: printed numbers first, for they are what it was made for."""
    found = [published_chart(run)]
    found += picture_charts(run) if run.kind == "picture" else other_charts(run)
    found += [timeline_chart(name, trace) for name, trace in run.traces]
    found.append(metg_chart(run))
    return [chart for chart in found if chart is not None]


def charts_of_pairs(runs):
    """{index of a kernel run: charts} of what two runs tell together: its speed against the errors of the accuracy runs."""
    found = {}
    for index, run in enumerate(runs):
        if run.kind == "kernel":
            charts = [speed_error_chart(run, other) for other in runs if other.kind == "accuracy"]
            found[index] = [chart for chart in charts if chart is not None][:1]
    return found
