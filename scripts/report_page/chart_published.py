"""What a paper printed beside what was measured here, both normalised alike: side by side over threads, else in one panel a column."""

from report_page.chart import Chart, estimate_text
from report_page.chart_threads import borders_of
from report_page.factors import number_of, unit, unit_of
from report_page.layout import layout_of, numeric
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


class Published:
    """The printed table of a run, and how it is laid out."""

    def __init__(self, run):
        self.run, self.published = run, run.report["published"]
        self.rows = as_rows(self.published)
        self.machine = self.published["machine"]
        numbers = numeric(self.rows)
        asked = [name for name in self.published["rows_are"] if name in numbers]
        self.x = next(iter(asked or sorted(numbers, key=lambda n: -len(numbers[n]))), None)
        self.normalised = self.published["normalise"] != "none"
        self.layout = layout_of(self.rows, apart=(self.x,)) if self.x else None

    def at(self, row):
        return number_of(row["factors"].get(self.x, "-"))

    def points(self, rows, make, name):
        """`name(row)` is the series; `make` is of printed or of our numbers."""
        found = []
        for row in rows:
            if self.at(row) is not None:
                series = name(row)
                tip = [[series, ""], [self.x.replace("_", " "), row["factors"][self.x]]]
                found.append(make(row["cell"], series, self.at(row), self.normalised, tip))
        return [p for p in found if p is not None]

    def panel(self, title, points, **more):
        xs = sorted({p.x for p in points})
        quantity = self.published["quantity"]
        y_title = f"{quantity.replace('_', ' ')} (first row = 1)" if self.normalised else unit(quantity)
        more = {"log_y": spread([p.y for p in points]) > 30} | more
        return Panel(
            title,
            unit_of(self.x, self.rows),
            y_title,
            points,
            log_x=spread(xs) > 30,
            x_values=round_values(xs) if self.x == "threads" or len(xs) <= 8 else None,
            **more,
        )

    def side_by_side(self):
        """Over threads: each on its own machine, whose cores end where they do."""
        panels, series = [], self.layout.series_of
        for title, rows in self.layout.panels:
            printed, ours = self.points(rows, printed_point, series), self.points(rows, our_point, series)
            highest = [0, max(p.high if p.high is not None else p.y for p in printed + ours) * 1.08]
            head = title + ": " if title else ""
            for name, points, cores, pus in (
                ("as printed", printed, self.machine.get("cores"), self.machine.get("pus")),
                ("here", ours, self.run.cores, self.run.pus),
            ):
                if points:
                    borders = borders_of(cores, pus, max(p.x for p in points)) if cores and pus else []
                    where = f"{head}{name}" + (f" ({cores} cores, {pus} processors)" if cores and pus else "")
                    panels.append(self.panel(where, points, borders=borders, width=380, height=260, y_domain=highest, log_y=False))
        return panels, self.layout.series, 2

    def together(self):
        """One panel a column of the table: printed and ours in it."""
        every = sorted({self.layout.series_of(row) for row in self.rows}, key=self.layout.series.index)
        panels = []
        for title, rows in self.layout.panels:
            for series in every:
                mine = [r for r in rows if self.layout.series_of(r) == series]
                points = self.points(mine, printed_point, lambda _: PRINTED) + self.points(mine, our_point, lambda _: OURS)
                if points:
                    name = ", ".join(t for t in (title, series if series != "this run" else "") if t)
                    panels.append(self.panel(name, points, width=230, height=180))
        return panels, [PRINTED, OURS], min(4, max(1, len(panels)))


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
    where = ", ".join(f"{n.replace('_', ' ')} {v}" for n, v in row["factors"].items() if n in (published.x, *published.layout.series_names))
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
    text = f"{base} Printed numbers: {published.published['file']}; bars are 95 % intervals of ours. {published.layout.sentence()}"
    spec = panels_spec(panels, series, "numbers" if series == [PRINTED, OURS] else published.layout.legend_title(), columns, legend=len(series) > 1)
    return Chart("published", title_of(published), text.strip(), spec)
