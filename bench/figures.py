"""From measurements to the table: medians, ratios, layout. Nothing here runs or reads anything."""

import dataclasses
import statistics

COLUMNS = ("wall ms", "cpu ms", "ns/px", "x floor", "x peer", "MiB", "MB out", "wrong")
WIDTH = 98  # of the text: the name, then eight columns
NAME_WIDTH = WIDTH - 8 * len(COLUMNS)


@dataclasses.dataclass(frozen=True)
class Sample:
    """One measurement, of everything that a row's work does once."""

    wall_ms: float
    cpu_ms: float
    mib: float | None = None  # peak memory
    out_mb: float | None = None  # size of the result
    wrong: float | None = None  # codes, where they are counted


def median_of(samples):
    """A sample of medians, figure by figure."""
    columns = zip(*(dataclasses.astuple(sample) for sample in samples))
    return Sample(*(statistics.median(known) if (known := [x for x in column if x is not None]) else None
                    for column in columns))


def time_of(row, sample):
    """What ratios are of: processor time where one thread works inside of a program, else wall time."""
    return sample.cpu_ms if row.benchmark and row.threads == 1 else sample.wall_ms


def lines_of(work, samples):
    """The rows of a work that were measured, each with its cells by COLUMNS."""
    medians = {row: median_of(samples[row]) for row in work.rows if samples.get(row)}
    times = {row: time_of(row, sample) for row, sample in medians.items()}
    floors = {row.threads: times[row] for row in times if row.kind == "floor"}
    best_peer = min((times[row] for row in times if row.kind == "peer"), default=None)
    lines = []
    for row, median in medians.items():
        floor = floors.get(row.threads)
        lines.append((row.who, (
            median.wall_ms, median.cpu_ms,
            times[row] * 1e6 / work.pixels if work.pixels else None,
            times[row] / floor if floor else None,
            times[row] / best_peer if best_peer and row.kind != "floor" else None,
            median.mib, median.out_mb, median.wrong)))
    return lines


def short(number):
    """Three digits: .532, 5.28, 14.4, 128, 13607."""
    if number is None:
        return ""
    if number == 0:
        return "0"
    digits = next((n for n, limit in enumerate((99.95, 9.995, .9995)) if number >= limit), 3)
    return f"{number:.{digits}f}".removeprefix("0") if number >= .0005 else f"{number:.0e}"


def cell_text(column, cell):
    return f"{cell:.0f}" if column == "wrong" and cell is not None else short(cell)


def as_text(works, samples):
    out = [" " * NAME_WIDTH + "".join(f"{name:>8}" for name in COLUMNS)]
    for work in works:
        lines = lines_of(work, samples)
        if not lines:
            continue
        out += ["", f"{work.name}  {work.title}".rstrip()]
        for who, cells in lines:
            row = f"  {who}".ljust(NAME_WIDTH) + "".join(
                f"{cell_text(column, cell):>8}" for column, cell in zip(COLUMNS, cells))
            out.append(row.rstrip())
    return "\n".join(out) + "\n"


def as_markdown(works, samples):
    out = ["| work | who | " + " | ".join(COLUMNS) + " |", "|---|---|" + "--:|" * len(COLUMNS)]
    for work in works:
        lines = lines_of(work, samples)
        if lines:
            out.append(f"| **{work.name}** | {work.title} |" + " |" * len(COLUMNS))
        for who, cells in lines:
            out.append(f"| | {who} | " + " | ".join(map(cell_text, COLUMNS, cells)) + " |")
    return "\n".join(out) + "\n"


def as_data(works, samples):
    """For --json: every measurement, and the cells of the table."""
    return [{"work": work.name, "title": work.title, "pixels": work.pixels,
             "rows": [{"who": who, **dict(zip(COLUMNS, cells))}
                      for who, cells in lines_of(work, samples)],
             "samples": {row.who: [dataclasses.asdict(sample) for sample in samples[row]]
                         for row in work.rows if samples.get(row)}}
            for work in works if lines_of(work, samples)]


def with_section(page, name, text):
    """`page` with `text` between the marks of a generated section. Raises ValueError without them."""
    begin, end = f"<!-- {name}: begin -->", f"<!-- {name}: end -->"
    head, found, rest = page.partition(begin)
    _, closed, tail = rest.partition(end)
    if not found or not closed:
        raise ValueError(f"there is no section {begin} ... {end}")
    return f"{head}{begin}\n{text.strip()}\n{end}{tail}"
