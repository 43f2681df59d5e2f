"""The answers first: each claim of each experiment with its verdicts, and how many there are of each."""

import dataclasses

from study_charts.numbers import short

# In the order of a sentence; the marks say it without colours.
MARKS = {"reproduced": "✓", "not reproduced": "✗", "cannot be tested here": "–"}
SOURCE_MARKS = {"holds in the source": "✓", "contradicted by its own table": "✗", "undecided by its digits": "?", "not in a table": "–"}
CLASSES = {"✓": "kept", "✗": "broken", "–": "open", "?": "open"}


@dataclasses.dataclass(frozen=True)
class Verdict:
    text: str
    mark: str
    sentence: str

    @property
    def style(self):
        return CLASSES[self.mark]


@dataclasses.dataclass(frozen=True)
class Measured:
    """One group of a claim: what was measured, there or here, against what was expected."""

    group: str
    value: str
    expected: str
    holds: bool | None
    problem: str  # why it was not decided; empty where it was

    @property
    def text(self):
        """The number beside its range, and what kept it from a verdict."""
        told = f"{self.value}, expected {self.expected}" if self.value else "no number"
        return f"{told}; {self.problem}" if self.problem else told


@dataclasses.dataclass(frozen=True)
class Answer:
    """A claim as the page tells it."""

    experiment: str
    anchor: str
    id: str
    text: str
    source: str
    rule: str
    why: str
    printed: Verdict
    ours: Verdict
    printed_groups: list
    our_groups: list

    def summary(self, groups):
        """What decided: the only group; or how many hold, with one that does not where there is one."""
        if len(groups) == 1:
            return groups[0].text
        if not groups:
            return ""
        told = next((g for g in groups if g.holds is False), next((g for g in groups if g.holds is None), groups[0]))
        held, failed, open_ = (sum(g.holds is holds for g in groups) for holds in (True, False, None))
        of = [f"{held} hold{'s' if held == 1 else ''}"] if held else []
        of += [f"{failed} do{'es' if failed == 1 else ''} not"] if failed else []
        of += [f"{open_} undecided"] if open_ else []
        return f"Of {len(groups)}, {', '.join(of)}; {told.group}: {told.text}"

    @property
    def undecided(self):
        """Whether something was measured, but no verdict could be had of it."""
        return self.ours.mark == MARKS["cannot be tested here"] and any(g.value for g in self.our_groups)

    @property
    def shown_why(self):
        """Why ours are as they are: nothing to say of what was not tested."""
        return "" if self.ours.mark == MARKS["cannot be tested here"] else self.why


def range_text(low, high):
    if low is not None and high is not None:
        return short(low) if low == high else f"{short(low)} to {short(high)}"
    return f"≥ {short(low)}" if low is not None else f"≤ {short(high)}" if high is not None else "anything"


def measured_of(group):
    ends = group["low"], group["high"]
    interval = "" if None in ends else f" [{short(ends[0])}, {short(ends[1])}]"
    name = ", ".join(f"{k.replace('_', ' ')} {v}" for k, v in group["group"].items()) or "all"
    value = "" if group["value"] is None else short(group["value"]) + interval
    return Measured(name, value, range_text(group["expected_low"], group["expected_high"]), group["holds"], group["problem"] or "")


def answer_of(run, anchor, claim):
    printed, ours = claim["published"], claim["ours"]
    return Answer(
        run.experiment, f"{anchor}-claim-{claim['id']}", claim["id"], claim["text"], claim.get("source") or "", claim["rule"], claim.get("why") or "",
        Verdict(printed["verdict"], SOURCE_MARKS.get(printed["verdict"], "?"), printed["sentence"]),
        Verdict(ours["verdict"], MARKS.get(ours["verdict"], "?"), ours["sentence"]),
        [measured_of(g) for g in printed["groups"]], [measured_of(g) for g in ours["groups"]],
    )  # fmt: skip


def anchors_of(runs):
    """An id of each run's section: its experiment's name, and a number where another has it already."""
    found = []
    for run in runs:
        name = "".join(c if c.isalnum() else "-" for c in run.experiment.lower()) or "run"
        same = sum(other == name or other.startswith(f"{name}--") for other in found)
        found.append(f"{name}--{same + 1}" if same else name)
    return found


def answers_of(run, anchor):
    return [answer_of(run, anchor, claim) for claim in run.report["claims"]]


def counted(answers):
    """The headline, as a sentence."""
    if not answers:
        return "No claim was judged: these runs only measure."
    of = {text: sum(a.ours.text == text for a in answers) for text in MARKS}
    where = len({a.experiment for a in answers})
    told = ", ".join(f"{count} {text}" for text, count in of.items())
    undecided = sum(a.undecided for a in answers)
    told += f" ({undecided} of these measured, but undecided)" if undecided else ""
    return f"{len(answers)} claim{'s' if len(answers) > 1 else ''} of {where} experiment{'s' if where > 1 else ''}: {told}."


def counted_in_source(answers):
    """What the printed tables themselves say, as a sentence; empty where nothing was printed."""
    of = {text: sum(a.printed.text == text for a in answers) for text in SOURCE_MARKS}
    judged = {text: count for text, count in of.items() if count}
    return "In the sources themselves: " + ", ".join(f"{count} {text}" for text, count in judged.items()) + "." if judged else ""
