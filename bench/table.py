#!/usr/bin/env python3
"""One table: tristim's kernels, the same work by other libraries and commands, and what memory allows.

All take turns, round by round, so that a drift of the machine meets all; the table has medians. Ratios
are of processor time where one thread works inside of a program, else of wall time: "x floor" to what
memory allows, "x peer" to the fastest of the others; ns/px likewise, a pixel. MiB is peak memory, MB the size of the result, wrong the
number of wrong codes among the 2^24 + 1 lights i/2^24. A peer that is not installed is left out.
"""

import argparse
import contextlib
import datetime
import json
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile
import time

import commands
import figures
import works

README = pathlib.Path(__file__).resolve().parent / "README.md"
MOST_ROUNDS = 9


class Rounds:
    """Measures rows, again and again; what could not be measured is said once."""

    def __init__(self, tristim, rows, min_time):
        self.programs = tristim.parent / "bench"
        self.min_time = min_time
        self.samples = {row: [] for row in rows}
        self.notes = []
        self.failed = False

    def note(self, text):
        if text not in self.notes:
            self.notes.append(text)

    def leave_out(self, row, why):
        self.note(f"left out: {row.who}: {why}")
        self.failed = self.failed or row.kind == "ours"
        del self.samples[row]

    def run_programs(self):
        by_program = {}
        for row in self.samples:
            if row.program:
                by_program.setdefault(row.program, []).append(row)
        for program, rows in by_program.items():
            counting = {row.wrong for row in rows if row.wrong and not self.samples[row]}
            found = run_program(self.programs / program, {row.benchmark for row in rows} | counting,
                                self.min_time)
            for row in rows:
                if row.benchmark not in found:
                    self.leave_out(row, f"bench/{program} has no {row.benchmark} here")
                    continue
                counted = found.get(row.wrong, {}).get("wrong")
                self.samples[row].append(sample_of(found[row.benchmark], row, counted))

    def run_commands(self):
        for row in [row for row in self.samples if row.command]:
            if missing := commands.missing(row):
                self.leave_out(row, f"{missing} is not installed")
            elif (sample := commands.measure(row.command, row.output)) is None:
                self.leave_out(row, f"{' '.join(map(str, row.command))} fails")
            else:
                self.samples[row].append(sample)


def run_program(program, names, min_time):
    """The results of a program's measurements of these names, by name."""
    pattern = "|".join(re.sub(r"([][.^$|()*+?{}\\])", r"\\\1", name) for name in sorted(names))
    if not program.exists():
        return {}
    run = subprocess.run(
        [program, f"--benchmark_filter=^({pattern})(/iterations:1)?(/process_time)?(/real_time)?$",
         f"--benchmark_min_time={min_time}", "--benchmark_format=json"],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    if run.returncode != 0:
        return {}
    results = json.loads(run.stdout or "{}").get("benchmarks", [])
    return {re.sub("(/iterations:1|/process_time|/real_time)+$", "", result["name"]): result
            for result in results if not result.get("error_occurred")}


def sample_of(result, row, wrong):
    """A measurement of Google Benchmark, of as many pixels as the work has."""
    to_ms = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}[result["time_unit"]]
    wall, cpu = result["real_time"] * to_ms, result["cpu_time"] * to_ms
    scale = 1
    if "items_per_second" in result:
        seconds = (wall if result["name"].endswith("/real_time") else cpu) / 1e3
        scale = row_pixels(row) / (result["items_per_second"] * seconds)
    return figures.Sample(wall * scale, cpu * scale, wrong=wrong)


def row_pixels(row):
    return next((work.pixels for work in works.IN_PROCESS if row in work.rows and work.pixels),
                works.PICTURE)


def machine():
    """Date, processor, system and how busy it is, in a line."""
    model = platform.machine()
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        model = next((line.split(":")[1].strip() for line in file if line.startswith("model name")),
                     model)
    system = platform.freedesktop_os_release().get("PRETTY_NAME", platform.system())
    today = datetime.date.today().isoformat()
    return f"{today}, {os.cpu_count()} x {model}, {system}, load {os.getloadavg()[0]:.1f}"


def expression(text):
    try:
        return re.compile(text)
    except re.error as error:
        raise argparse.ArgumentTypeError(f"{text!r}: {error}") from error


def options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tristim", help="the command, with bench/ beside it: build/release/bin/tristim")
    parser.add_argument("--quick", action="store_true",
                        help="one round, without what takes long: a minute or two")
    parser.add_argument("--minutes", type=float, default=9,
                        help=f"begin no round that would end later; default: 9, {MOST_ROUNDS} rounds "
                             "at most")
    parser.add_argument("--only", metavar="WORDS", type=expression, default="",
                        help="the works whose name has this regular expression in it: 'W1|palette'")
    parser.add_argument("--markdown", action="store_true", help="print the table as Markdown")
    parser.add_argument("--json", action="store_true", help="print every measurement as JSON")
    parser.add_argument("--readme", action="store_true",
                        help="also put the table into bench/README.md")
    asked = parser.parse_args()
    asked.tristim = pathlib.Path(asked.tristim).resolve()
    if not (asked.tristim.parent / "bench").is_dir():
        parser.error(f"{asked.tristim} has no bench/ beside it: build the target `bench`")
    if asked.readme and asked.only.pattern:
        parser.error("--readme wants the whole table, not --only a part")
    return asked


def run_rounds(rounds, limit, most):
    """Rounds until the next one would end after `limit` seconds; at least one. Returns how many."""
    start = time.monotonic()
    for done in range(1, most + 1):
        rounds.run_programs()
        rounds.run_commands()
        spent = time.monotonic() - start
        print(f"round {done}: {spent / done:.0f} s each", file=sys.stderr)
        if spent * (done + 1) / done > limit:
            break
    return done


def report(asked, head, listed, rounds):
    notes = "".join(f"{note}\n" for note in rounds.notes)
    if asked.json:
        print(json.dumps({"machine": head, "notes": rounds.notes,
                          "works": figures.as_data(listed, rounds.samples)}, indent=1))
    else:
        lay_out = figures.as_markdown if asked.markdown else figures.as_text
        print(f"{head}\n\n{lay_out(listed, rounds.samples)}\n{notes}", end="")
    if asked.readme:
        text = f"{head}.\n\n```\n{figures.as_text(listed, rounds.samples)}```\n\n{notes}"
        page = README.read_text(encoding="utf-8")
        README.write_text(figures.with_section(page, "table", text), encoding="utf-8")


def main():
    asked = options()
    start = time.monotonic()
    sizes = [size for size, (width, _) in works.GROWTH.items() if not asked.quick or width <= 3840]
    listed = [work for work in works.IN_PROCESS + commands.works(asked.tristim, sizes)
              if asked.only.search(work.name)]
    rows = dict.fromkeys(row for work in listed for row in work.rows
                         if not (asked.quick and row.long))
    if not rows:
        sys.exit("table.py: no work has that in its name")
    rounds = Rounds(asked.tristim, rows, min_time=.02 if asked.quick else .1)
    began = machine()
    with tempfile.TemporaryDirectory() as scratch, contextlib.chdir(scratch):
        if any(row.command for row in rows):
            commands.make_pictures(asked.tristim, sizes)
        limit = 60 * asked.minutes - (time.monotonic() - start)
        count = run_rounds(rounds, limit, 1 if asked.quick else MOST_ROUNDS)
    report(asked, f"{began}; medians of {count} round{'s' * (count > 1)}", listed, rounds)
    return 1 if rounds.failed else 0


if __name__ == "__main__":
    sys.exit(main())
