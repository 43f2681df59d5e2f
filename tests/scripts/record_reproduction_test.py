#!/usr/bin/python3
"""scripts/record_reproduction: what is kept of runs, and what is not."""
import pathlib
import shutil
import subprocess
import tarfile
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "record_reproduction"
PAPERS = ["config.toml", "machine.json", "plan.json"]


@unittest.skipUnless(shutil.which("xz"), "needs xz")
class RecordReproduction(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.into = self.folder / "kept"

    def run_of(self, name, records):
        run = self.folder / "runs" / name
        (run / "tables").mkdir(parents=True)
        for file in [*PAPERS, "report.json"]:
            (run / file).write_text(f"{file} of {name}", encoding="utf-8")
        (run / "records.jsonl").write_text(records, encoding="utf-8")
        for table in ("claims.md", "claims.csv", "scaling.md"):
            (run / "tables" / table).write_text(table, encoding="utf-8")

    def record(self):
        return subprocess.run([SCRIPT, self.folder / "runs", self.into], capture_output=True, text=True, check=False)

    def kept_of(self, name):
        with tarfile.open(self.into / name / "run.tar.xz") as archive:
            return sorted(archive.getnames())

    def test_records_are_kept_and_of_tables_those_of_claims(self):
        self.run_of("A", "{}\n")
        (self.folder / "runs" / "charts").mkdir()
        result = self.record()
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        self.assertEqual(self.kept_of("A"), [*PAPERS, "records.jsonl"])
        self.assertEqual([f.name for f in (self.into / "A" / "tables").iterdir()], ["claims.md"])
        self.assertEqual([f.name for f in self.into.iterdir()], ["A"])

    def test_of_records_that_are_too_large_the_report_is_kept_and_it_says_so(self):
        self.run_of("A", "{}\n")
        self.run_of("B", "x" * 11_000_000)
        result = self.record()
        self.assertEqual(result.stdout, "B: records are too large to keep; its report.json is kept\n")
        self.assertEqual(self.kept_of("A"), [*PAPERS, "records.jsonl"])
        self.assertEqual(self.kept_of("B"), [*PAPERS, "report.json"])

    def test_the_same_runs_give_the_same_bytes_and_what_was_kept_before_is_gone(self):
        self.run_of("A", "{}\n")
        self.record()
        first = (self.into / "A" / "run.tar.xz").read_bytes()
        (self.into / "old").mkdir()
        self.record()
        self.assertEqual((self.into / "A" / "run.tar.xz").read_bytes(), first)
        self.assertFalse((self.into / "old").exists())

    def test_a_folder_without_runs_changes_nothing(self):
        (self.folder / "runs").mkdir()
        self.into.mkdir()
        result = self.record()
        self.assertEqual(result.returncode, 1)
        self.assertIn("runs: no run with a report.json; scripts/reproduce writes them", result.stderr)
        self.assertTrue(self.into.exists())


if __name__ == "__main__":
    unittest.main()
