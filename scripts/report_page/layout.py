"""Which factors are lines, which panels and which the axis: from what varies among rows."""

import dataclasses

from report_page.factors import FOLLOWS, in_order, label, number_of, telling, varying
from report_page.style import MOST_SERIES

# More panels than these would not be looked at.
MOST_PANELS = 24


@dataclasses.dataclass(frozen=True)
class Layout:
    """`panels`: pairs of a title and the rows of a panel; `series`: all lines' names in order; `left_out`: panels beyond MOST_PANELS."""

    panels: list
    series: list
    series_names: list
    left_out: int

    def series_of(self, row):
        return series_label(row["factors"], self.series_names)

    def sentence(self):
        return f"{self.left_out} more panels would follow; report.json and the tables hold them." if self.left_out else ""

    def legend_title(self):
        return ", ".join(self.series_names).replace("_", " ")


def series_label(factors, names):
    """A name for a line; one for those without any of what tells lines apart, too."""
    return label(factors, names) or (f"no {names[-1].replace('_', ' ')}" if names else "this run")


def combinations(rows, names):
    """Labels of the rows' values of `names`, in the order of the factors' values."""
    orders = [in_order(row["factors"].get(n, "-") for row in rows) for n in names]
    keys = {tuple(row["factors"].get(n, "-") for n in names) for row in rows}
    return sorted(keys, key=lambda key: [order.index(v) for order, v in zip(orders, key)])


def split(rows, names):
    """(label, rows) of each combination of the values of `names`."""
    return [
        (label(dict(zip(names, key)), names), [r for r in rows if tuple(r["factors"].get(n, "-") for n in names) == key])
        for key in combinations(rows, names)
    ]


def layout_of(rows, apart=(), outer=()):
    """Lines are the innermost factors that have a colour for each value, panels the others; `apart` are for axes, `outer` for panels."""
    names = sorted(telling(rows, apart), key=lambda name: name not in outer)
    taken = 0
    for count in range(1, len(names) + 1):
        if len(combinations(rows, names[-count:])) > MOST_SERIES or (count > 1 and len(names) > count):
            break
        taken = count
    # With several factors the outermost is a panel, for lines of one panel are what is compared.
    if taken == len(names) and (taken > 1 or (names and names[0] in outer)):
        taken -= 1
    series_names = names[len(names) - taken :]
    panel_names = names[: len(names) - taken]
    panels = split(rows, panel_names) if panel_names else [("", rows)]
    series = [series_label(dict(zip(series_names, key)), series_names) for key in combinations(rows, series_names)] if series_names else ["this run"]
    return Layout(panels[:MOST_PANELS], list(dict.fromkeys(series)), series_names, max(0, len(panels) - MOST_PANELS))


def longest_line(rows, name):
    """The most values of a factor that any line over it has, all else being equal along it.

    Settings that advance together, as in [sweep.zip], are no axis: what changes from one to the next is not one thing.
    """
    names = telling(rows, apart=(name,))
    lines = [mine for _, mine in split(rows, names)] if names else [rows]
    return max((len({r["factors"].get(name) for r in mine}) for mine in lines if not set(varying(mine)) - {name, *FOLLOWS}), default=0)


def numeric(rows):
    """{name: values} of varying factors whose values are numbers ("-" aside), at least two of them."""
    found = {}
    for name, values in varying(rows).items():
        numbers = [v for v in values if v not in ("-", "")]
        if len(numbers) > 1 and all(number_of(v) is not None for v in numbers):
            found[name] = numbers
    return found
