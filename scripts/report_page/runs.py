"""Folders of runs, read back: what `raysweep report` wrote, the records beside it, traces, and what scripts/record_overhead wrote."""

import csv
import dataclasses
import functools
import json
import pathlib

from study_charts.runs import RunError, read_json

SCHEMA = 1  # of report.json, in results/report_data.h
OVERHEAD = "task_sizes.csv"


def read_table(file):
    """The lines of a CSV as dictionaries; none where there is no file."""
    if not file.is_file():
        return []
    try:
        with file.open(encoding="utf-8", newline="") as lines:
            return list(csv.DictReader(lines))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise RunError(f"{file}: cannot be read: {error}") from error


@dataclasses.dataclass(frozen=True)
class Run:
    folder: pathlib.Path
    report: dict  # report.json
    machine: dict

    @property
    def experiment(self):
        return self.report["experiment"]

    @property
    def kind(self):
        return self.report["kind"]

    @property
    def cores(self):
        return self.report["machine"]["cores"]

    @property
    def pus(self):
        return self.report["machine"]["pus"]

    @functools.cached_property
    def frames(self):
        """(cell, seconds) of each frame of valid launches, in the order of the records.

        Those of which copies ran together, or that ran once more to tell the noise, are another question's.
        """
        found = []
        file = self.folder / "records.jsonl"
        if self.kind != "picture" or not file.is_file():
            return found
        # A last line without its end is what a run that was stopped leaves.
        for number, line in enumerate(file.read_text(encoding="utf-8").split("\n")[:-1], 1):
            try:
                record = json.loads(line)
                if record["valid"] and record.get("processes", 1) == 1 and not record.get("twin", 0):
                    found += [(record["cell"], seconds) for seconds in record["frame_seconds"]]
            except (json.JSONDecodeError, KeyError, TypeError) as error:
                raise RunError(f"{file}:{number}: is no record of a picture: {error!r}") from error
        return found

    def table(self, name):
        """tables/NAME.csv as dictionaries, which `raysweep report` wrote; empty where there is none."""
        return read_table(self.folder / "tables" / f"{name}.csv")

    @functools.cached_property
    def task_sizes(self):
        return read_table(self.folder / OVERHEAD)

    @functools.cached_property
    def overheads(self):
        return read_table(self.folder / "overhead.csv")

    @functools.cached_property
    def traces(self):
        """(name, events file) of every *.trace.json, by name."""
        return [(file.name.removesuffix(".trace.json"), read_json(file)) for file in sorted(self.folder.glob("*.trace.json"))]


def as_text_table(name, title, lines):
    """A CSV as report.json has tables."""
    columns = [{"title": key.replace("_", " "), "number": key not in ("scheduler", "runtime", "wait", "notes")} for key in lines[0]]
    return {"name": name, "caption": title, "columns": columns, "rows": [list(line.values()) for line in lines]}


def overhead_report(folder, machine):
    """As if it were an experiment: what scripts/record_overhead measured."""
    lines = read_table(folder / "overhead.csv")
    tables = (
        [as_text_table("overhead", "What handing work out costs, in ns; METG is the smallest task that keeps a share of all processors busy", lines)]
        if lines
        else []
    )
    known = {key: machine.get(key) for key in ("host", "cpu")} | {key: machine.get(key, 0) for key in ("cores", "pus")}
    return {
        "schema": SCHEMA, "experiment": "overhead", "title": "What handing work out costs", "kind": "overhead",
        "question": "How small may a task be before handing it out costs more than it does?", "command": "scripts/record_overhead",
        "machine": known, "noise_floor": None, "rows": [], "claims": [], "published": None, "tables": tables,
    }  # fmt: skip


def read_run(folder):
    """One folder, with report.json, or of scripts/record_overhead. Raises RunError."""
    folder = pathlib.Path(folder)
    machine = read_json(folder / "machine.json", missing_is={})
    file = folder / "report.json"
    if not file.is_file():
        if (folder / OVERHEAD).is_file():
            return Run(folder, overhead_report(folder, machine), machine)
        raise RunError(f"{folder}: has no report.json, which `raysweep report {folder}` writes from its records")
    report = read_json(file)
    if report.get("schema") != SCHEMA:
        raise RunError(f"{file}: schema {report.get('schema')}; this page reads schema {SCHEMA}")
    for row in report["rows"]:
        # What a row was never measured for is no value of it.
        row["values"] = {name: e for name, e in row["values"].items() if e and e["value"] is not None}
    return Run(folder, report, machine)
