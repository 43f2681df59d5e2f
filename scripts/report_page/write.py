"""From runs to the files of a report."""

import pathlib
import shutil
import tempfile

from report_page import bundle, style
from report_page.charts import charts_of, charts_of_pairs
from report_page.headline import anchors_of
from report_page.page import page


def all_charts(runs):
    """A list of charts a run; what two runs tell together stands with the kernel run."""
    charts = [charts_of(run) for run in runs]
    for index, more in charts_of_pairs(runs).items():
        charts[index] += more
    return charts


def missing_of(runs, charts):
    """A sentence for each run of which nothing is drawn."""
    return [f"{run.folder.name}: nothing in it can be drawn; its tables stand below." for run, mine in zip(runs, charts) if not mine]


def write_charts(specs, folder):
    """NAME.svg and NAME.png of each specification, in the light, for papers."""
    drawn = bundle.drawn(specs, style.config("light", style.FILE_FONT)) if specs else {}
    for name, svg in drawn.items():
        file = folder / f"{name}.svg"
        file.write_text(svg, encoding="utf-8")
        bundle.write_png(file, folder / f"{name}.png")


def write_report(runs, out):
    """Writes OUT/charts/*.svg, *.png and OUT/report.html, the same for the same runs. Returns (how many charts, what is missing).

    All is made in a folder of its own first, so that a tool that fails leaves OUT as it was.
    """
    charts = all_charts(runs)
    missing = missing_of(runs, charts)
    specs = {f"{anchor}-{chart.name}": chart.described for anchor, mine in zip(anchors_of(runs), charts) for chart in mine}
    text = page(runs, charts, bundle.page_script(), missing)
    with tempfile.TemporaryDirectory() as made:
        write_charts(specs, pathlib.Path(made))
        (out / "charts").mkdir(parents=True, exist_ok=True)
        for file in sorted(pathlib.Path(made).iterdir()):
            shutil.copyfile(file, out / "charts" / file.name)
    (out / "report.html").write_text(text, encoding="utf-8")
    return len(specs), missing
