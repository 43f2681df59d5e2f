"""What of charts and tables the page has place for: it is to be sent by mail."""

import dataclasses
import json

PAGE_BYTES = 2_900_000
# Of these, what charts may take; tables and text have the rest.
CHART_BYTES = 1_800_000
SAMPLES = "samples"  # how data sets of samples begin


def embedded(value):
    """JSON to stand within a <script>."""
    return json.dumps(value, ensure_ascii=False, separators=(",", ":")).replace("</", "<\\/")


def without_samples(spec):
    """The specification with its data sets of samples empty."""
    return spec | {"data": [d | {"values": []} if d["name"].startswith(SAMPLES) else d for d in spec["data"]]}


def fitting_specs(specs, place=CHART_BYTES):
    """(specs, names): those with most samples lose them, one after another, until all are within `place` bytes; `names` are theirs."""
    sizes = {name: len(embedded(spec).encode()) for name, spec in specs.items()}
    slim = {name: without_samples(spec) for name, spec in specs.items()}
    gains = {name: sizes[name] - len(embedded(slim[name]).encode()) for name in specs}
    total, names = sum(sizes.values()), []
    for name in sorted(specs, key=lambda name: -gains[name]):
        if total <= place or not gains[name]:
            break
        total -= gains[name]
        names.append(name)
    return {name: slim[name] if name in names else spec for name, spec in specs.items()}, names


def fitting_tables(sections, place):
    """The sections with as many tables, the smallest first, as `place` bytes hold; the others are named."""
    every = sorted((t for s in sections for t in s.tables), key=lambda t: t.size)
    kept, taken = set(), 0
    for table in every:
        taken += table.size
        if taken <= place:
            kept.add(id(table))
    return [
        dataclasses.replace(s, tables=[t for t in s.tables if id(t) in kept], left_out=[t.file for t in s.tables if id(t) not in kept])
        for s in sections
    ]  # fmt: skip
