"""Sums a JUnit report of ctest in one line; ends with 1 unless all that ran has passed."""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def outcome(case):
    """passed, skipped or failed; what could not be started has failed."""
    if case.get("status") == "run":
        return "passed"
    skipped = case.find("skipped")
    if skipped is not None and "SKIP_" in skipped.get("message", ""):
        return "skipped"
    return "failed"


def main(report):
    cases = []
    if report.exists():
        cases = list(ElementTree.parse(report).getroot().iter("testcase"))
    outcomes = [outcome(case) for case in cases] or ["failed"]  # nothing ran: that is no success
    counts = {name: outcomes.count(name) for name in ("passed", "failed", "skipped")}
    line = f"{counts['passed']} passed, {counts['failed']} failed"
    if counts["skipped"]:
        line += f", {counts['skipped']} skipped"
    print(line)
    return counts["failed"] > 0


sys.exit(main(pathlib.Path(sys.argv[1])))
