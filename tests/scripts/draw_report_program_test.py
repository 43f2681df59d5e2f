"""scripts/draw_report as it is started, and its page in a browser: some minutes."""

import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = HERE.parent.parent / "scripts"
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE)]

import made_reports as made  # noqa: E402

CHROMIUM = shutil.which("chromium")
NAMESPACES = {"http://www.w3.org/1999/xlink", "http://www.w3.org/2000/svg", "http://www.w3.org/2000/xmlns/"}
# Asks the page, once all is drawn: what each chart holds, how many marks it shows, what it says of a mark, and what a click on its legend does.
QUESTION = """<script>
const until_drawn = setInterval(async () => {
  if (!document.documentElement.dataset.drawn) return;
  clearInterval(until_drawn);
  const told = {scheme: document.documentElement.dataset.drawn, paper: getComputedStyle(document.body).backgroundColor, charts: {}};
  for (const [name, view] of Object.entries(views)) {
    const drawing = document.getElementById(name + '-chart');
    const marks = drawing.querySelectorAll('svg [aria-roledescription$="mark"], svg path, svg rect');
    told.charts[name] = {marks: marks.length, paper: view.background(), points: view.data('points0')};
    const point = drawing.querySelector('.point_marks0 path');
    if (point) {
      const {left, top, width, height} = point.getBoundingClientRect();
      const at = {bubbles: true, clientX: left + width / 2, clientY: top + height / 2};
      for (const kind of ['mouseover', 'mousemove']) point.dispatchEvent(new MouseEvent(kind, at));
      told.charts[name].tip = document.getElementById('tip').hidden ? null : document.getElementById('tip').textContent;
      point.dispatchEvent(new MouseEvent('mouseout', at));
      told.charts[name].tip_after = document.getElementById('tip').hidden;
    }
    const entry = drawing.querySelector('.legend_symbols path');
    if (!entry) continue;
    entry.dispatchEvent(new MouseEvent('click', {bubbles: true}));
    await view.runAsync();
    told.charts[name].after_click = view.data('points0').length;
    told.charts[name].hidden = view.data('hidden');
  }
  const answer = document.createElement('pre');
  answer.id = 'told';
  answer.textContent = JSON.stringify(told);
  document.body.append(answer);
}, 50);
</script>"""


def draw(*arguments, **more):
    command = [sys.executable, "-B", str(SCRIPTS / "draw_report"), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, **more)


class Program(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.runs = made.all_runs(cls.folder / "runs")
        cls.done = draw(*cls.runs, "--out", cls.folder / "one")

    def page(self):
        return (self.folder / "one/report.html").read_text(encoding="utf-8")

    def test_the_same_runs_give_the_same_bytes(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))
        self.assertEqual(draw(*self.runs, "--out", self.folder / "two").returncode, 0)
        files = sorted(f.relative_to(self.folder / "one") for f in (self.folder / "one").rglob("*") if f.is_file())
        for file in files:
            self.assertEqual((self.folder / "one" / file).read_bytes(), (self.folder / "two" / file).read_bytes(), file)
        names = {f.stem for f in files}
        for kind in (
            "m11-t3-published",
            "m11-t3-threads",
            "m11-t3-overhead",
            "m11-t3-frames",
            "m11-t3-timeline-marbles",
            "m11-t8-published",
            "m11-t8-sweep-leaf-fps",
            "chunks-heat-chunk",
            "speed-bars-nanoseconds",
            "speed-speed-error",
            "m11-aa-speed-pixels",
            "overhead-metg",
        ):
            self.assertIn(kind, names)
        self.assertEqual({f.stem for f in files if f.suffix == ".svg"}, {f.stem for f in files if f.suffix == ".png"})

    def test_the_page_needs_no_other_file_and_can_be_sent_by_mail(self):
        text = self.page()
        self.assertLess(len(text.encode()), 3_000_000)
        head, _, _ = text.partition("<script")
        for asks in (r'<[^>]*\b(src|href)="(?!data:|#)', r"@import|url\("):
            self.assertIsNone(re.search(asks, head), asks)
        self.assertEqual(set(re.findall(r"https?://[^\"'` )]*", text)) - NAMESPACES, set())

    def test_every_link_has_its_target(self):
        text = self.page()
        targets = set(re.findall(r'\bid="([^"]*)"', text))
        links = set(re.findall(r'href="#([^"]*)"', text))
        self.assertTrue(links)
        self.assertEqual(links - targets, set())

    def test_a_folder_that_is_no_run_is_refused_and_nothing_is_written(self):
        done = draw(self.runs[0], self.folder, "--out", self.folder / "none")
        self.assertEqual(done.returncode, 2)
        self.assertIn("has no report.json", done.stderr)
        self.assertFalse((self.folder / "none").exists())

    def test_a_missing_tool_is_told_with_its_package(self):
        """With a PATH on which node alone is."""
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "node").symlink_to(shutil.which("node"))
        done = draw(self.runs[0], "--out", self.folder / "none", env=os.environ | {"PATH": str(tools)})
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, "draw_report: needs Debian's esbuild, librsvg2-bin; install it as root: apt-get install esbuild librsvg2-bin\n")
        self.assertFalse((self.folder / "none").exists())


@unittest.skipUnless(CHROMIUM, "Debian's chromium is missing: the page is not looked at in a browser")
class Browser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.runs = made.all_runs(cls.folder / "runs")
        assert draw(*cls.runs, "--out", cls.folder).returncode == 0
        asking = cls.folder / "asking.html"
        asking.write_text((cls.folder / "report.html").read_text(encoding="utf-8").replace("</body>", QUESTION + "</body>"), encoding="utf-8")
        cls.told, cls.said = {}, {}
        for scheme, setting in (("light", 1), ("dark", 0)):
            cls.told[scheme], cls.said[scheme] = cls.open(asking, setting)

    @classmethod
    def open(cls, file, setting):
        """(what the page told, what its console said), opened from its file without a network."""
        command = [
            CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={cls.folder / 'profile'}", "--host-resolver-rules=MAP * ~NOTFOUND",
            f"--blink-settings=preferredColorScheme={setting}", "--virtual-time-budget=60000", "--enable-logging=stderr", "--dump-dom", file.as_uri(),
        ]  # fmt: skip
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
        found = re.search(r'<pre id="told">(.*?)</pre>', done.stdout, re.S)
        console = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
        assert found, (console, done.stdout[-2000:])
        return json.loads(html.unescape(found[1])), console

    def test_the_console_stays_empty(self):
        self.assertEqual(self.said, {"light": [], "dark": []})

    def test_every_chart_is_drawn_with_its_marks(self):
        names = re.findall(r'<div class="drawing scroll" id="([^"]*)-chart"', (self.folder / "report.html").read_text(encoding="utf-8"))
        self.assertGreater(len(names), 12)
        for told in self.told.values():
            self.assertEqual(set(told["charts"]), set(names))
            for name in names:
                self.assertGreater(told["charts"][name]["marks"], 5, name)
                self.assertTrue(told["charts"][name]["points"], name)

    def test_the_page_and_its_charts_are_in_the_scheme_that_is_preferred(self):
        self.assertEqual({scheme: told["scheme"] for scheme, told in self.told.items()}, {"light": "light", "dark": "dark"})
        self.assertNotEqual(self.told["light"]["paper"], self.told["dark"]["paper"])
        for name, light in self.told["light"]["charts"].items():
            self.assertNotEqual(light["paper"], self.told["dark"]["charts"][name]["paper"], name)

    def test_what_a_chart_shows_are_the_values_of_the_report(self):
        """As the page holds them when it is drawn, against report.json."""
        report = json.loads((self.runs[0] / "report.json").read_text(encoding="utf-8"))
        told = {
            (r["factors"]["mode"], int(r["factors"]["threads"])): r["values"]["fps"] for r in report["rows"] if r["factors"]["scheduler"] != "serial"
        }
        points = self.told["light"]["charts"]["m11-t3-threads"]["points"]
        self.assertEqual({(p["s"], p["x"]) for p in points}, set(told))
        for p in points:
            estimate = told[p["s"], p["x"]]
            for drawn, value in ((p["y"], estimate["value"]), (p["low"], estimate["low"]), (p["high"], estimate["high"])):
                self.assertAlmostEqual(drawn / value, 1, places=5)

    def test_pointing_at_a_mark_tells_its_value_interval_and_count(self):
        charts = self.told["light"]["charts"]
        self.assertEqual(charts["m11-t3-threads"]["tip"], "low threads 1fps 7.76 [7.682, 7.838]samples 7")
        for name, chart in charts.items():
            if "tip" in chart:
                self.assertTrue(chart["tip"], name)
                self.assertTrue(chart["tip_after"], name)

    def test_a_click_on_the_legend_hides_its_series(self):
        charts = [chart for chart in self.told["light"]["charts"].values() if "after_click" in chart]
        self.assertGreater(len(charts), 4)
        for chart in charts:
            hidden = chart["hidden"][0]["value"]
            self.assertLess(chart["after_click"], len(chart["points"]))
            self.assertEqual(chart["after_click"], sum(p["s"] != hidden for p in chart["points"]))


if __name__ == "__main__":
    unittest.main()
