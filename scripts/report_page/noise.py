"""How sure a run's machine lets anybody be: the noise floor, and what its rows warn of."""

import math
import re

from study_charts.numbers import short

# Facts of machine.json that make timings doubtful: (name, test of its state, sentence).
DOUBTS = [
    ("virtual_machine", lambda s: str(s).startswith("yes"), "It is a virtual machine: its processors are shared with others that no tool here sees."),
    ("quota", lambda s: s not in ("unlimited", None, "unknown"), "A quota limits its processor time."),
    ("governor", lambda s: s not in ("performance", "unknown", None), "Its governor changes the clock as it likes."),
]  # fmt: skip
MOST_LOAD = 0.25  # of the processors, by others
NUMBER = re.compile(r"[−+±-]?\d[\d.,]*( %)?")


def noise_text(run):
    """What two launches of the same differ by; differences below it mean nothing."""
    floor = run.report["noise_floor"]
    return "not told" if floor is None else f"{short(math.expm1(floor) * 100, 2)} %"


def measured_on(runs):
    """A sentence on one machine's runs: what it is, and how much of a difference there means nothing."""
    machine = runs[0].machine
    where = f"{machine.get('host') or 'an unnamed machine'}: {machine['cpu']}, {machine['cores']} cores, {machine['pus']} processors" if machine.get("cpu") else "an unknown machine"
    floors = sorted((run.report["noise_floor"], run.experiment) for run in runs if run.report["noise_floor"] is not None)
    if not floors:
        return f"Measured on {where}; its noise was not."
    percent = [f"{short(math.expm1(floor) * 100, 2)} %" for floor, _ in (floors[0], floors[-1])]
    span = percent[0] if len(floors) == 1 else f"{percent[0]} ({floors[0][1]}) to {percent[1]} ({floors[-1][1]})"
    return f"Measured on {where}. The same cell, launched twice, differed by {span}: smaller differences of frames a second mean nothing."


def kind_of_note(note):
    """A note without its numbers, so that alike ones are counted together."""
    return NUMBER.sub("…", note.split(":")[0].split("(")[0].strip())


def notes_of(run):
    """(note, how many rows have it), those of most rows first."""
    counts = {}
    for row in run.report["rows"]:
        for note in dict.fromkeys(kind_of_note(n) for n in row["notes"]):
            counts[note] = counts.get(note, 0) + 1
    return sorted(counts.items(), key=lambda item: (-item[1], item[0]))


def load_text(run):
    """The machine's load when the run began, and whether that was much."""
    load = run.machine.get("load")
    if load is None:
        return "not told"
    return short(load) + (": others worked too" if run.pus and load > MOST_LOAD * run.pus else "")


def warnings_of(run):
    """Sentences."""
    facts = run.machine.get("facts", {})
    found = [sentence for name, doubtful, sentence in DOUBTS if name in facts and doubtful(facts[name].get("state"))]
    unknown = sum(f.get("state") == "unknown" for f in facts.values())
    if unknown:
        found.append(f"{unknown} of its facts could not be read; machine.json says why.")
    return found
