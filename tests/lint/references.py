"""Every [Key] that a comment or a text cites has its entry in docs/references.md, and the reverse.

A key is a capitalised word of three letters or more in brackets, with a place behind it if need
be: [Smith78], [Shoaff 2.2.4], [Lam85, ICC.1 annex E]. An entry is a line of references.md that
begins with the key in brackets, behind list marks or emphasis.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEY = r"[A-Z][A-Za-z0-9.-]+[A-Za-z0-9]"
CITATION = re.compile(rf"(?<![\w\])])\[({KEY}(?:,? [^\[\]]*)?)\]")
ENTRY = re.compile(rf"^[\s*|_-]*\[({KEY})\]", re.MULTILINE)
IN_CODE = re.compile(r'//.*|"(?:\\.|[^"\\\n])*"')  # where C++ can cite: comments and texts


def keys_of(citation, entries):
    """The key that opens a citation, and entries that follow a comma in it."""
    parts = [part.split()[0] for part in citation.split(",") if part.strip()]
    return {parts[0]} | (set(parts[1:]) & entries)


def citations(file):
    text = file.read_text(encoding="utf-8")
    code = file.suffix in (".h", ".cpp")
    for number, line in enumerate(text.splitlines(), 1):
        for piece in IN_CODE.findall(line) if code else [line]:
            for match in CITATION.finditer(piece):
                yield number, match.group(1)


def main():
    page = ROOT / "docs/references.md"
    entries = ENTRY.findall(page.read_text(encoding="utf-8")) if page.exists() else []
    errors = [f"docs/references.md: two entries [{key}]"
              for key in sorted(set(entries)) if entries.count(key) > 1]
    cited = set()
    for top in ("include", "lib", "luts"):
        for file in sorted((ROOT / top).rglob("*")):
            if file.suffix not in (".h", ".cpp", ".toml", ".csv", ".md"):
                continue
            for number, citation in citations(file):
                for key in sorted(keys_of(citation, set(entries))):
                    cited.add(key)
                    if key not in entries:
                        errors.append(f"{file.relative_to(ROOT)}:{number}: [{key}] has no entry "
                                      "in docs/references.md")
    errors += [f"docs/references.md: nothing cites [{key}]; delete the entry"
               for key in sorted(set(entries) - cited)]
    print("\n".join(errors) or f"{len(cited)} keys, each cited and explained")
    return bool(errors)


sys.exit(main())
