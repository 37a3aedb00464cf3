"""bench/table.py without measuring: its medians, ratios and layout, and what it does without a peer."""

import json
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "bench"))

import commands  # noqa: E402
import figures  # noqa: E402
import table  # noqa: E402
import works  # noqa: E402
from figures import Sample  # noqa: E402
from works import Row, Work  # noqa: E402

FLOOR = Row("floor", "floor", benchmark="floor", program="p")
OURS = Row("ours", "ours", benchmark="ours", program="p")
PAIR = Row("ours, 2 threads", "ours", threads=2, benchmark="pair", program="p")
SLOW = Row("slow", "peer", benchmark="slow", program="p")
FAST = Row("fast", "peer", command=("fast",))
WORK = Work("W", "a work", (FLOOR, OURS, PAIR, SLOW, FAST), pixels=1_000_000)
SAMPLES = {FLOOR: [Sample(1, 1)], OURS: [Sample(9, 2)], PAIR: [Sample(1.5, 3)],
           SLOW: [Sample(90, 8)], FAST: [Sample(4, 1, mib=20, out_mb=.5)]}


class Medians(unittest.TestCase):
    def test_figure_by_figure_and_without_what_was_not_measured(self):
        median = figures.median_of([Sample(1, 30, wrong=7), Sample(2, 10), Sample(9, 20)])
        self.assertEqual(median, Sample(2, 20, wrong=7))


class Ratios(unittest.TestCase):
    def cells(self):
        return {who: dict(zip(figures.COLUMNS, cells))
                for who, cells in figures.lines_of(WORK, SAMPLES)}

    def test_processor_time_of_one_thread_in_a_program_else_wall_time(self):
        pixels = {who: cells["ns/px"] for who, cells in self.cells().items()}
        self.assertEqual(pixels, {"floor": 1, "ours": 2, "ours, 2 threads": 1.5, "slow": 8, "fast": 4})

    def test_floor_of_as_many_threads(self):
        cells = self.cells()
        self.assertEqual(cells["ours"]["x floor"], 2)
        self.assertIsNone(cells["ours, 2 threads"]["x floor"])

    def test_peers_to_the_fastest_of_them(self):
        cells = self.cells()
        self.assertEqual([cells[who]["x peer"] for who in ("ours", "slow", "fast")], [.5, 2, 1])
        self.assertIsNone(cells["floor"]["x peer"])

    def test_without_peers_there_is_no_ratio(self):
        (_, cells), = figures.lines_of(WORK, {OURS: SAMPLES[OURS], SLOW: []})
        self.assertEqual(cells[figures.COLUMNS.index("x peer")], None)


class Layout(unittest.TestCase):
    def test_three_digits(self):
        numbers = {0: "0", .0731: ".073", .5: ".500", 1: "1.00", 9.996: "10.0", 99.96: "100",
                   13607: "13607", 1e-5: "1e-05", None: ""}
        for number, text in numbers.items():
            self.assertEqual(figures.short(number), text)

    def test_text_has_aligned_columns_and_fits(self):
        lines = figures.as_text([WORK], SAMPLES).splitlines()
        fast = next(line for line in lines if line.startswith("  fast"))
        self.assertEqual(fast.index("20.0") + 4, lines[0].index("MiB") + 3)
        self.assertLessEqual(max(map(len, lines)), figures.WIDTH)

    def test_works_without_rows_are_left_out(self):
        self.assertNotIn("a work", figures.as_text([WORK], {}))
        self.assertEqual(figures.as_data([WORK], {}), [])

    def test_markdown_rows_have_every_column(self):
        lines = figures.as_markdown([WORK], SAMPLES).splitlines()
        self.assertEqual({line.count("|") for line in lines}, {len(figures.COLUMNS) + 3})

    def test_section_takes_the_place_of_the_last_one(self):
        page = "a\n<!-- table: begin -->\nold\n<!-- table: end -->\nb\n"
        self.assertEqual(figures.with_section(page, "table", "new\n"), page.replace("old", "new"))
        with self.assertRaises(ValueError):
            figures.with_section("a\n", "table", "new")

    def test_readme_has_the_section(self):
        page = (ROOT / "bench/README.md").read_text(encoding="utf-8")
        self.assertIn("new", figures.with_section(page, "table", "new"))


class Measuring(unittest.TestCase):
    """With a program that prints what Google Benchmark would."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.tristim = pathlib.Path(scratch.name) / "tristim"
        results = [{"name": "ours/process_time/real_time", "time_unit": "us", "real_time": 1000.0,
                    "cpu_time": 1500.0, "items_per_second": works.PICTURE / 2 * 1000}]
        program = pathlib.Path(scratch.name) / "bench/p"
        program.parent.mkdir()
        program.write_text(f"#!/bin/sh\necho '{json.dumps({'benchmarks': results})}'\n")
        program.chmod(0o755)

    def rounds(self, *rows):
        rounds = table.Rounds(self.tristim, rows, .1)
        rounds.run_programs()
        rounds.run_commands()
        return rounds

    def test_time_is_that_of_the_works_pixels(self):
        rounds = self.rounds(OURS)
        self.assertEqual(rounds.samples[OURS], [Sample(2.0, 3.0)])
        self.assertFalse(rounds.failed)

    def test_a_peer_that_is_not_there_is_told_and_no_failure(self):
        rounds = self.rounds(OURS, SLOW, FAST, Row("sh", "peer", command=("false",)))
        self.assertEqual(list(rounds.samples), [OURS])
        self.assertEqual(rounds.notes, ["left out: slow: bench/p has no slow here",
                                        "left out: fast: fast is not installed",
                                        "left out: sh: false fails"])
        self.assertFalse(rounds.failed)

    def test_ours_that_is_not_there_is_a_failure(self):
        self.assertTrue(self.rounds(FLOOR, PAIR).failed)

    def test_commands_have_their_memory_and_the_size_of_what_they_write(self):
        out = self.tristim.parent / "out"
        sample = commands.measure((sys.executable, "-c", f"x = bytearray(1 << 28); open({str(out)!r}, "
                                   "'wb').write(bytes(3000))"), out)
        self.assertGreater(sample.mib, 256)
        self.assertEqual(sample.out_mb, .003)

    def test_rounds_end_in_time(self):
        class Nothing:
            def run_programs(self):
                pass
            run_commands = run_programs
        self.assertEqual(table.run_rounds(Nothing(), 60, 3), 3)
        self.assertEqual(table.run_rounds(Nothing(), -1, 3), 1)


class Lists(unittest.TestCase):
    def setUp(self):
        self.works = works.IN_PROCESS + commands.works("tristim")

    def test_rows_are_told_apart_and_fit(self):
        self.assertEqual(len({work.name for work in self.works}), len(self.works))
        for work in self.works:
            names = [row.who for row in work.rows]
            self.assertEqual(len(set(names)), len(names), work.name)
            self.assertLess(max(map(len, names)), figures.NAME_WIDTH - 2, work.name)

    def test_every_row_is_a_measurement_or_a_command(self):
        for row in (row for work in self.works for row in work.rows):
            self.assertNotEqual(bool(row.benchmark), bool(row.command), row)
            if row.program:
                self.assertTrue((ROOT / "bench" / f"{row.program}.cpp").exists(), row)


if __name__ == "__main__":
    unittest.main()
