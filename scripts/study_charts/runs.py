"""Folders of runs, read back: records, plan and machine, whatever the kind."""

import dataclasses
import json
import pathlib

# By kind, in results/*_record.h. Kernels of schema 1 are what those of 2 are that test rays.
SCHEMAS = {"accuracy": (3,), "kernel": (1, 2, 3), "pixels": (2,), "atlas": (1,)}


class RunError(Exception):
    """A folder that cannot be drawn. The message is a sentence that says which, and why."""


@dataclasses.dataclass(frozen=True)
class Run:
    folder: pathlib.Path
    kind: str
    plan: dict
    machine: dict
    records: list  # of dictionaries, as results/*_record.h names their members


def read_json(file, missing_is=None):
    """What a file holds; `missing_is` where there is none, if it is given."""
    if missing_is is not None and not file.is_file():
        return missing_is
    try:
        return json.loads(file.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise RunError(f"{file}: cannot be read: {error}") from error


def read_records(file):
    """Every whole line; a last one without its end is left out, as a run that was stopped leaves it."""
    try:
        lines = file.read_text(encoding="utf-8").split("\n")[:-1]
    except (OSError, UnicodeDecodeError) as error:
        raise RunError(f"{file}: cannot be read: {error}") from error
    records = []
    for number, line in enumerate(lines, 1):
        try:
            record = json.loads(line)
            kind, schema = record["kind"], record["schema"]
        except (json.JSONDecodeError, KeyError, TypeError) as error:
            raise RunError(f"{file}:{number}: is no record: {error!r}") from error
        if kind not in SCHEMAS:
            raise RunError(f'{file}:{number}: unknown kind "{kind}"; these charts read: {", ".join(SCHEMAS)}')
        if schema not in SCHEMAS[kind]:
            readable = ", ".join(map(str, SCHEMAS[kind]))
            raise RunError(f"{file}:{number}: {kind} of schema {schema}; these charts read schema {readable}")
        if kind == "kernel" and record.get("kernel", "intersection") != "intersection":
            raise RunError(f'{file}:{number}: kernel "{record["kernel"]}"; these charts are of intersection')
        records.append(record)
    if not records:
        raise RunError(f"{file}: has no record")
    return records


def read_run(folder):
    """One folder: records.jsonl, and plan.json and machine.json where they are. Raises RunError."""
    folder = pathlib.Path(folder)
    records = read_records(folder / "records.jsonl")
    kinds = sorted({record["kind"] for record in records})
    if len(kinds) > 1:
        raise RunError(f"{folder}: holds records of {len(kinds)} kinds: {', '.join(kinds)}; a run has one")
    plan, machine = (read_json(folder / name, missing_is={}) for name in ("plan.json", "machine.json"))
    return Run(folder, kinds[0], plan, machine, records)


def in_order(values):
    """Each value once, in the order of their first."""
    return list(dict.fromkeys(values))
