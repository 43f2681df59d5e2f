"""A chart of the page, and estimates as charts and tables show them."""

import dataclasses

from report_page.panel import Point
from study_charts.numbers import short

# Above so many, samples of a chart would be most of the page: their estimates stand alone, and the caption says so.
MOST_SAMPLES = 3000
# In this order: of pictures, of kernels, of accuracy, of pixels.
MAIN = ("fps", "nanoseconds", "ticks", "t_error_p99", "rmse", "flip_mean", "wrong_pixels")


@dataclasses.dataclass(frozen=True)
class Chart:
    """One picture. `title` states what is seen, `text` how to read it; `name` is its file's."""

    name: str
    title: str
    text: str
    spec: dict

    @property
    def described(self):
        """The specification with what the picture is to those who cannot see it."""
        return self.spec | {"description": f"{self.title}. {self.text}"}


def estimate_text(estimate, digits=4):
    """ "11.25 [11.18, 11.31]", or "11.25, no interval"."""
    if estimate is None or estimate["value"] is None:
        return "–"
    value = short(estimate["value"], digits)
    if estimate.get("low") is None or estimate.get("high") is None:
        return f"{value}, no interval"
    return f"{value} [{short(estimate['low'], digits)}, {short(estimate['high'], digits)}]"


def tip_of(row, quantity, series, names=()):
    """What a tooltip says of a row's quantity: (name, text) pairs."""
    estimate = row["values"][quantity]
    pairs = [[series, ""]] if series else []
    pairs += [[name.replace("_", " "), row["factors"].get(name, "-")] for name in names]
    pairs.append([quantity.replace("_", " "), estimate_text(estimate)])
    if estimate.get("count"):
        pairs.append(["samples", str(estimate["count"])])
    pairs += [["note", note] for note in row["notes"]]
    return pairs


def point_of(row, quantity, x, series, samples=True, names=()):
    """A row's quantity as a point of a panel; None where it has no value."""
    estimate = row["values"].get(quantity)
    if not estimate:
        return None
    raw = row["samples"].get(quantity, []) if samples else []
    return Point(series, x, estimate["value"], estimate["low"], estimate["high"], tip_of(row, quantity, series, names), raw)


def main_quantity(rows):
    """What an experiment asks for first, of what any row has a value of."""
    there = dict.fromkeys(name for row in rows for name in row["values"])
    return next((name for name in (*MAIN, *there) if name in there), None)


def sample_count(rows, quantity):
    return sum(len(row["samples"].get(quantity, [])) for row in rows)


def few_enough(rows, quantity):
    return sample_count(rows, quantity) <= MOST_SAMPLES


def samples_sentence(rows, quantity):
    """What the small dots are, or why there are none."""
    count = sample_count(rows, quantity)
    if not count and all(row["values"].get(quantity, {}).get("low") is None for row in rows):
        return "No intervals: exact counts, or fewer than six rounds."
    if not count:
        return "Bars: 95 % intervals."
    if count > MOST_SAMPLES:
        return f"The {count:,} samples stand in records.jsonl; they would hide the estimates here."
    return f"Small dots: the {count:,} samples, one a round. Bars: 95 % intervals."
