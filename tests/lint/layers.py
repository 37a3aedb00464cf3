"""Who includes whom: modules form layers, headers stay light, codecs stay in io/."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

MAY_INCLUDE = {
    "core": "",
    "color": "core",
    "plot": "core color",
    "image": "core color",
    "measure": "core color image",
    "frame": "core color image",
    "device": "core color frame",  # a display contains a FrameLayout
    "lut": "core color device image",
    "palette": "core color image",
    "dither": "core color image palette",
    "pipeline": "core color image measure device palette dither frame lut",
    "light": "core color",
    "render": "core color image light",
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
OWN = re.compile(r"(?:tristim|lib)/(\w+)/(.*)")
HEAVY_STANDARD = {"iostream", "regex", "functional"}


def complaint(path, bracket, included):
    """What is wrong with one #include of one file, or None."""
    top, module = path.parts[0], path.parts[1 if path.parts[0] == "lib" else 2]
    public = top == "include"
    if public and (included in HEAVY_STANDARD or included.startswith("lib/")):
        return f"a public header may not include {included}"
    own = OWN.match(included)
    if own:
        target, rest = own.groups()
        if target not in MAY_INCLUDE:
            return f"{target} is no module; add it to tests/lint/layers.py"
        if target != module and target not in MAY_INCLUDE[module].split():
            return f"{module} may not include {target}"
        if rest.startswith("io/") and "io" not in path.parts:
            return f"only io/ may include {included}: tristim::tristim does not link tristim::io"
    elif bracket == '"' and not (included.startswith("luts/") and not public):
        return f'name {included} from the top: "tristim/..." or "lib/..."'
    elif public and bracket == "<" and re.search(r"[/.]", included) and included != "Eigen/Core":
        return f"a public header may not show {included}; put it behind a type of ours"
    return None


def main():
    files = sorted(p for top in ("include", "lib") for p in (ROOT / top).rglob("*")
                   if p.suffix in (".h", ".cpp"))
    errors = []
    for file in files:
        path = file.relative_to(ROOT)
        module = path.parts[1 if path.parts[0] == "lib" else 2]
        if module not in MAY_INCLUDE:
            errors.append(f"{path}: {module} is no module; add it to tests/lint/layers.py")
            continue
        text = file.read_text(encoding="utf-8")
        for match in INCLUDE.finditer(text):
            wrong = complaint(path, *match.groups())
            if wrong:
                line = text.count("\n", 0, match.start(1)) + 1
                errors.append(f"{path}:{line}: {wrong}")
    print("\n".join(errors) or f"{len(files)} files keep to their layers")
    return bool(errors) or not files


sys.exit(main())
