"""Whole commands: the pictures that they read, what tristim and its peers are called with, one run."""

import os
import resource
import shutil
import subprocess
import sys
import time

from figures import Sample
from works import GROWTH, PICTURE, Row, Work

CHUNK = 3 << 16  # bytes of whole RGB pixels: a child's peak counts what this process ever held


# Where Debian has the peers.
PACKAGES = {"vips": "libvips-tools", "oiiotool": "openimageio-tools", "gm": "graphicsmagick",
            "convert": "imagemagick", "pamditherbw": "netpbm",
            "python3 with PIL": "python3-pil"}


def first_of(*names):
    """The first of several names under which there is a program; the last one where there is none."""
    return next((name for name in names if shutil.which(name)), names[-1])


def python_with_pillow():
    """A Python that has it, else a name that no program has."""
    for python in (sys.executable, "/usr/bin/python3"):
        if shutil.which(python) and subprocess.run([python, "-c", "import PIL"], check=False,
                                                   stderr=subprocess.DEVNULL).returncode == 0:
            return python
    return "python3 with PIL"


CONVERT = first_of("convert-im6", "magick", "convert")
FFMPEG = ("ffmpeg", "-y", "-loglevel", "error")


def missing(row):
    """The program that a command needs and that is not installed, with its package; "" if it is."""
    program = row.needs or row.command[0]
    if shutil.which(program):
        return ""
    package = PACKAGES.get(program, program)
    return program if package == program else f"{program} ({package})"


def measure(command, output=""):
    """One run, None where it failed. A peak below this process's own cannot be told."""
    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    wall = time.monotonic() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        return None
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return Sample(wall_ms=1e3 * wall, cpu_ms=1e3 * (used.ru_utime + used.ru_stime),
                  mib=used.ru_maxrss / 1024 if used.ru_maxrss > own else None,
                  out_mb=os.path.getsize(output) / 1e6 if output else None)


def write_green(ppm, pgm):
    """The second channel of a PPM of 8 bits as a PGM."""
    with open(ppm, "rb") as colors, open(pgm, "wb") as grey:
        size = b"".join(colors.readline() for _ in range(3)).split()[1:]
        grey.write(b"P5\n%s %s\n%s\n" % tuple(size))
        while chunk := colors.read(CHUNK):
            grey.write(chunk[1::3])


def make_pictures(tristim, sizes):
    """Writes what the commands read into the working directory: <size>.exr, and of 8 Mpixel also
    true.png, true.ppm and grey.pgm."""
    picture = tristim.parent / "bench/picture"
    for size in sizes:
        width, height = GROWTH[size]
        subprocess.run([picture, f"{width}x{height}", exr(size)], check=True)
    for name in ("true.png", "true.ppm"):
        subprocess.run([tristim, "process", exr("8 Mpixel"), "-d", "srgb", "-o", name, "--quiet"],
                       check=True)
    write_green("true.ppm", "grey.pgm")


def exr(size):
    return size.replace(" ", "-") + ".exr"


def peer(who, output, *command, **more):
    return Row(who, "peer", command=command, output=output, **more)


def to_png(process):
    photo = exr("8 Mpixel")
    return Work("W6", "half EXR to 8-bit PNG", (
        process("tristim", photo, "a.png", "-d", "srgb", "--dither", "none", "--threads", "1"),
        process("tristim, 2 threads", photo, "a.png", "-d", "srgb", "--dither", "none", "--threads",
                "2", threads=2),
        process("tristim, 2 threads, bayer8", photo, "a.png", "-d", "srgb", "--dither", "bayer8",
                "--threads", "2", threads=2),
        peer("vips, PNG level 1", "a.png", "vips", "colourspace", photo, "a.png[compression=1]",
             "srgb", "--source-space", "scrgb"),
        peer("ffmpeg", "a.png", *FFMPEG, "-apply_trc", "iec61966_2_1", "-i", photo, "-pix_fmt",
             "rgb24", "a.png"),
        peer("oiiotool", "a.png", "oiiotool", photo, "--colorconvert", "linear", "srgb", "-d",
             "uint8", "-o", "a.png", long=True),
        peer("ImageMagick", "a.png", CONVERT, photo, "-set", "colorspace", "RGB", "-colorspace",
             "sRGB", "-depth", "8", "a.png", long=True)))


def growth(process, sizes):
    for size in sizes:
        width, height = GROWTH[size]
        long = width > 3840

        def to_png(threads):
            return process(f"tristim, {threads} thread{'s' * (threads > 1)}", exr(size), "a.png", "-d",
                           "srgb", "--dither", "bayer8", "--threads", str(threads), threads=threads,
                           long=long)
        yield Work(f"W6, {size}", "with bayer8; to 1 bit and PBM", (
            to_png(1), to_png(2),
            process("tristim, 1 bit, Floyd-Steinberg", exr(size), "a.pbm", "-d", "laser-300",
                    "--size", f"{width}x{height}", "--dither", "floyd-steinberg", long=long)),
                   width * height)


def ordered(process):
    return Work("1 bit, ordered", "grey PGM to PBM", (
        process("tristim, bayer8", "grey.pgm", "a.pbm", "-d", "laser-300", "--dither", "bayer8"),
        peer("ffmpeg", "a.pbm", *FFMPEG, "-i", "grey.pgm", "-vf", "scale=sws_dither=bayer,format=monob",
             "a.pbm"),
        peer("ImageMagick", "a.pbm", CONVERT, "grey.pgm", "-ordered-dither", "o8x8", "a.pbm"),
        peer("netpbm", "a.pbm", "sh", "-c", "pamditherbw -dither8 grey.pgm | pamtopnm > a.pbm",
             needs="pamditherbw")))


def diffused(process):
    return Work("1 bit, Floyd-Steinberg", "grey PGM to PBM", (
        process("tristim, in light", "grey.pgm", "a.pbm", "-d", "laser-300", "--dither",
                "floyd-steinberg"),
        peer("ffmpeg", "a.pbm", *FFMPEG, "-i", "grey.pgm", "-vf", "scale=sws_dither=ed,format=monob",
             "a.pbm"),
        peer("ImageMagick", "a.pbm", CONVERT, "grey.pgm", "-dither", "FloydSteinberg",
             "-monochrome", "a.pbm"),
        peer("GraphicsMagick", "a.pbm", "gm", "convert", "grey.pgm", "-monochrome", "a.pbm"),
        peer("netpbm", "a.pbm", "sh", "-c", "pamditherbw -floyd grey.pgm | pamtopnm > a.pbm",
             needs="pamditherbw"),
        peer("Pillow", "a.pbm", python_with_pillow(), "-c", "from PIL import Image; "
             "Image.open('grey.pgm').convert('1').save('a.pbm')")))


def rgb565(process):
    return Work("RGB 5-6-5, ordered", "RGB PPM to raw bytes", (
        process("tristim, bayer8", "true.ppm", "a.raw", "-d", "lcd-rgb565", "--size", "3840x2160",
                "--dither", "bayer8"),
        peer("ffmpeg", "a.raw", *FFMPEG, "-i", "true.ppm", "-sws_dither", "bayer", "-pix_fmt",
             "rgb565le", "-f", "rawvideo", "a.raw")))


def sixteen_colors(process):
    return Work("16 colours, Floyd-Steinberg", "chosen for an RGB PNG, to indexed PNG", (
        process("tristim", "true.png", "a.png", "-d", "srgb", "--palette", "best:16", "--dither",
                "floyd-steinberg"),
        peer("pngquant, usual speed", "a.png", "pngquant", "--force", "--output", "a.png", "16",
             "true.png"),
        peer("ffmpeg", "a.png", *FFMPEG, "-i", "true.png", "-lavfi",
             "split[a][b];[a]palettegen=max_colors=16:reserve_transparent=0[p];"
             "[b][p]paletteuse=dither=floyd_steinberg", "a.png"),
        peer("ImageMagick", "a.png", CONVERT, "true.png", "-dither", "FloydSteinberg", "-colors",
             "16", "PNG8:a.png", long=True)))


def many_colors(process):
    return Work("256 colours, no dither", "chosen for an RGB PNG, to indexed PNG", (
        process("tristim", "true.png", "a.png", "-d", "srgb", "--palette", "best:256", "--dither",
                "none"),
        peer("pngquant, slowest", "a.png", "pngquant", "--nofs", "--speed", "1", "--force",
             "--output", "a.png", "256", "true.png", long=True),
        peer("pngquant, fastest", "a.png", "pngquant", "--nofs", "--speed", "10", "--force",
             "--output", "a.png", "256", "true.png"),
        peer("ffmpeg", "a.png", *FFMPEG, "-i", "true.png", "-lavfi",
             "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none", "a.png"),
        peer("ImageMagick", "a.png", CONVERT, "true.png", "+dither", "-colors", "256", "PNG8:a.png",
             long=True),
        peer("Pillow", "a.png", python_with_pillow(), "-c", "from PIL import Image; Image.open('true.png')"
             ".convert('RGB').quantize(256, dither=Image.Dither.NONE).save('a.png')")))


def works(tristim, sizes=tuple(GROWTH)):
    """Every work that commands do."""
    def process(who, picture, output, *options, threads=0, long=False):
        return Row(who, "ours", threads, output=output, long=long,
                   command=(tristim, "process", picture, "-o", output, *options, "--quiet",
                            "--force"))
    return (
        to_png(process), *growth(process, sizes), ordered(process), diffused(process),
        rgb565(process), sixteen_colors(process), many_colors(process),
        Work("devices", "half EXR of 8 Mpixel, the device's own dither", tuple(
            process(device, exr("8 Mpixel"), "a.png", "-d", device, "--size", "3840x2160")
            for device in ("srgb", "laser-300", "epaper-4grey", "epaper-7color"))),
        Work("start", "", tuple(
            Row(" ".join(("tristim", *words)), "ours", command=(tristim, *words))
            for words in (("--help",), ("levels",), ("convert", "--to", "lab", "red"))), pixels=0))
