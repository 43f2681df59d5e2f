"""How Vega draws: one look in two schemes. Specifications name no colour: they ask for "ink", "faint", … or a place in the palette."""

from study_charts.colours import COLOURS, DARK, FAINT, INK, PAPER, RAIL

# As many series as have colours and markers of their own.
MOST_SERIES = len(COLOURS)
SHAPES = ["circle", "square", "diamond", "triangle-up", "triangle-down", "cross", "triangle-right", "triangle-left"]
# From little to much, by lightness alone, so that it reads without colours.
RAMPS = {"light": ["#f3f7fa", "#9ecae8", "#0077bb", "#06395a"], "dark": ["#1c242b", "#1f5a85", "#4aa3e0", "#d9eefc"]}
PAGE_FONT, FILE_FONT = "system-ui, sans-serif", "DejaVu Sans, sans-serif"


def config(scheme, font):
    """Vega's configuration of the scheme "light" or "dark"."""

    def of(colour):
        return DARK[colour] if scheme == "dark" else colour

    ink, faint, rail, paper = of(INK), of(FAINT), of(RAIL), of(PAPER)
    text = {"labelFont": font, "titleFont": font, "labelColor": ink, "titleColor": ink, "labelFontSize": 11, "titleFontSize": 11}
    return {
        "background": paper,
        "signals": [{"name": n, "value": v} for n, v in (("ink", ink), ("faint", faint), ("rail", rail), ("paper", paper), ("first", of(COLOURS[0])), ("second", of(COLOURS[1])))],
        "axis": text | {"titleFontWeight": "normal", "domainColor": faint, "tickColor": faint, "gridColor": rail, "titlePadding": 6, "labelLimit": 260},
        "legend": text | {"titleFontWeight": "bold", "symbolSize": 70, "labelLimit": 300, "titleLimit": 300, "rowPadding": 4},
        "title": {"font": font, "color": ink, "fontSize": 12, "fontWeight": "bold", "anchor": "start", "frame": "group", "offset": 8, "subtitleFont": font, "subtitleColor": ink},
        "text": {"font": font, "fontSize": 10, "fill": ink},
        "range": {"category": [of(c) for c in COLOURS], "symbol": SHAPES, "ramp": RAMPS[scheme], "heatmap": RAMPS[scheme]},
    }  # fmt: skip
