"""Statistics of the study: pure functions of numbers, by the same definitions as results/statistics."""

import dataclasses
import math

Z_95 = 1.959963984540054  # the normal distribution's quantile at 0.975


@dataclasses.dataclass(frozen=True)
class Estimate:
    """A value with its 95 % interval; `low` and `high` are None where none can be had."""

    value: float
    low: float | None = None
    high: float | None = None
    count: int = 0  # samples

    def scaled(self, factor):
        """All of it times `factor`, which is positive."""
        ends = [None if end is None else end * factor for end in (self.low, self.high)]
        return Estimate(self.value * factor, *ends, self.count)


@dataclasses.dataclass(frozen=True)
class Rate:
    """`count` failures of `of` tries. Of no tries there is no rate."""

    count: int
    of: int

    def __add__(self, other):
        return Rate(self.count + other.count, self.of + other.of)

    @property
    def share(self):
        return self.count / self.of

    @property
    def upper(self):
        """What is to be drawn: the share, or for none seen 3/n, their bound at 95 % (Hanley & Lippman-Hand 1983)."""
        return self.share if self.count else min(1.0, 3 / self.of)

    @property
    def interval(self):
        """95 %, by the score (Wilson 1927), with the share in it whatever is rounded; for none seen from 0 to 3/n."""
        if self.count == 0:
            return 0.0, self.upper
        square = Z_95**2 / self.of
        middle = (self.share + square / 2) / (1 + square)
        half = Z_95 * math.sqrt(self.share * (1 - self.share) / self.of + square / (4 * self.of)) / (1 + square)
        return max(0.0, min(self.share, middle - half)), min(1.0, max(self.share, middle + half))


def median(samples):
    """The middle one, or the mean of the middle two. Infinite samples count by their order."""
    ordered = sorted(samples)
    half = len(ordered) // 2
    if len(ordered) % 2 or ordered[half - 1] == ordered[half]:
        return ordered[half]
    return (ordered[half - 1] + ordered[half]) / 2


def median_interval_rank(count):
    """The largest k for which the order statistics k+1 and n−k hold the median with at least 95 %; None for n < 6."""
    rank, below = None, 0.0
    for k in range(count // 2):
        below += math.comb(count, k) * 0.5**count
        if 1 - 2 * below < 0.95:
            break
        rank = k
    return rank


def estimate_median(samples):
    """The median with its 95 % order-statistic interval."""
    ordered = sorted(samples)
    rank = median_interval_rank(len(ordered))
    ends = (None, None) if rank is None else (ordered[rank], ordered[len(ordered) - 1 - rank])
    return Estimate(median(ordered), *ends, len(ordered))


def pareto_front(points):
    """Indices of the points that no other one beats: none is as small in both and smaller in one. By their first number."""
    front = []
    for i in sorted(range(len(points)), key=lambda i: points[i]):
        if not front or points[i][1] < points[front[-1]][1]:
            front.append(i)
    return front


def short(value, digits=3):
    """Three digits of it: "12.3", "1,240", "0.0031", "3.1e-07"; "∞" for infinity, "–" for None and NaN."""
    if value is None or math.isnan(value):
        return "–"
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    if value != 0 and not 1e-4 <= abs(value) < 1e7:
        return f"{value:.{digits - 1}g}".replace("-", "−")
    if abs(value) >= 1000:
        return f"{value:,.0f}".replace("-", "−")
    return f"{value:.{digits}g}".replace("-", "−")


def power(value):
    """A difficulty as short as a tick has place: "10⁻⁶", "0.01", "4096"."""
    if value and not 1e-2 <= abs(value) < 1e4:
        exponent = math.floor(math.log10(abs(value)) + 1e-9)
        digit = value / 10**exponent
        raised = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        return f"10{raised}" if abs(digit - 1) < 1e-6 else f"{digit:.2g}·10{raised}"
    return f"{value:g}"


def per_million(rate):
    """A rate as text: "1,240 per million", "≤ 150 per million" for none seen."""
    sign = "" if rate.count else "≤ "
    return f"{sign}{short(rate.upper * 1e6)} per million"
