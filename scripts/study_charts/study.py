"""From runs to the files of the report: what there is of each kind is drawn, what is missing is said."""

import dataclasses

from study_charts.accuracy import Accuracy
from study_charts.answers import watertight_methods
from study_charts.chart_combined import combined_chart
from study_charts.chart_cost import cost_charts
from study_charts.chart_difficulty import difficulty_charts
from study_charts.chart_failures import failure_charts
from study_charts.chart_map import map_charts
from study_charts.chart_mesh import mesh_chart
from study_charts.chart_pixels import pixel_charts
from study_charts.chart_price import price_chart
from study_charts.chart_sampling import sampling_chart
from study_charts.chart_speed import bar_chart, rate_chart
from study_charts.inline import Inline
from study_charts.kernels import Kernels
from study_charts.report import page
from study_charts.runs import SCHEMAS, in_order
from study_charts.style import Looks, save, start

NEEDED_BY = {
    "accuracy": "what fails, and where",
    "kernel": "time, the fronts of time against failures, and the price of each fix",
    "pixels": "wrong pixels against ns a ray, and errors of few samples at edges",
    "atlas": "maps over two difficulties with the triangles of scenes",
}


@dataclasses.dataclass(frozen=True)
class Study:
    """All records of one study; what was not run is None, or empty."""

    runs: list
    accuracy: Accuracy | None
    kernels: Kernels | None
    pixels: list
    atlas: list


def study_of(runs):
    """The records of all runs together, kind by kind."""
    of = {kind: [record for run in runs if run.kind == kind for record in run.records] for kind in SCHEMAS}
    kernels = Kernels(of["kernel"]) if any(r["valid"] for r in of["kernel"]) else None
    return Study(runs, Accuracy(of["accuracy"]) if of["accuracy"] else None, kernels, of["pixels"], of["atlas"])


def missing_of(study):
    """A sentence for each thing that is not there."""
    given = {run.kind for run in study.runs}
    missing = [f"No run of the kind “{kind}” was given: {what}." for kind, what in NEEDED_BY.items() if kind not in given]
    for kind, what in (("kernel", "kernels"), ("pixels", "pictures")):
        invalid = sum(not r["valid"] for run in study.runs if run.kind == kind for r in run.records)
        if invalid:
            missing.append(f"{invalid:,} rounds of {what} are not valid by their own records and are left out.")
    return missing


def charts_of(study):
    """All charts that the records allow, in the order of the report; None among them for those without anything to show."""
    accuracy, kernels = study.accuracy, study.kernels
    lists = [part.methods for part in (accuracy, kernels) if part]
    looks = Looks(in_order(m for names in lists + [[r["method"] for r in study.pixels]] for m in names))
    if accuracy and kernels:
        yield from cost_charts(accuracy, kernels, looks)
    if accuracy:
        yield mesh_chart(accuracy)
        yield from failure_charts(accuracy)
        yield from difficulty_charts(accuracy, looks)
    yield from map_charts(study.atlas)
    if kernels:
        safe = {m for p in accuracy.precisions for m in watertight_methods(accuracy, p)} if accuracy else set()
        yield price_chart(kernels, looks, safe)
        yield combined_chart(kernels, looks)
        yield rate_chart(kernels, looks)
        yield bar_chart(kernels, accuracy, looks)
    yield from pixel_charts(study.pixels, looks)
    yield sampling_chart(study.pixels)


def write_study(runs, out):
    """Writes OUT/charts/*.svg, *.png and OUT/report.html, the same for the same runs. Returns (charts, what is missing)."""
    start()
    study = study_of(runs)
    folder = out / "charts"
    folder.mkdir(parents=True, exist_ok=True)
    inline, shown = Inline(), []
    for chart in charts_of(study):
        if chart is not None:
            shown.append((chart, inline.picture(save(chart, folder), chart.name)))
    missing = missing_of(study)
    text = page(runs, missing, shown, inline, study.accuracy, study.kernels)
    (out / "report.html").write_text(text, encoding="utf-8")
    return [chart.name for chart, _ in shown], missing
