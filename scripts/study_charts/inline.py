"""Pictures to stand within a page: small, in the page's colours, and with ids of their own."""

import re

from study_charts.colours import DARK


class Inline:
    """Pictures of one page. What many of their lines share becomes a class of the page's style sheet."""

    def __init__(self):
        self._classes = {}

    def picture(self, svg, name):
        """The <svg> element alone; `name` keeps its ids apart from those of other pictures."""
        svg = svg[svg.index("<svg") :]
        svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.S)
        svg = re.sub(r'<g id="[^"]*"', "<g", svg)  # nothing refers to groups
        svg = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{name}-", svg)
        svg = re.sub(r' transform="rotate\(-0 [^)]*\)"', "", svg)
        svg = re.sub(r"\s*\n\s*", "", svg)
        svg = re.sub(r"(\d+\.\d{2})\d+", r"\1", svg)
        svg = re.sub(r'width="[\d.]+pt" height="[\d.]+pt"', 'class="chart"', svg, count=1)
        return re.sub(r'style="([^"]*)"', self._class_of, svg)

    def _class_of(self, match):
        number = self._classes.setdefault(match[1], len(self._classes))
        return f'class="s{number}"'

    def style(self):
        """The style sheet of all pictures so far, in the variables of `variables`."""
        text = "".join(f".s{number}{{{style}}}" for style, number in self._classes.items())
        for colour in DARK:
            text = text.replace(colour, f"var(--c{colour[1:]})")
        return text.replace("; ", ";").replace(": ", ":")
