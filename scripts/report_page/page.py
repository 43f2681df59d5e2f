"""The page's text: the answers, the machine, then a section an experiment."""

import dataclasses
import pathlib

import jinja2

from report_page import style
from report_page.chart import estimate_text
from report_page.headline import anchors_of, answers_of, counted, counted_in_source
from report_page.noise import load_text, measured_on, noise_text, notes_of, warnings_of
from report_page.size import PAGE_BYTES, embedded, fitting_specs, fitting_tables
from study_charts.colours import variables
from study_charts.machines import grouped
from study_charts.numbers import short

TEMPLATE = "report.html.jinja"
# Tables of a run that the page tells in its own way.
OWN = ("claims", "published")


@dataclasses.dataclass(frozen=True)
class Table:
    name: str
    title: str  # its first line
    notes: list  # its further lines
    columns: list
    rows: list
    file: str  # where it is read too

    @property
    def size(self):
        return sum(len(cell) + 12 for row in self.rows for cell in row)


@dataclasses.dataclass(frozen=True)
class Section:
    run: object
    anchor: str
    answers: list
    charts: list  # (name in the page, Chart) pairs
    published: Table | None
    tables: list
    left_out: list  # tables that did not fit

    @property
    def report(self):
        return self.run.report

    @property
    def noise(self):
        return noise_text(self.run)

    @property
    def load(self):
        return load_text(self.run)

    @property
    def notes(self):
        return notes_of(self.run)


def table_of(run, made):
    lines = made["caption"].split("\n")
    return Table(made["name"], lines[0] or made["name"], lines[1:], made["columns"], made["rows"], f"{run.folder.name}/tables/{made['name']}.csv")


def published_table(run):
    """Printed numbers beside ours; None without any."""
    published = run.report["published"]
    if not published or not published["rows"]:
        return None
    names = list(dict.fromkeys(name for row in published["rows"] for name in row["factors"]))
    normalised = published["normalise"] != "none"
    heads = ["printed", "here"] + (["printed / first row", "here / first row"] if normalised else [])
    rows = []
    for row in published["rows"]:
        cells = [row["printed"], estimate_text(row["ours"])]
        cells += [short(row["printed_normalised"], 4), estimate_text(row["ours_normalised"])] if normalised else []
        rows.append([row["factors"].get(n, "–") for n in names] + cells)
    columns = [{"title": n.replace("_", " "), "number": True} for n in [*names, *heads]]
    note = "Brackets hold 95 % intervals of ours." + (" Each column is divided by its own first row: the machines differ." if normalised else "")
    return Table(
        "published",
        f"Printed beside ours: {published['quantity'].replace('_', ' ')}",
        [note],
        columns,
        rows,
        f"{run.folder.name}/tables/published.csv",
    )


def sections_of(runs, charts):
    """A section a run; `charts` are lists, one a run."""
    sections = []
    for run, anchor, mine in zip(runs, anchors_of(runs), charts):
        tables = [table_of(run, t) for t in run.report["tables"] if t["rows"] and t["name"] not in OWN]
        named = [(f"{anchor}-{chart.name}", chart) for chart in mine]
        sections.append(Section(run, anchor, answers_of(run, anchor), named, published_table(run), tables, []))
    return sections


@dataclasses.dataclass(frozen=True)
class Machine:
    sections: list  # of runs on it
    rows: list  # (name, text)
    warnings: list

    @property
    def sentence(self):
        return measured_on([s.run for s in self.sections])


def machines_of(sections):
    """Each machine and build once, in the order of the sections. Its load is each run's own."""
    found = []
    machines = [{k: v for k, v in s.run.machine.items() if k != "load"} for s in sections]
    for places, rows in grouped((str(i), machine) for i, machine in enumerate(machines)):
        mine = [sections[int(place)] for place in places.split("; ")]
        found.append(Machine(mine, rows, warnings_of(mine[0].run)))
    return found


def page(runs, charts, script, missing):
    """The text of report.html. `missing`: sentences on what is not drawn."""
    sections = sections_of(runs, charts)
    configs = {scheme: style.config(scheme, style.PAGE_FONT) for scheme in ("light", "dark")}
    specs, slimmed = fitting_specs({name: chart.described for s in sections for name, chart in s.charts})
    given = embedded({"configs": configs, "specs": specs})
    taken = len(script.encode()) + len(given.encode()) + sum(s.published.size for s in sections if s.published)
    answers = [a for s in sections for a in s.answers]
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(pathlib.Path(__file__).parent), autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True,
    )  # fmt: skip

    def rendered(place):
        return environment.get_template(TEMPLATE).render(
            answers=answers, counted=counted(answers), in_source=counted_in_source(answers), machines=machines_of(sections),
            sections=fitting_tables(sections, place), missing=missing, slimmed=slimmed, given=given, script=script,
            light=variables(dark=False), dark=variables(dark=True),
        )  # fmt: skip

    place = PAGE_BYTES - taken
    text = rendered(place)
    # What else there is to say takes place, too: as much as the tables must leave.
    while (excess := len(text.encode()) - PAGE_BYTES) > 0 and place > 0:
        place -= excess
        text = rendered(place)
    return text
