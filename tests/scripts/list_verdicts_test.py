#!/usr/bin/python3
"""scripts/list_verdicts: a line a claim, from the reports of runs alone."""
import json
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "list_verdicts"


def claim(name, published, ours):
    def side(verdict):
        return {"verdict": verdict, "sentence": f"found {verdict}"}

    return {"id": name, "text": f"says {name}", "published": side(published), "ours": side(ours)}


class ListVerdicts(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_of(self, experiment, claims):
        folder = pathlib.Path(self.folder.name) / experiment
        folder.mkdir()
        report = {"schema": 1, "experiment": experiment, "title": f"about {experiment}", "claims": claims}
        (folder / "report.json").write_text(json.dumps(report), encoding="utf-8")
        return folder

    def listed(self, *folders):
        return subprocess.run([SCRIPT, *folders], capture_output=True, text=True, check=False)

    def test_each_claim_has_a_line_in_the_order_of_the_runs(self):
        first = self.run_of("B", [claim("x", "holds in the source", "reproduced")])
        second = self.run_of("A", [claim("y", "not in a table", "not reproduced"), claim("z", "not in a table", "reproduced")])
        result = self.listed(first, second)
        self.assertEqual(result.returncode, 0, result.stderr)
        lines = [line.split("  ") for line in result.stdout.splitlines()]
        cells = [[cell.strip() for cell in line if cell.strip()] for line in lines]
        self.assertEqual(cells[2:5], [["B", "x", "holds in the source", "reproduced"],
                                      ["A", "y", "not in a table", "not reproduced"],
                                      ["A", "z", "not in a table", "reproduced"]])
        self.assertIn("3 claims: 2 reproduced, 1 not reproduced", result.stdout)

    def test_counts_have_a_line_for_each_experiment_and_no_column_of_a_verdict_that_nobody_got(self):
        first = self.run_of("B", [claim("x", "-", "reproduced"), claim("y", "-", "cannot be tested here"), claim("z", "-", "reproduced")])
        second = self.run_of("A", [claim("x", "-", "cannot be tested here")])
        lines = self.listed("--counts", first, second).stdout.splitlines()
        cells = [[cell.strip() for cell in line.split("  ") if cell.strip()] for line in lines]
        self.assertEqual(cells[0], ["experiment", "about", "reproduced", "cannot be tested here"])
        self.assertEqual(cells[2:4], [["B", "about B", "2", "1"], ["A", "about A", "1"]])
        self.assertEqual(lines[-1], "4 claims: 2 reproduced, 2 cannot be tested here")

    def test_what_was_found_of_some_claims_is_told_as_asked(self):
        run = self.run_of("B", [claim("x", "not in a table", "reproduced"), claim("y", "holds in the source", "not reproduced")])
        result = self.listed("--claim", "B/y", "--claim", "B/x", run)
        self.assertEqual(result.stdout.splitlines(), ["B/y: says y", "  holds in the source: found holds in the source",
                                                      "  here not reproduced: found not reproduced",
                                                      "B/x: says x", "  here reproduced: found reproduced"])
        wrong = self.listed("--claim", "B/z", run)
        self.assertEqual((wrong.returncode, wrong.stdout), (1, ""))
        self.assertIn("no claim B/z in these runs; they have: B/x, B/y", wrong.stderr)

    def test_a_folder_without_a_report_is_told_with_what_writes_it(self):
        folder = pathlib.Path(self.folder.name)
        result = self.listed(folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"{folder}/report.json: no report of a run", result.stderr)
        self.assertIn(f"`raysweep report {folder}` writes it", result.stderr)
        self.assertEqual(result.stdout, "")


if __name__ == "__main__":
    unittest.main()
