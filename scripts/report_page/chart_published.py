"""What a paper printed beside what was measured here, both normalised alike: side by side over threads, else in one panel a column."""

import dataclasses

from report_page.chart import Chart, estimate_text
from report_page.chart_threads import borders_of
from report_page.factors import number_of, telling, unit, unit_of
from report_page.layout import MOST_PANELS, numeric, series_label, split
from report_page.panel import Panel, Point, round_values, spread
from report_page.spec import panels_spec
from study_charts.numbers import short

PRINTED, OURS = "printed", "here"


def as_rows(published):
    """Cells of the printed table as rows of an experiment, so that the same layout fits."""
    return [{"factors": row["factors"], "values": {}, "cell": row} for row in published["rows"]]


def values_of(cell, normalised):
    """(printed number, our estimate), each None where there is none. `printed` is the text that the paper has."""
    if normalised:
        return cell["printed_normalised"], cell["ours_normalised"]
    return float(cell["printed"]), cell["ours"]


def printed_point(cell, series, x, normalised, tip):
    value, _ = values_of(cell, normalised)
    if value is None:
        return None
    pairs = [*tip, ["printed", cell["printed"]]]
    return Point(series, x, value, tip=pairs + ([["normalised", short(value, 4)]] if normalised else []))


def our_point(cell, series, x, normalised, tip):
    _, ours = values_of(cell, normalised)
    if not ours or ours["value"] is None:
        return None
    pairs = [*tip, ["here", estimate_text(cell["ours"])]]
    pairs += [["normalised", estimate_text(ours)]] if normalised else []
    return Point(series, x, ours["value"], ours["low"], ours["high"], pairs)


def of_ours_alone(rows, x, names):
    """Those of the factors that printed numbers do not depend on: the paper had one value of them, or did not tell."""
    alone = []
    for name in names:
        rest = [n for n in (x, *names) if n not in (name, *alone)]
        texts = {}
        for row in rows:
            texts.setdefault(tuple(row["factors"].get(n) for n in rest), set()).add(row["cell"]["printed"])
        if all(len(found) == 1 for found in texts.values()):
            alone.append(name)
    return alone


class Published:
    """The printed table of a run: `columns` are the factors of its numbers, `variants` those that only ours have."""

    def __init__(self, run):
        self.run, self.published = run, run.report["published"]
        self.rows = as_rows(self.published)
        self.machine = self.published["machine"]
        numbers = numeric(self.rows)
        asked = [name for name in self.published["rows_are"] if name in numbers]
        self.x = next(iter(asked or sorted(numbers, key=lambda n: -len(numbers[n]))), None)
        self.normalised = self.published["normalise"] != "none"
        if self.x:
            names = telling(self.rows, apart=(self.x,))
            self.variants = of_ours_alone(self.rows, self.x, names)
            self.columns = [n for n in names if n not in self.variants]

    def points(self, rows, make, series):
        """`make` is of printed or of our numbers, `series` a name for all, or a function of the row."""
        found = {}
        for row in rows:
            x = number_of(row["factors"].get(self.x, "-"))
            if x is not None:
                name = series if isinstance(series, str) else series(row)
                tip = [[name, ""], [self.x.replace("_", " "), row["factors"][self.x]]]
                found.setdefault((name, x), make(row["cell"], name, x, self.normalised, tip))
        return [p for p in found.values() if p is not None]

    def panel(self, title, points, **more):
        xs = sorted({p.x for p in points})
        quantity = self.published["quantity"]
        y_title = f"{quantity.replace('_', ' ')} (first row = 1)" if self.normalised else unit(quantity)
        more = {"log_y": spread([p.y for p in points]) > 30, "log_x": spread(xs) > 30} | more
        ticks = round_values(xs) if self.x == "threads" or len(xs) <= 8 else None
        return Panel(title, unit_of(self.x, self.rows), y_title, points, x_values=ticks, **more)

    def column_of(self, row):
        return series_label(row["factors"], self.columns)

    def column_names(self):
        return list(dict.fromkeys(self.column_of(row) for row in self.rows))

    def side_by_side(self):
        """Over threads: the printed figure, then ours, a panel a variant; each on its own machine, whose cores end where they do."""
        asked = [("as printed", self.points(self.rows, printed_point, self.column_of), self.machine["cores"], self.machine["pus"])]
        for name, mine in split(self.rows, self.variants) if self.variants else [("", self.rows)]:
            title = f"here: {name}" if name else "here"
            asked.append((title, self.points(mine, our_point, self.column_of), self.run.cores, self.run.pus))
        asked = [panel for panel in asked if panel[1]]
        # What is normalised can be held against each other by eye.
        highest = [0, max(p.y if p.high is None else p.high for _, points, *_ in asked for p in points) * 1.08] if self.normalised else None
        panels = []
        for title, points, cores, pus in asked:
            borders = borders_of(cores, pus, max(p.x for p in points)) if cores and pus else []
            where = title + (f" ({cores} cores, {pus} processors)" if cores and pus else "")
            more = {"y_domain": highest, "log_y": False} if highest else {}
            panels.append(self.panel(where, points, borders=borders, width=380, height=260, **more))
        return panels, self.column_names(), 2

    def together(self):
        """One panel a column of the table: printed and ours in it. Columns of which we have nothing are left out where others have."""
        panels, series = [], [PRINTED]
        for title, mine in split(self.rows, self.columns) if self.columns else [("", self.rows)]:
            points = self.points(mine, printed_point, PRINTED)
            for name, ours in split(mine, self.variants) if self.variants else [("", mine)]:
                series.append(f"{OURS}, {name}" if name else OURS)
                points += self.points(ours, our_point, series[-1])
            if points:
                panels.append(self.panel(title, points))
        measured = [panel for panel in panels if any(p.series != PRINTED for p in panel.points)]
        panels = measured or panels
        width = {1: 420, 2: 320}.get(len(panels), 230)
        panels = [dataclasses.replace(panel, width=width, height=round(width * 0.7)) for panel in panels]
        return panels[:MOST_PANELS], list(dict.fromkeys(series)), min(4, max(1, len(panels)))


def farthest(published):
    """The cell in which ours is farthest from the printed number, as a factor, and its words; None without any."""
    found = []
    for row in published.rows:
        printed, ours = values_of(row["cell"], published.normalised)
        if printed and ours and ours["value"] and ours["value"] > 0:
            ratio = ours["value"] / printed
            found.append((max(ratio, 1 / ratio), ratio, row))
    return max(found, key=lambda f: f[0]) if found else None


def title_of(published):
    far = farthest(published)
    if far is None:
        return "As printed; nothing of it was measured here"
    _, ratio, row = far
    where = ", ".join(f"{n.replace('_', ' ')} {v}" for n, v in row["factors"].items() if n in (published.x, *published.columns, *published.variants))
    return f"Beside the printed numbers, ours are farthest off at {where}: {short(ratio)} times" + (
        " (both normalised)" if published.normalised else ""
    )


def published_chart(run):
    """None without printed numbers that have a factor to be drawn over."""
    if not run.report["published"] or not run.report["published"]["rows"]:
        return None
    published = Published(run)
    if not published.x:
        return None
    panels, series, columns = published.side_by_side() if published.x == "threads" else published.together()
    if not panels:
        return None
    base = "Each column is divided by its own first row, for the machines differ." if published.normalised else "Not normalised."
    text = f"{base} Printed numbers: {published.published['file']}; bars are 95 % intervals of ours."
    spec = panels_spec(panels, series, "numbers" if series[0] == PRINTED else ", ".join(published.columns), columns, legend=len(series) > 1)
    return Chart("published", title_of(published), text.strip(), spec)
