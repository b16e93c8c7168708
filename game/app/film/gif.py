"""GIF files in two passes: first the 256 colours that suit all pictures best, then the pictures in them."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from game.app.film.part_file import PartFile

PALETTE = "stats_mode=diff"
DITHER = "dither=bayer:bayer_scale=4:diff_mode=rectangle"


def write_gif(source: PartFile, target: PartFile, rate: int, av: Any) -> None:
    """A GIF from a film without loss. rate: pictures a second; av: PyAV. The packer's errors, or OSError."""
    palette = _palette_of(source, av)
    source.seek(0)
    with av.open(source) as taken, av.open(target, "w", format="gif") as out:
        stream = taken.streams.video[0]
        graph = av.filter.Graph()
        pictures = _source(graph, stream, rate)
        colors = graph.add_buffer(
            width=palette.width, height=palette.height, format=palette.format, time_base=Fraction(1, rate)
        )
        use, sink = graph.add("paletteuse", DITHER), graph.add("buffersink")
        pictures.link_to(use, 0, 0)
        colors.link_to(use, 0, 1)
        use.link_to(sink)
        graph.configure()
        palette.pts, palette.time_base = 0, Fraction(1, rate)
        colors.push(palette)
        colors.push(None)
        made = out.add_stream("gif", rate=rate)
        made.width, made.height, made.pix_fmt = stream.width, stream.height, "pal8"
        for number, frame in enumerate(taken.decode(stream)):
            frame.pts, frame.time_base = number, Fraction(1, rate)
            pictures.push(frame)
            _write_ready(sink, made, out, av)
        pictures.push(None)
        _write_ready(sink, made, out, av)
        for packet in made.encode():
            out.mux(packet)


def _write_ready(sink: Any, made: Any, out: Any, av: Any) -> None:
    """Encode all pictures that the filters have finished."""
    while True:
        try:
            frame = sink.pull()
        except (av.BlockingIOError, av.EOFError):
            return
        for packet in made.encode(frame):
            out.mux(packet)


def _palette_of(source: PartFile, av: Any) -> Any:
    """The picture of 256 colours."""
    source.seek(0)
    with av.open(source) as taken:
        stream = taken.streams.video[0]
        graph = av.filter.Graph()
        pictures = graph.add_buffer(template=stream)
        made, sink = graph.add("palettegen", PALETTE), graph.add("buffersink")
        pictures.link_to(made)
        made.link_to(sink)
        graph.configure()
        for frame in taken.decode(stream):
            pictures.push(frame)
        pictures.push(None)
        return sink.pull()


def _source(graph: Any, stream: Any, rate: int) -> Any:
    return graph.add_buffer(
        width=stream.width, height=stream.height, format=stream.codec_context.format,
        time_base=Fraction(1, rate),
    )  # fmt: skip
