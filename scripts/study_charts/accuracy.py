"""What the records of accuracy runs say: rates of failure and errors, of methods, cases and classes of cases."""

import dataclasses
import math
import statistics

from study_charts.numbers import Rate
from study_charts.runs import in_order

CLASSES = {
    "W": "edges of a mesh",
    "F": "far from the origin",
    "S": "scale",
    "D": "shape",
    "N": "numbers",
    "E": "ends and extremes",
}
# The gravest error a hit can have: none at all.
NO_HIT = math.inf


def false_misses(r):
    return Rate(r["false_misses"], r["hits"])


def false_hits(r):
    return Rate(r["false_hits"], r["trials"] - r["hits"] - r["boundary"])


def missed_rays(r):
    return Rate(r["missed_rays"], r["mesh_rays"] - r["uncovered"])


def extra_rays(r):
    return Rate(r["extra"], r["mesh_rays"])


MEASURES = {"false misses": false_misses, "false hits": false_hits, "missed rays": missed_rays}


def class_of(case):
    return case[0]


def gravity(record):
    """The greatest share of what goes wrong. Of a mesh it is the rays that pass it: which of two neighbours a ray at
    their edge hits is no matter. Elsewhere it is false misses and false hits; numbers that are not finite count everywhere."""
    of_mesh = record["mesh_rays"] > 0
    rates = [missed_rays(record)] if of_mesh else [false_misses(record), false_hits(record)]
    rates.append(Rate(record["nonfinite"], max(record["trials"], 1)))
    return max((rate.share for rate in rates if rate.of), default=0.0)


def has_failed(record):
    return any(measure(record).count for measure in MEASURES.values()) or record["nonfinite"] > 0


def t_error(record):
    """The 99th percentile of the relative error of t, in ε; NO_HIT where hits were due and none came; else None."""
    error = record["t_error"]
    if error["count"]:
        return NO_HIT if error["p99"] is None else error["p99"]
    return NO_HIT if record["hits"] and record["false_misses"] == record["hits"] else None


@dataclasses.dataclass(frozen=True)
class Spread:
    """Median and quartiles over cells; an end may be infinite."""

    low: float
    middle: float
    high: float


def _place(class_id):
    return list(CLASSES).index(class_id) if class_id in CLASSES else len(CLASSES)


class Accuracy:
    """The records of all accuracy runs together; later runs replace cells of earlier ones."""

    def __init__(self, records):
        self._index = {self._key(r): r for r in records}
        self.records = list(self._index.values())
        self.methods = in_order(r["method"] for r in self.records)
        self.precisions = in_order(r["precision"] for r in self.records)
        self.cases = sorted(in_order(r["case"] for r in self.records), key=lambda case: (_place(class_of(case)), case))
        with_mesh = {r["case"] for r in self.records if r["mesh_rays"]}
        self.mesh_cases = [case for case in self.cases if case in with_mesh]
        self._subjects, self._levels = {}, {}
        for r in self.records:
            self._subjects.setdefault((r["method"], r["change"], r["precision"]), []).append(r)
            self._levels.setdefault(r["case"], {})[r["level"]] = r["difficulty"]
        self.units = {r["case"]: r["difficulty_of"] for r in self.records}
        self.classes = [c for c in CLASSES if any(class_of(case) == c for case in self.cases)]

    @staticmethod
    def _key(r):
        return r["method"], r["change"], r["precision"], r["case"], r["level"]

    def find(self, method, precision, case, level, change="base"):
        """The record, or None if it has not been run."""
        return self._index.get((method, change, precision, case, level))

    def levels(self, case):
        """The levels of a case that were run, from easy to hard, with their difficulties."""
        return sorted(self._levels[case].items())

    def of(self, method, precision, change="base", only=None):
        """Records of a method in the order of cases and levels; of the cases that `only(case)` is true of."""
        found = self._subjects.get((method, change, precision), [])
        return [r for r in found if not only or only(r["case"])]

    def changes(self):
        """(method, change, precision) of all subjects that were run."""
        return list(self._subjects)

    @staticmethod
    def pooled(records, measure):
        """The rate of all records together; None where there was nothing to fail."""
        total = sum((measure(r) for r in records), Rate(0, 0))
        return total if total.of else None

    @staticmethod
    def error_spread(records):
        """Of the errors of t of these cells, one a case and difficulty; None without any."""
        errors = sorted(e for e in map(t_error, records) if e is not None)
        if not errors:
            return None
        middle = statistics.median_low(errors)
        half = len(errors) // 2
        if len(errors) < 2:
            return Spread(middle, middle, middle)
        return Spread(statistics.median_low(errors[:half]), middle, statistics.median_high(errors[-half:]))

    def first_failure(self, method, precision, case, above=None):
        """The difficulty at which anything goes wrong first, or more than the share `above` by `gravity`; None if never."""
        for level, difficulty in self.levels(case):
            record = self.find(method, precision, case, level)
            if record and (has_failed(record) if above is None else gravity(record) > above):
                return difficulty
        return None
