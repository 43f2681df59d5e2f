"""An experiment's main quantity over a factor of numbers: subpixels, lights, depth, leaf, chunks a thread, length, …"""

from report_page.chart import Chart, estimate_text, few_enough, main_quantity, point_of, samples_sentence
from report_page.factors import number_of, telling, unit, unit_of
from report_page.layout import layout_of, longest_line, numeric
from report_page.panel import Panel, spread
from report_page.spec import panels_spec

FEWEST = 3  # values that make a line worth drawing
# Of what is the better the larger it is.
LARGER_IS_BETTER = {"fps", "speedup", "speedup_one", "quality"}
# They follow from how a picture is made, and are no axis.
NO_AXIS = {"threads", "seed", "height", "bytes", "branches", "rays_at_once", "triangles_at_once"}


def sweep_factors(rows):
    """Factors of numbers that rows cannot be told without, those with most values first."""
    numbers = {name: values for name, values in numeric(rows).items() if name not in NO_AXIS and len(values) >= FEWEST}
    return sorted((n for n in numbers if n in telling(rows) and longest_line(rows, n) >= FEWEST), key=lambda n: -len(numbers[n]))


def sweep_chart(run, x, quantity):
    """None where fewer than three values of `x` have the quantity."""
    rows = [r for r in run.report["rows"] if number_of(r["factors"].get(x, "-")) is not None and quantity in r["values"]]
    if len({r["factors"][x] for r in rows}) < FEWEST:
        return None
    layout, raw = layout_of(rows, apart=(x,)), few_enough(rows, quantity)
    all_x = sorted({number_of(r["factors"][x]) for r in rows})
    panels, width = [], {1: 420, 2: 320}.get(len(layout.panels), 240)
    for title, mine in layout.panels:
        points = [p for r in mine if (p := point_of(r, quantity, number_of(r["factors"][x]), layout.series_of(r), raw, (x,)))]
        log_y = spread([p.y for p in points]) > 12
        panels.append(Panel(
            title, unit_of(x, rows), unit(quantity), points, log_x=spread(all_x) > 30, log_y=log_y,
            x_values=all_x if len(all_x) <= 8 else None, width=width, height=round(width * 0.65),
        ))  # fmt: skip
    best = (max if quantity in LARGER_IS_BETTER else min)(rows, key=lambda r: r["values"][quantity]["value"])
    who = layout.series_of(best)
    by = f", {who}" if who != "this run" else ""
    most = "Most" if quantity in LARGER_IS_BETTER else "Least"
    title = f"{most} {unit(quantity)} at {x.replace('_', ' ')} {best['factors'][x]}{by}: {estimate_text(best['values'][quantity])}"
    text = f"{samples_sentence(rows, quantity)} {layout.sentence()}".strip()
    columns = min(len(panels), 3 if len(panels) < 4 else 4)
    return Chart(
        f"sweep-{x.replace('_', '-')}-{quantity.replace('_', '-')}",
        title,
        text,
        panels_spec(panels, layout.series, layout.legend_title(), columns, legend=len(layout.series) > 1),
    )


def sweep_charts(run, quantity=None):
    """Of the factor with most values, the main quantity or the one given."""
    rows = [r for r in run.report["rows"] if r["values"]]
    quantity = quantity or main_quantity(rows)
    factors = sweep_factors(rows)
    return [chart for x in factors[:1] if quantity and (chart := sweep_chart(run, x, quantity))]
