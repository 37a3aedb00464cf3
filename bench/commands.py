#!/usr/bin/env python3
"""Whole commands side by side: wall time, processor time and peak memory, in turn, medians and ratios.

    bench/commands.py build/release/bin/tristim [RUNS]

Renders its pictures itself. Peers that are not installed are left out.
"""

import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time


def measure(command):
    """Wall seconds, processor seconds, peak MiB of one run."""
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    wall = time.monotonic() - start
    if status != 0:
        raise SystemExit(f"failed: {' '.join(map(str, command))}")
    return wall, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def compare(title, commands, runs):
    figures = {name: [] for name in commands}
    for command in commands.values():
        measure(command)  # warm up
    for _ in range(runs):
        for name, command in commands.items():  # in turn, so that a drift of the machine meets all
            figures[name].append(measure(command))
    print(f"\n{title}")
    print(f"  {'':24}{'wall s':>9}{'cpu s':>9}{'MiB':>9}{'wall, ratio':>13}{'MiB, ratio':>12}")
    first = None
    for name, rows in figures.items():
        wall, cpu, memory = (statistics.median(column) for column in zip(*rows))
        first = first or (wall, memory)
        print(f"  {name:24}{wall:9.3f}{cpu:9.3f}{memory:9.1f}{wall / first[0]:13.2f}"
              f"{memory / first[1]:12.2f}")


def palette_commands(tristim):
    """What makes indexed.png of true.png, which it makes first."""
    subprocess.run([tristim, "process", "spheres.exr", "-d", "srgb", "-o", "true.png", "--quiet"],
                   check=True)
    commands = {"tristim best": [tristim, "process", "true.png", "-d", "srgb", "--palette", "best:256",
                                 "--dither", "none", "-o", "indexed.png", "--quiet", "--force"],
                "tristim build": [tristim, "palette", "build", "true.png", "-n", "256"]}
    if shutil.which("pngquant"):
        commands["pngquant, slowest"] = ["pngquant", "--nofs", "--speed", "1", "--force", "--output",
                                         "indexed.png", "256", "true.png"]
    if shutil.which("convert"):
        commands["ImageMagick"] = ["convert", "true.png", "+dither", "-colors", "256",
                                   "PNG8:indexed.png"]
    if shutil.which("ffmpeg"):
        commands["ffmpeg"] = ["ffmpeg", "-y", "-i", "true.png", "-lavfi",
                              "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none",
                              "indexed.png"]
    pillow = [sys.executable, "-c", "from PIL import Image; Image.open('true.png').convert('RGB')"
              ".quantize(256, dither=Image.Dither.NONE).save('indexed.png')"]
    if subprocess.run([sys.executable, "-c", "import PIL"], stderr=subprocess.DEVNULL).returncode == 0:
        commands["Pillow"] = pillow
    return commands


def main():
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    tristim = str(pathlib.Path(sys.argv[1]).resolve())
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)
        subprocess.run([tristim, "render", "spheres", "--size", "3840x2160", "--samples", "4",
                        "-o", "spheres.exr"], check=True)
        process = [tristim, "process", "spheres.exr", "--quiet", "--force"]
        commands = {
            "tristim bayer8": process + ["-d", "srgb", "--dither", "bayer8", "-o", "a.png"],
            "tristim, one thread": process + ["-d", "srgb", "--dither", "bayer8", "-o", "b.png",
                                              "--threads", "1"],
        }
        if shutil.which("oiiotool"):
            commands["oiiotool, no dither"] = ["oiiotool", "spheres.exr", "--colorconvert",
                                               "linear", "srgb", "-d", "uint8", "-o", "c.png"]
        if shutil.which("vips"):
            commands["vips, no dither"] = ["vips", "copy", "spheres.exr", "d.png"]
        compare("3840x2160 half EXR to 8-bit PNG, level 6", commands, runs)
        compare("the same picture to devices", {
            device: process + ["-d", device, "-o", "e.png"]
            for device in ("srgb", "laser-300", "epaper-4grey", "epaper-7color")}, runs)
        compare("256 colours for 3840x2160 8-bit PNG, no dither", palette_commands(tristim), runs)
        compare("start", {"tristim --help": [tristim, "--help"],
                          "tristim levels": [tristim, "levels"],
                          "tristim convert": [tristim, "convert", "--to", "lab", "red"]}, runs)


if __name__ == "__main__":
    main()
