"""One page that stands alone: the machine, the answers, the charts and the tables."""

import base64
import dataclasses
import pathlib

import jinja2

from study_charts.answers import answers, class_rows
from study_charts.colours import variables
from study_charts.machines import grouped
from study_charts.numbers import per_million, power, short

# The page is to be sent by mail: what charts and tables leave of this is for pictures.
PAGE_BYTES = 2_900_000
TABLE_BYTES = 300_000
TEMPLATE = "report.html.jinja"


@dataclasses.dataclass(frozen=True)
class Table:
    title: str
    head: list
    rows: list  # of lists of text
    note: str = ""


@dataclasses.dataclass(frozen=True)
class Picture:
    name: str
    data: str  # a data: address


def machines(runs):
    """(title, rows) a run; runs on the same machine by the same build stand together."""
    return grouped((f"{run.plan.get('experiment', run.folder.name)} ({run.kind}, {len(run.records):,} records)", run.machine) for run in runs)


def speed_table(kernels):
    """ns a test of every base kernel on every workload of single rays."""
    workloads = [w for w in kernels.workloads if not w.protocol.startswith("packet")]
    rows = []
    for precision in kernels.precisions:
        for kernel, _ in kernels.base(precision, kernels.headline()):
            estimates = [kernels.ns(kernel, w) for w in workloads]
            bytes_read = kernels.facts(kernel)["bytes"]
            rows.append([kernel.method, precision, str(bytes_read)] + [_estimate(e) for e in estimates])
    note = "Median over rounds; in brackets the 95 % interval by order statistics, where there are six rounds or more."
    return Table("ns a test", ["method", "precision", "bytes a triangle"] + [str(w) for w in workloads], rows, note)


def _estimate(estimate):
    if estimate is None:
        return "–"
    interval = "" if estimate.low is None else f" ({short(estimate.low)}–{short(estimate.high)})"
    return short(estimate.value) + interval


def class_table(accuracy):
    columns, rows = class_rows(accuracy)
    head = ["method", "precision"] + [f"{c}: {name}" for c, name in columns]
    body = [[m, p] + [per_million(r).replace(" per million", "") if r else "–" for r in rates] for m, p, rates in rows]
    return Table("Failures per million, by class of cases", head, body, "≤: none seen, 95 %. All difficulties of a class together.")


def break_table(accuracy, precision):
    """The first difficulty with anything wrong, a column a case."""
    rows = []
    for method in accuracy.methods:
        firsts = [accuracy.first_failure(method, precision, case) for case in accuracy.cases]
        rows.append([method] + ["never" if first is None else power(first) for first in firsts])
    return Table(f"First difficulty with any failure, {precision}", ["method"] + accuracy.cases, rows)


def case_table(accuracy):
    rows = [[case, accuracy.units[case], " · ".join(power(d) for _, d in accuracy.levels(case))] for case in accuracy.cases]
    return Table("The cases and their difficulties, from easy to hard", ["case", "difficulty", "values"], rows)


def tables(accuracy, kernels):
    found = [speed_table(kernels)] if kernels else []
    if accuracy:
        found += [class_table(accuracy)] + [break_table(accuracy, p) for p in accuracy.precisions] + [case_table(accuracy)]
    return found


def pictures_of(runs, most):
    """(pictures, how many are left out): the PNG files of runs of pixels, in the order of their names, as far as they fit into `most` bytes.

    Of those that are equal, byte by byte, as cores should make them, the first one.
    """
    found, left_out, size, seen = [], 0, 0, set()
    for file in sorted(file for run in runs if run.kind == "pixels" for file in (run.folder / "pictures").glob("*.png")):
        text = base64.b64encode(file.read_bytes()).decode()
        if text in seen:
            continue
        seen.add(text)
        if size + len(text) > most:
            left_out += 1
            continue
        size += len(text)
        found.append(Picture(file.stem, "data:image/png;base64," + text))
    return found, left_out


def page(runs, missing, charts, inline, accuracy, kernels):
    """The page's text. `charts`: pairs of a chart and its inline picture; `missing`: sentences on what is left out."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(pathlib.Path(__file__).parent), autoescape=True, undefined=jinja2.StrictUndefined,
        trim_blocks=True, lstrip_blocks=True,
    )  # fmt: skip
    taken = TABLE_BYTES + sum(len(picture) for _, picture in charts)
    pictures, left_out = pictures_of(runs, PAGE_BYTES - taken)
    return environment.get_template(TEMPLATE).render(
        machines=machines(runs), missing=missing, answers=answers(accuracy, kernels), charts=charts, tables=tables(accuracy, kernels),
        pictures=pictures, left_out=left_out, light=variables(dark=False), dark=variables(dark=True), chart_style=inline.style(),
    )  # fmt: skip
