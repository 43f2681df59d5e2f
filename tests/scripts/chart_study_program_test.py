"""scripts/chart_study as it is started: tens of seconds, for it draws."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = HERE.parent.parent / "scripts"
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE)]

import made_records as made  # noqa: E402


class Program(unittest.TestCase):
    METHODS = ("wald", "woop_watertight")

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def run_it(self, *arguments):
        command = [sys.executable, "-B", str(SCRIPTS / "chart_study"), *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def write_all(self):
        records = {
            "accuracy": made.accuracy_records(self.METHODS), "kernel": made.kernel_records(self.METHODS),
            "pixels": [*made.pixel_records(self.METHODS), *made.sampling_records()], "atlas": made.atlas_records(self.METHODS),
        }  # fmt: skip
        return [made.write_run(self.folder / kind, found) for kind, found in records.items()]

    def test_the_same_runs_give_the_same_bytes_and_a_page_that_needs_no_other_file(self):
        given = self.write_all()
        for out in ("one", "two"):
            done = self.run_it(*given, "--out", self.folder / out)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        files = sorted(f.relative_to(self.folder / "one") for f in (self.folder / "one").rglob("*") if f.is_file())
        for file in files:
            self.assertEqual((self.folder / "one" / file).read_bytes(), (self.folder / "two" / file).read_bytes(), file)
        names = {f.stem for f in files}
        self.assertLessEqual({"report", "cost-error", "cost-misses", "mesh", "failures-false-misses", "price", "speed-bars", "speed-hit-rate", "pixels-wrong", "pixels-flip", "sampling-edges", "map-size-offset", "difficulty-error-float"}, names)  # fmt: skip
        page = (self.folder / "one/report.html").read_text(encoding="utf-8")
        self.assertNotRegex(page, r'(src|href)="(?!data:|#)')
        self.assertLess(len(page.encode()), 3_000_000)
        self.assertIn("prefers-color-scheme: dark", page)

    def test_one_kind_alone_gives_a_report_that_says_what_it_lacks(self):
        for kind, given in zip(("accuracy", "kernel", "pixels", "atlas"), self.write_all()):
            done = self.run_it(given, "--out", self.folder / "out")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout.count("left out: No run of the kind"), 3, done.stdout)
            self.assertNotIn(f"of the kind “{kind}”", done.stdout)

    def test_a_folder_that_is_no_run_is_refused_and_nothing_is_written(self):
        done = self.run_it(self.folder, "--out", self.folder / "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn("records.jsonl: cannot be read", done.stderr)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
