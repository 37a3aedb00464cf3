"""What README.md shows works: its commands run, its C++ compiles, its links lead somewhere.

Every line of an `sh` block that runs tristim is run, in the page's order, in one scratch
directory. An .exr that a line reads and nothing has made is made by `tristim render spheres`;
a block marked ```toml NAME becomes the file NAME; `luts` is the checkout's.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(\w+)[ \t]*(\S*)[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
RUNS_TRISTIM = re.compile(r"(?:^|[|;&]\s*)tristim\s")
INPUT = re.compile(r"(-o\s+|--output[ =]|>\s*)?([\w.%{}/-]+\.exr)\b")


def run(command, directory, environment):
    done = subprocess.run(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=120)
    if done.returncode == 0:
        return []
    shown = command[-1] if command[0] == "bash" else " ".join(command)
    return [f"`{shown}` ends with {done.returncode}: {done.stderr.strip()}"]


def run_commands(script, scratch, environment):
    errors = []
    for line in script.replace("\\\n", " ").splitlines():
        line = line.strip().removeprefix("$ ")
        if not RUNS_TRISTIM.search(line):
            continue
        for written, name in INPUT.findall(line):
            if not written and not (scratch / name).exists():
                errors += run(["tristim", "render", "spheres", "--size", "160x90", "-o", name],
                              scratch, environment)
        errors += run(["bash", "-o", "pipefail", "-c", line], scratch, environment)
    return errors


def check_pages(text, scratch, environment, compiler, eigen):
    errors = [f"a stranger is not told `{command}`"
              for command in ("make demo", "make test") if command not in text]
    errors += [f"the link {link} leads nowhere" for link in LINK.findall(text)
               if ":" not in link and not (ROOT / link).exists()]
    (scratch / "luts").symlink_to(ROOT / "luts")
    blocks = BLOCK.findall(text)
    for language, name, content in blocks:
        if language == "toml" and name:
            (scratch / name).write_text(content, encoding="utf-8")
    for language, _, content in blocks:
        if language == "sh":
            errors += run_commands(content, scratch, environment)
        elif language == "cpp":
            (scratch / "readme.cpp").write_text(content, encoding="utf-8")
            errors += run([compiler, "-std=c++20", "-Wall", "-Wextra", "-fsyntax-only",
                           "-I", str(ROOT / "include"), "-isystem", eigen,
                           "readme.cpp"], scratch, environment)
    return errors


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--command", type=pathlib.Path, required=True, help="the built tristim")
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--eigen", required=True, help="where its headers are")
    options = parser.parse_args()
    environment = dict(os.environ)
    environment["PATH"] = f"{options.command.resolve().parent}:{environment['PATH']}"
    page = ROOT / "README.md"
    if not page.exists():
        print("there is no README.md")
        return True
    with tempfile.TemporaryDirectory(prefix="tristim-readme-") as scratch:
        errors = check_pages(page.read_text(encoding="utf-8"), pathlib.Path(scratch), environment,
                             options.compiler, options.eigen)
    print("\n".join(f"README.md: {error}" for error in errors) or "README.md is true")
    return bool(errors)


sys.exit(main())
