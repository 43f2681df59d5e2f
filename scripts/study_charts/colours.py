"""The colours of all charts and pages, in the light and in the dark."""

# What is drawn in these colours in the light becomes a variable of the page's style. Tol's vibrant scheme (Paul Tol,
# "Colour schemes", 2021), told apart by the colour-blind, its greys replaced; the second colour is for dark paper.
INK, FAINT, PAPER, RAIL = "#1b1f24", "#8a9199", "#fefefe", "#e9ecef"
COLOURS = ("#0077bb", "#ee7733", "#009988", "#cc3311", "#aa4fc4", "#33a5dd", "#b08d12", "#ee3377")
DARK = {
    INK: "#e6e8ea",
    FAINT: "#7d858d",
    PAPER: "#15181c",
    RAIL: "#262b31",
    "#0077bb": "#4aa3e0",
    "#ee7733": "#f29254",
    "#009988": "#2fc0ae",
    "#cc3311": "#ea6a4c",
    "#aa4fc4": "#c583da",
    "#33a5dd": "#7cc8ee",
    "#b08d12": "#d4b13c",
    "#ee3377": "#f56d9c",
}


def variables(dark):
    """The colours of a scheme as a style sheet has them."""
    return "".join(f"--c{colour[1:]}:{DARK[colour] if dark else colour};" for colour in DARK)
