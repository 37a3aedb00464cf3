"""What the table compares: works, each with the rows that do it. Only lists, nothing runs here."""

import dataclasses

PICTURE = 3840 * 2160
GROWTH = {"1 Mpixel": (1280, 800), "8 Mpixel": (3840, 2160), "33 Mpixel": (7680, 4320),
          "134 Mpixel": (16384, 8192)}


@dataclasses.dataclass(frozen=True)
class Row:
    """Who does a work: a measurement of a program in bench/, or a command."""

    who: str
    kind: str  # ours, peer, or floor: what memory allows
    threads: int = 1
    program: str = ""
    benchmark: str = ""  # its name in the program
    wrong: str = ""  # the name of the one that counts wrong codes
    command: tuple = ()  # run where the pictures are
    output: str = ""  # the file that it writes
    needs: str = ""  # the program that must be installed; default: the command's own
    long: bool = False  # too long for --quick


@dataclasses.dataclass(frozen=True)
class Work:
    name: str
    title: str
    rows: tuple
    pixels: int = PICTURE


def bench(kind, who, program, benchmark, **more):
    return Row(who, kind, program=program, benchmark=benchmark, **more)


def chain(name, kind, who, **more):
    """A row of chain.cpp, which calls its measurements by work and who."""
    return bench(kind, who, "chain", f"{name}/{who}", **more)


FLOOR = bench("floor", "floor: read floats, write bytes", "chain", "floor")
FLOOR_2 = bench("floor", "floor, 2 threads", "chain", "floor, 2 threads", threads=2)
COPY = bench("floor", "floor: copy", "lut", "copy/noise/1")
COPY_2 = bench("floor", "floor: copy, 2 threads", "lut", "copy/noise/2", threads=2)


def to_bytes(name, title, peers):
    def ours(who, threads):
        return chain(name, "ours", who, threads=threads,
                     wrong="wrong/tristim" if name == "W1" and threads == 1 else "")
    return Work(name, title, (FLOOR, FLOOR_2, ours("tristim", 1), ours("tristim, 2 threads", 2),
                              *(chain(name, "peer", who, wrong=f"wrong/{who}" if name == "W1" else "",
                                      long=who == "Little CMS") for who in peers)))


def growth(size, width, height):
    def row(kind, who, threads):
        return bench(kind, who, "chain", f"growth/{size}/{who}", threads=threads, long=width > 3840)
    return Work(f"W1, {size}", "", (
        row("floor", "floor", 1), row("floor", "floor, 2 threads", 2),
        row("ours", "tristim", 1), row("ours", "tristim, 2 threads", 2)), width * height)


IN_PROCESS = (
    to_bytes("W1", "linear float RGB, 3x3 matrix, clip, sRGB curve, 8 bits",
             ("zimg", "OpenColorIO", "OpenImageIO", "Little CMS", "powf")),
    to_bytes("W2", "W1 with an 8x8 ordered dither", ("zimg",)),
    to_bytes("W3", "W1 with Floyd-Steinberg; zimg's in encoded numbers", ("zimg",)),
    Work("W4", "33-point cube, tetrahedral, float to float, noise", (
        COPY, COPY_2,
        bench("ours", "tristim", "lut", "best/tetrahedral/noise/1"),
        bench("ours", "tristim, 2 threads", "lut", "best/tetrahedral/noise/2", threads=2),
        bench("peer", "OpenColorIO", "lut", "OpenColorIO/tetrahedral/noise/1"),
        bench("peer", "Little CMS", "lut", "Little CMS/tetrahedral/noise/1", long=True))),
    Work("W5", "RGB to HSV and back, float to float, noise", (
        bench("floor", "floor: copy", "color", "copy"),
        bench("ours", "tristim", "color", "hsv_round_trip"),
        bench("peer", "OpenColorIO", "color", "ocio_hsv_round_trip"),
        bench("peer", "plain loop", "color", "plain_hsv_round_trip"))),
    Work("ordered, 1 bit", "a channel, light in cache; zimg's in encoded numbers", (
        bench("ours", "tristim, blue noise", "dither", "ordered, 1 bit, best"),
        bench("peer", "zimg", "dither", "zimg_ordered/1"))),
    Work("ordered, 8 bits", "a channel", (
        bench("ours", "tristim, even in light", "dither", "ordered, 8 bits, even in light, best"),
        bench("ours", "tristim, sRGB, mixed in light", "dither", "ordered, 8 bits, sRGB, best"),
        bench("peer", "zimg", "dither", "zimg_ordered/8"))),
    Work("diffusion, 1 bit", "a channel, in light; zimg's in encoded numbers", (
        bench("ours", "tristim", "diffusion", "rows_together/bits1"),
        bench("peer", "zimg", "diffusion", "zimg_error_diffusion/bits1"))),
    Work("diffusion, 8 bits", "a channel", (
        bench("ours", "tristim", "diffusion", "rows_together/bits8"),
        bench("peer", "zimg", "diffusion", "zimg_error_diffusion/bits8"))),
    Work("diffusion, to a palette", "RGB, in light", (
        bench("ours", "tristim, 7 colours", "diffusion", "to_palette/colors7"),
        bench("ours", "tristim, 16 colours", "diffusion", "to_palette/colors16"),
        bench("ours", "tristim, 16 colours, 2 threads", "diffusion",
              "to_palette/colors16_two_threads", threads=2),
        bench("ours", "tristim, 256 colours", "diffusion", "to_palette/colors256"))),
    Work("ordered, to a palette", "RGB, in light", (
        bench("ours", "tristim, 7 colours", "dither", "ordered_to_palette/7"),
        bench("ours", "tristim, 16 colours", "dither", "ordered_to_palette/16"),
        bench("ours", "tristim, 256 colours", "dither", "ordered_to_palette/256"))),
    Work("mask", "void and cluster", tuple(
        bench("ours", f"tristim, {side}x{side}", "dither", f"blue_noise/{side}")
        for side in (128, 256, 512)), pixels=0),
    Work("palette of 256", "counted, chosen, and every pixel mapped where it says so", (
        bench("floor", "floor: copy", "palette", "copy"),
        bench("ours", "tristim, popularity", "palette", "choose/popularity"),
        bench("ours", "tristim, median cut", "palette", "choose/median_cut"),
        bench("ours", "tristim, best, and map", "palette", "best_and_map/2160"),
        bench("peer", "libimagequant, slowest, and map", "palette", "imagequant/1", long=True),
        bench("peer", "libimagequant, usual, and map", "palette", "imagequant/4", long=True),
        bench("peer", "libimagequant, fastest, and map", "palette", "imagequant/10"))),
    *(growth(size, *shape) for size, shape in GROWTH.items()),
)
