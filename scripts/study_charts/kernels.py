"""What the records of kernel runs say: ns a test, and how two kernels compare round by round."""

import dataclasses
import math

from study_charts.numbers import Estimate, estimate_median, median
from study_charts.runs import in_order

# Which protocol speaks for a method where one number has to: what all studies have, then what is nearest to it.
HEADLINES = ("random", "hit-rate", "worst-case", "replay")


@dataclasses.dataclass(frozen=True)
class Workload:
    """What is tested: a protocol, its parameter (None where it has none) and, of replays, the scene."""

    protocol: str
    parameter: float | None = None
    scene: str = ""

    def __str__(self):
        words = {"hit-rate": "hit rate {:g}", "clusters": "clusters {:g}"}
        if self.parameter is not None:
            return words.get(self.protocol, self.protocol + " {:g}").format(self.parameter)
        names = {"worst-case": "worst case", "random": "random rays"}
        return names.get(self.protocol, self.protocol) + (f" of {self.scene}" if self.scene else "")


# The factors of a formula's variant; all else in a change is how its numbers are laid out and compiled.
FACTORS = ("division", "reciprocal", "order", "edges", "early_out", "output", "data")


@dataclasses.dataclass(frozen=True)
class Kernel:
    method: str
    change: str
    precision: str

    @property
    def factors(self):
        """What is changed of the formula: ("division=late", "edges=strict")."""
        return tuple(c for c in self.change.split(",") if c.split("=")[0] in FACTORS)

    @property
    def form(self):
        """What is changed besides: ("rays=8", "isa=avx2")."""
        return tuple(c for c in self.change.split(",") if c != "base" and c not in self.factors)

    @property
    def combines(self):
        """Whether several changes meet, of the formula or of it and its form: such a kernel is none of the star."""
        return len(self.factors) + bool(self.form) > 1 and bool(self.factors)


def workload_of(r):
    parameter = r["parameter"]
    if parameter is not None and math.isnan(parameter):
        parameter = None
    return Workload(r["protocol"], parameter, r["scene"])


def ns_per_test(r):
    """Of a record, a round: the median of its samples."""
    return 1e9 * median(r["seconds"]) / (r["iterations"] * r["tests"])


class Kernels:
    """The valid records of all kernel runs: every kernel on every workload, round by round."""

    def __init__(self, records):
        self.records = [r for r in records if r["valid"]]
        self.invalid_count = len(records) - len(self.records)
        self._rounds, self._facts = {}, {}
        for r in self.records:
            kernel = Kernel(r["method"], r["change"], r["precision"])
            self._rounds.setdefault((kernel, workload_of(r)), {})[r["experiment"], r["launch"], r["round"]] = ns_per_test(r)
            self._facts[kernel] = r
        self.methods = in_order(r["method"] for r in self.records)
        self.precisions = in_order(r["precision"] for r in self.records)
        self.workloads = in_order(workload_of(r) for r in self.records)

    def kernels(self, workload=None, combined=False):
        """All kernels of the star, or those that ran on `workload`; `combined`: those that combine several changes instead."""
        return in_order(k for k, w in self._rounds if workload in (None, w) and k.combines == combined)

    def facts(self, kernel):
        """What a record says of its kernel: variant, bytes, isa, …"""
        return self._facts[kernel]

    def ns(self, kernel, workload):
        """ns a test: the median of the rounds with its interval; None if it has not been run."""
        rounds = self._rounds.get((kernel, workload))
        return estimate_median(rounds.values()) if rounds else None

    def ratio(self, of, to, workload):
        """How much time `of` takes for each unit of `to`, of rounds that both have; None without any."""
        ours, theirs = (self._rounds.get((k, workload), {}) for k in (of, to))
        ratios = [ours[key] / theirs[key] for key in ours if key in theirs]
        return estimate_median(ratios) if ratios else None

    def price(self, of, to, workload):
        """What `of` costs more than `to`, in percent; negative where it is cheaper."""
        ratio = self.ratio(of, to, workload)
        if ratio is None:
            return None
        ends = [None if end is None else 100 * (end - 1) for end in (ratio.low, ratio.high)]
        return Estimate(100 * (ratio.value - 1), *ends, ratio.count)

    def headline(self):
        """The workload that speaks for all: random rays, else the hit rate nearest ½, else the first there is."""
        for protocol in HEADLINES:
            found = [w for w in self.workloads if w.protocol == protocol]
            if found:
                return min(found, key=lambda w: abs((w.parameter if w.parameter is not None else 0.5) - 0.5))
        return self.workloads[0]

    def of_protocol(self, protocol):
        """Its workloads by their parameter."""
        found = [w for w in self.workloads if w.protocol == protocol]
        return sorted(found, key=lambda w: (w.parameter is not None, w.parameter or 0.0))

    def base(self, precision, workload):
        """The base kernels of a precision on a workload, the fastest first, with their ns."""
        found = [k for k in self.kernels(workload) if k.change == "base" and k.precision == precision]
        return sorted(((k, self.ns(k, workload)) for k in found), key=lambda pair: pair[1].value)
